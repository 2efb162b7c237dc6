# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files that cannot be used: name, bytes, and what is said behind "impinge: error: FOLDER/NAME: "."""

from __future__ import annotations

import struct

POINTS = "0 0 0\n1 0 0\n0 1 0\n"
FACE = "3 0 1 2\n"
XYZ = "property float x\nproperty float y\nproperty float z\n"
LIST = "property list uchar int vertex_indices\n"
NO_EAR = """2.98336315 0.719962776 0|5.30887794 -1.87525618 2.55916095|7.63439226 -4.4704752 5.1183219|3.59800982 -6.43859148 5.92426157
-0.438372791 -8.40670776 6.73020124|-3.52984619 -6.42493868 4.51854372|-6.62131929 -4.44317007 2.3068862|-9.27420998 -1.51806283 -0.583795905
-11.9271002 1.40704441 -3.47447801|-8.48332119 5.0468421 -5.75172997|-5.03954124 8.68663883 -8.02898216|-1.37290263 6.14264536 -5.24894667
2.29373622 3.59865165 -2.46891165|2.63854957 2.15930724 -1.23445582""".replace("\n", "|").split("|")
PICTURE = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + bytes(range(256))


def ply(body: str | bytes, vertices=3, faces=1, form="ascii", xyz=XYZ, corners=LIST, between="") -> bytes:
    """A PLY file whose header declares what it is told to."""
    header = (
        f"ply\nformat {form} 1.0\nelement vertex {vertices}\n{xyz}{between}element face {faces}\n{corners}"
    )
    return f"{header}end_header\n".encode() + (body if isinstance(body, bytes) else body.encode())


def binary_ply(points: list[float], corners: list[int], order="little", **header) -> bytes:
    """One triangle."""
    mark = "<" if order == "little" else ">"
    body = struct.pack(f"{mark}9f", *points) + struct.pack(f"{mark}B3i", 3, *corners)
    return ply(body, form=f"binary_{order}_endian", **header)


def binary_stl(triangles: int, *floats: float) -> bytes:
    """The declared number of triangles, then one for every twelve numbers."""
    bodies = [struct.pack("<12fH", *floats[i : i + 12], 0) for i in range(0, len(floats), 12)]
    return b"by a test".ljust(80) + struct.pack("<I", triangles) + b"".join(bodies)


def ascii_stl(vertices: list[str], end="endsolid\n") -> bytes:
    """One facet."""
    lines = "".join(f"vertex {vertex}\n" for vertex in vertices)
    return f"solid\nfacet normal 0 0 1\nouter loop\n{lines}endloop\nendfacet\n{end}".encode()


def off(counts: str, body: str, keyword="OFF") -> bytes:
    """Keyword, counts, body."""
    return f"{keyword}\n{counts}\n{body}".encode()


def obj(face: str, points=("0 0 0", "1 0 0", "0 1 0")) -> bytes:
    """Three vertices and what follows."""
    return ("".join(f"v {point}\n" for point in points) + face).encode()


def vtk(body: str, head="3.0", kind="ASCII", data="POLYDATA") -> bytes:
    """A legacy file of VTK."""
    return f"# vtk DataFile Version {head}\na title\n{kind}\nDATASET {data}\n{body}".encode()


def vtp(points=POINTS, corners="0 1 2", ends="3", attributes="", kind="PolyData", form="ascii") -> bytes:
    """One triangle in XML."""
    arrays = {"Points": [("Points", points)], "Polys": [("connectivity", corners), ("offsets", ends)]}
    inside = "".join(
        f"<{of}>" + "".join(f"<DataArray type='Float64' Name='{name}' format='{form}'>{text}</DataArray>" for name, text in named) + f"</{of}>"
        for of, named in arrays.items()
    )
    piece = f"<Piece NumberOfPoints='3' NumberOfPolys='1'>{inside}</Piece>"
    return f"<VTKFile type='{kind}'{attributes}><{kind}>{piece}</{kind}></VTKFile>".encode()


CORNERS = [0.0, 0, 0, 1, 0, 0, 0, 1, 0]
NAN = float("nan")
FACET = (0.0, 0, 1, *CORNERS)
DECAGON = "".join(f"{x} {x * x} 0\n" for x in range(10)) + "10 0 1 2 3 4 5 6 7 8 9\n"
CAMERA = "element camera 1\nproperty float angle\n"

VTK_POINTS = f"POINTS 3 float\n{POINTS}"
EXTRACT = "extract the surface, in ParaView with Extract Surface, and save it as"
DAMAGED = "it is cut short or damaged; export or copy it again"
NOTHING = b"Dear reader,\nthis is no mesh.\n"


def ends(where: str) -> str:
    """A body that is shorter than its header says, or has something else in it."""
    return f"ends within or cannot be read at {where}, {DAMAGED}"


def line(text: str) -> str:
    """A line of a PLY header that says nothing."""
    return f"its PLY header has the line '{text}'; correct it or export the mesh again"


def no_stl(size: int, declared: int | None = None) -> str:
    """A file that has another size than its header says."""
    said = "" if declared is None else f", its header declares {declared} triangles"
    return f"is neither ascii STL nor binary STL of 84 + 50 n bytes: it has {size} bytes{said}; it may be cut short, export or copy it again"


# By what is said.
REFUSED = {
    "is empty; export or copy it again": {"empty.ply": b"", "empty.stl": b""},
    # What is no mesh at all.
    "has no faces; it is no OBJ mesh or cut short, export it again": {
        "line_end.obj": b"\n",
        "letter.obj": NOTHING,
        "no_faces.obj": obj(""),
    },
    "is no PLY file, its first line is not 'ply'; export it again": {"letter.ply": NOTHING, "picture.ply": PICTURE},
    no_stl(30): {"letter.stl": NOTHING},
    no_stl(272, 1128415552): {"picture.stl": PICTURE},
    "is no OFF file, it does not begin with OFF; export it again": {
        "letter.off": NOTHING,
        "picture.off": PICTURE,
        "utf16.off": off("3 1 0", POINTS + FACE).decode().encode("utf-16"),
        "four.off": off("3 1 0", POINTS + FACE, "4OFF"),
    },
    "is no text, so no OBJ file; export it again": {"picture.obj": PICTURE},
    "has the unknown extension '.xyz'; use .ply, .stl, .obj, .off, .vtp or .vtk": {"mesh.xyz": POINTS.encode()},
    "has no extension; use .ply, .stl, .obj, .off, .vtp or .vtk": {"mesh": POINTS.encode()},
    # Headers.
    "its PLY header has no end, the file is cut short; export or copy it again": {"no_end.ply": ply("").replace(b"end_header\n", b"")},
    "its PLY header has no format line; export it again": {"no_format.ply": ply(POINTS + FACE).replace(b"format ascii 1.0\n", b"")},
    line("format morse 1.0"): {"morse.ply": ply(POINTS + FACE, form="morse")},
    line("property quad x"): {"quad.ply": ply(POINTS + FACE, xyz="property quad x\n")},
    line("property float x"): {"no_element.ply": ply(POINTS + FACE).replace(b"element vertex 3\n", b"")},
    line("element vertex 3"): {"twice.ply": ply(POINTS + POINTS + FACE, between="element vertex 3\n" + XYZ)},
    line("element vertex -3"): {"negative.ply": ply(POINTS + FACE, vertices=-3)},
    line("element vertex 18446744073709551615"): {"beyond_63_bits.ply": ply(POINTS + FACE, vertices=2**64 - 1)},
    line("element vertex 18446744073709551616"): {"beyond_64_bits.ply": ply(POINTS + FACE, vertices=2**64)},
    "its PLY header has no vertices with x, y and z; export it again": {
        "no_z.ply": ply("0 0\n1 0\n0 1\n" + FACE, xyz="property float x\nproperty float y\n"),
    },
    "its PLY faces have no list vertex_indices, or come before the vertices; export it again": {
        "no_list.ply": ply(POINTS + "0\n", corners="property int vertex_indices\n"),
        "faces_first.ply": (f"ply\nformat ascii 1.0\nelement face 1\n{LIST}element vertex 3\n{XYZ}end_header\n{FACE}{POINTS}").encode(),
    },
    "its PLY element 'vertex' has no properties; export it again": {"no_properties.ply": ply(POINTS + FACE, xyz="")},
    "could not be read right, it has unusual elements; triangulate it and export it as STL": {
        "camera.ply": ply(POINTS + "30\n" + FACE, between=CAMERA),
    },
    "has no counts of vertices, faces and edges behind OFF (binary OFF is not read); export it again, as text": {
        "binary.off": off("3 1 0", POINTS + FACE, "OFF BINARY"),
        "no_counts.off": b"OFF\n",
        "negative.off": off("-3 1 0", POINTS + FACE),
    },
    # assimp finds no ear of this flat polygon and leaves three triangles out.
    "has polygons that cannot be triangulated; triangulate it and export it again": {
        "no_ear.obj": obj("f 1 2 3 4 5 6 7 8 9 10 11 12 13 14\n", NO_EAR),
    },
    # Files of VTK.
    "is no VTP file, or cut short: its end is not </VTKFile>; export or copy it again": {
        "letter.vtp": NOTHING,
        "picture.vtp": PICTURE,
        "cut.vtp": vtp()[:-1],
    },
    f"is no XML, Start-end tags mismatch, {DAMAGED}": {"tags.vtp": b"<VTKFile><PolyData></VTKFile>"},
    f"holds no PolyData of VTK; {EXTRACT} .vtp": {"grid.vtp": vtp(kind="UnstructuredGrid")},
    "is compressed by vtkLZ4DataCompressor; save it with ZLib, or uncompressed": {"lz4.vtp": vtp(attributes=" compressor='vtkLZ4DataCompressor'")},
    f"not all of its 3 points are there, {DAMAGED}": {"points.vtp": vtp(points="0 0 0 1 0 0")},
    f"not all of its 1 Polys are there, {DAMAGED}": {"ends.vtp": vtp(ends="2"), "corners.vtp": vtp(corners="0 1"), "ends_2.vtp": vtp(ends="1 3")},
    f"its array Points has a word that is no number, {DAMAGED}": {"word.vtp": vtp(points="0 0 zero")},
    f"its array Points is not whole, {DAMAGED}": {
        "base64.vtp": vtp(form="binary"),
        "huge.vtp": vtp(points="////fwAAAAA=", form="binary"),
        "packed.vtp": vtp(points="AQAAACQAAAAAAAAABAAAAA==AAAAAA==", form="binary", attributes=" compressor='vtkZLibDataCompressor'"),
        "no_data.vtp": vtp(form="appended"),
    },
    "is no legacy VTK file, its first line is not '# vtk DataFile Version'; export it again, or name it .vtp if it is XML": {
        "letter.vtk": NOTHING,
        "xml.vtk": vtp(),
    },
    f"holds structured_points, not POLYDATA; {EXTRACT} .vtp or .vtk": {"image.vtk": vtk("DIMENSIONS 1 1 1\n", data="STRUCTURED_POINTS")},
    ends("the word ASCII or BINARY"): {"morse.vtk": vtk(VTK_POINTS, kind="MORSE")},
    ends("points"): {
        "word.vtk": vtk("POINTS 3 float\n0 0 zero 1 0 0 0 1 0\n"),
        "point_less.vtk": vtk("POINTS 3 float\n0 0 0 1 0 0\n"),
        "huge.vtk": vtk("POINTS 9000000000000000000 double\n0 0 0\n"),
        "binary.vtk": vtk("POINTS 3 float\n0 0 0 1 0 0", kind="BINARY"),
    },
    ends("polygons"): {
        "face_less.vtk": vtk(VTK_POINTS + "POLYGONS 2 8\n3 0 1 2\n"),
        "corner_less.vtk": vtk(VTK_POINTS + "POLYGONS 1 3\n3 0 1\n"),
        "more.vtk": vtk(VTK_POINTS + "POLYGONS 1 5\n3 0 1 2 2\n"),
    },
    ends("a list of faces"): {
        "ends.vtk": vtk(VTK_POINTS + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 2\nCONNECTIVITY vtktypeint64\n0 1 2\n", head="5.1"),
    },
    # Counts, and files that are cut short.
    ends("face 0 of the 1 declared"): {
        "vertex_less.ply": ply("0 0 0\n1 0 0\n" + FACE),
        "vertex_less.off": off("4 1 0", POINTS + FACE),
        "huge_list.ply": ply(b"\xff" * 16 + bytes(44), 1, 1, "binary_little_endian", corners=LIST.replace("uchar", "uint")),
        "cut.ply": binary_ply(CORNERS, [0, 1, 2])[:-1],
        "corners_negative.ply": ply(POINTS + "-3 0 1 2\n"),
        "corners_negative.off": off("3 1 0", POINTS + "-3 0 1 2\n"),
    },
    ends("face 1 of the 2 declared"): {
        "face_less.ply": ply(POINTS + FACE, faces=2),
        "face_less.off": off("3 2 0", POINTS + FACE),
    },
    ends("vertex 4 of the 4000000000 declared"): {
        "huge.ply": ply(POINTS + FACE, vertices=4_000_000_000),
        "huge.off": off("4000000000 1 0", POINTS + FACE),
    },
    ends("vertex 4 of the 9000000000000000000 declared"): {
        "huge_binary.ply": binary_ply(CORNERS, [0, 1, 2], vertices=9 * 10**18),
        "huge_big_endian.ply": binary_ply(CORNERS, [0, 1, 2], order="big", vertices=9 * 10**18),
    },
    ends("face 1 of the 4000000000 declared"): {
        "huge_faces.ply": ply(POINTS + FACE, faces=4_000_000_000),
        "huge_faces.off": off("3 4000000000 0", POINTS + FACE),
    },
    no_stl(134, 2): {"triangle_less.stl": binary_stl(2, *FACET)},
    no_stl(184, 1): {"triangle_more.stl": binary_stl(1, *FACET, *FACET)},
    no_stl(134, 4294967295): {"huge.stl": binary_stl(2**32 - 1, *FACET)},
    no_stl(133, 1): {"cut.stl": binary_stl(1, *FACET)[:-1]},
    "has no faces, only points; triangulate the surface first": {
        "no_faces.ply": ply(POINTS, faces=0),
        "only_lines.ply": ply(POINTS + "2 0 1\n"),
        "only_lines.off": off("3 1 0", POINTS + "2 0 1\n"),
        "no_faces.off": off("3 0 0", POINTS),
        "no_faces.vtk": vtk(VTK_POINTS),
        "only_lines.vtk": vtk(VTK_POINTS + "LINES 1 3\n2 0 1\n"),
    },
    "has no faces; export the surface again": {
        "no_faces.stl": binary_stl(0),
        "no_facets.stl": b"solid nothing\nendsolid nothing\n",
    },
    "has no endsolid, it is cut short; export or copy it again": {"no_endsolid.stl": ascii_stl(["0 0 0", "1 0 0", "0 1 0"], end="")},
    ends("facet 0"): {
        "two_vertices.stl": ascii_stl(["0 0 0", "1 0 0"]),
        "word.stl": ascii_stl(["0 0 zero", "1 0 0", "0 1 0"]),
    },
    f"line 1 is no complete vertex or face, {DAMAGED}": {"word.obj": obj("f 1 2 3\n", points=("0 0 zero", "1 0 0", "0 1 0"))},
    f"line 4 is no complete vertex or face, {DAMAGED}": {
        "two_corners.obj": obj("f 1 2\n"),
        "index_back.obj": obj("f 1 2 -4\n"),
        "index_20_digits.obj": obj("f 1 2 99999999999999999999\n"),
    },
    f"line 5 is no complete vertex or face, {DAMAGED}": {"cut.obj": obj("f 1 2 3\nv 1 1")},
    "its last line has no end and some vertices have no face, it is cut short; export or copy it again": {
        "unused.obj": obj("f 1 2 3", points=("0 0 0", "1 0 0", "0 1 0", "1 1 0")),
    },
    # Indices.
    "face 0 names a vertex that is not there, it is damaged; export it again": {
        "index.ply": ply(POINTS + "3 0 1 3\n"),
        "index_negative.ply": ply(POINTS + "3 0 1 -1\n"),
        "index_2_32.ply": ply(POINTS + "3 0 1 4294967296\n"),
        "index_half.ply": ply(POINTS + "3 0 1 1.5\n"),
        "index_binary.ply": binary_ply(CORNERS, [0, 1, -1]),
        "four_corners.ply": ply(POINTS + "4 0 1 2 3\n"),
        "index.off": off("3 1 0", POINTS + "3 0 1 3\n"),
        "index_negative.off": off("3 1 0", POINTS + "3 0 1 -1\n"),
        "four_corners.off": off("3 1 0", POINTS + "4 0 1 2 3\n"),
        "index.vtp": vtp(corners="0 1 3"),
        "index_negative.vtp": vtp(corners="0 1 -1"),
        "index_half.vtp": vtp(corners="0 1 1.5"),
        "index.vtk": vtk(VTK_POINTS + "POLYGONS 1 4\n3 0 1 4294967298\n"),
    },
    "a face names a vertex that is not there, it is damaged; export it again": {
        "index_0.obj": obj("f 1 2 0\n"),
        "index_4.obj": obj("f 1 2 4\n"),
    },
    # Coordinates.
    "1 vertex has coordinates that are NaN, infinite or beyond 3e38; remove them or export the mesh again": {
        "nan.ply": ply("0 0 nan\n1 0 0\n0 1 0\n" + FACE),
        "nan_binary.ply": binary_ply([NAN, *CORNERS[1:]], [0, 1, 2]),
        "infinite.ply": ply("0 0 -inf\n1 0 0\n0 1 0\n" + FACE),
        "beyond_float.ply": ply("0 0 1e39\n1 0 0\n0 1 0\n" + FACE),
        "nan.stl": binary_stl(1, 0, 0, 1, NAN, *CORNERS[1:]),
        "infinite.stl": binary_stl(1, 0, 0, 1, float("inf"), *CORNERS[1:]),
        "nan.off": off("3 1 0", "0 0 nan\n1 0 0\n0 1 0\n" + FACE),
        "infinite.off": off("3 1 0", "0 0 inf\n1 0 0\n0 1 0\n" + FACE),
        "beyond_double.off": off("3 1 0", "0 0 1e999\n1 0 0\n0 1 0\n" + FACE),
        "nan.vtp": vtp(points="0 0 nan 1 0 0 0 1 0"),
        "beyond_float.vtk": vtk("POINTS 3 double\n0 0 1e39 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n"),
        "nan.obj": obj("f 1 2 3\n", points=("0 0 NaN", "1 0 0", "0 1 0")),
        "beyond_float.obj": obj("f 1 2 3\n", points=("0 0 1e39", "1 0 0", "0 1 0")),
    },
    ends("vertex 0 of the 3 declared"): {
        "word.ply": ply("0 0 zero\n1 0 0\n0 1 0\n" + FACE),
        "hexadecimal.ply": ply("0 0 0x1p3\n1 0 0\n0 1 0\n" + FACE),
        "comma.off": off("3 1 0", "0,5 0 0\n1 0 0\n0 1 0\n" + FACE),
    },
    # Shapes.
    "none of its faces has an area; export the surface again": {
        "collinear.off": off("3 1 0", "0 0 0\n1 1 1\n3 3 3\n" + FACE),
        "one_point.stl": binary_stl(1, *[0.0] * 12),
    },
    "only 0 of its 1 faces could be read; triangulate it and export it as STL": {"ten_corners.off": off("10 1 0", DECAGON)},
}

MESHES = [(name, content, message) for message, files in REFUSED.items() for name, content in files.items()]
