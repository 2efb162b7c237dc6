# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files that cannot be used: name, bytes, and what is said behind "scene: error: FOLDER/NAME: "."""

from __future__ import annotations

import struct

POINTS = "0 0 0\n1 0 0\n0 1 0\n"
FACE = "3 0 1 2\n"
XYZ = "property float x\nproperty float y\nproperty float z\n"
LIST = "property list uchar int vertex_indices\n"
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


CORNERS = [0.0, 0, 0, 1, 0, 0, 0, 1, 0]
NAN = float("nan")
FACET = (0.0, 0, 1, *CORNERS)
DECAGON = "".join(f"{x} {x * x} 0\n" for x in range(10)) + "10 0 1 2 3 4 5 6 7 8 9\n"
CAMERA = "element camera 1\nproperty float angle\n"

# What many messages have in common.
DAMAGED = "it is cut short or damaged; export or copy it again"
NO_VERTEX = "names a vertex that is not there, it is damaged; export it again"
NOT_FINITE = (
    "1 vertex has coordinates that are NaN, infinite or beyond 3e38; remove them or export the mesh again"
)
NO_COUNTS = (
    "has no counts of vertices, faces and edges behind OFF (binary OFF is not read); export it again, as text"
)
NO_STL = "is neither ascii STL nor binary STL of 84 + 50 n bytes: it has"
CUT_STL = "it may be cut short, export or copy it again"
CORRECT = "correct it or export the mesh again"
ENDS = "ends within or cannot be read at"

MESHES = [
    # What is no mesh at all.
    ("empty.ply", b"", "is empty; export or copy it again"),
    ("empty.stl", b"", "is empty; export or copy it again"),
    ("line_end.obj", b"\n", "has no faces; it is no OBJ mesh or cut short, export it again"),
    (
        "letter.ply",
        b"Dear reader,\nthis is no mesh.\n",
        "is no PLY file, its first line is not 'ply'; export it again",
    ),
    (
        "letter.stl",
        b"Dear reader,\nthis is no mesh.\n",
        f"{NO_STL} 30 bytes; {CUT_STL}",
    ),
    (
        "letter.off",
        b"Dear reader,\nthis is no mesh.\n",
        "is no OFF file, it does not begin with OFF; export it again",
    ),
    (
        "letter.obj",
        b"Dear reader,\nthis is no mesh.\n",
        "has no faces; it is no OBJ mesh or cut short, export it again",
    ),
    ("picture.ply", PICTURE, "is no PLY file, its first line is not 'ply'; export it again"),
    (
        "picture.stl",
        PICTURE,
        f"{NO_STL} 272 bytes, its header declares 1128415552 triangles; {CUT_STL}",
    ),
    ("picture.off", PICTURE, "is no OFF file, it does not begin with OFF; export it again"),
    ("picture.obj", PICTURE, "is no text, so no OBJ file; export it again"),
    (
        "utf16.off",
        off("3 1 0", POINTS + FACE).decode().encode("utf-16"),
        "is no OFF file, it does not begin with OFF; export it again",
    ),
    ("mesh.xyz", POINTS.encode(), "has the unknown extension '.xyz'; use .ply, .stl, .obj or .off"),
    ("mesh", POINTS.encode(), "has no extension; use .ply, .stl, .obj or .off"),
    # Headers.
    (
        "no_end.ply",
        ply("").replace(b"end_header\n", b""),
        "its PLY header has no end, the file is cut short; export or copy it again",
    ),
    (
        "no_format.ply",
        ply(POINTS + FACE).replace(b"format ascii 1.0\n", b""),
        "its PLY header has no format line; export it again",
    ),
    (
        "morse.ply",
        ply(POINTS + FACE, form="morse"),
        f"its PLY header has the line 'format morse 1.0'; {CORRECT}",
    ),
    (
        "quad.ply",
        ply(POINTS + FACE, xyz="property quad x\n"),
        f"its PLY header has the line 'property quad x'; {CORRECT}",
    ),
    (
        "no_z.ply",
        ply("0 0\n1 0\n0 1\n" + FACE, xyz="property float x\nproperty float y\n"),
        "its PLY header has no vertices with x, y and z; export it again",
    ),
    (
        "no_list.ply",
        ply(POINTS + "0\n", corners="property int vertex_indices\n"),
        "its PLY faces have no list vertex_indices, or come before the vertices; export it again",
    ),
    (
        "faces_first.ply",
        f"ply\nformat ascii 1.0\nelement face 1\n{LIST}element vertex 3\n{XYZ}end_header\n{FACE}{POINTS}".encode(),
        "its PLY faces have no list vertex_indices, or come before the vertices; export it again",
    ),
    (
        "no_element.ply",
        ply(POINTS + FACE).replace(b"element vertex 3\n", b""),
        f"its PLY header has the line 'property float x'; {CORRECT}",
    ),
    (
        "no_properties.ply",
        ply(POINTS + FACE, xyz=""),
        "its PLY element 'vertex' has no properties; export it again",
    ),
    (
        "twice.ply",
        ply(POINTS + POINTS + FACE, between="element vertex 3\n" + XYZ),
        f"its PLY header has the line 'element vertex 3'; {CORRECT}",
    ),
    (
        "camera.ply",
        ply(POINTS + "30\n" + FACE, between=CAMERA),
        "could not be read right, it has unusual elements; triangulate it and export it as STL",
    ),
    (
        "binary.off",
        off("3 1 0", POINTS + FACE, "OFF BINARY"),
        NO_COUNTS,
    ),
    (
        "four.off",
        off("3 1 0", POINTS + FACE, "4OFF"),
        "is no OFF file, it does not begin with OFF; export it again",
    ),
    (
        "no_counts.off",
        b"OFF\n",
        NO_COUNTS,
    ),
    # Counts.
    (
        "vertex_less.ply",
        ply("0 0 0\n1 0 0\n" + FACE),
        f"{ENDS} face 0 of the 1 declared, {DAMAGED}",
    ),
    (
        "face_less.ply",
        ply(POINTS + FACE, faces=2),
        f"{ENDS} face 1 of the 2 declared, {DAMAGED}",
    ),
    (
        "vertex_less.off",
        off("4 1 0", POINTS + FACE),
        f"{ENDS} face 0 of the 1 declared, {DAMAGED}",
    ),
    (
        "face_less.off",
        off("3 2 0", POINTS + FACE),
        f"{ENDS} face 1 of the 2 declared, {DAMAGED}",
    ),
    (
        "triangle_less.stl",
        binary_stl(2, *FACET),
        f"{NO_STL} 134 bytes, its header declares 2 triangles; {CUT_STL}",
    ),
    (
        "triangle_more.stl",
        binary_stl(1, *FACET, *FACET),
        f"{NO_STL} 184 bytes, its header declares 1 triangles; {CUT_STL}",
    ),
    (
        "negative.ply",
        ply(POINTS + FACE, vertices=-3),
        f"its PLY header has the line 'element vertex -3'; {CORRECT}",
    ),
    (
        "negative.off",
        off("-3 1 0", POINTS + FACE),
        NO_COUNTS,
    ),
    (
        "huge.ply",
        ply(POINTS + FACE, vertices=4_000_000_000),
        f"{ENDS} vertex 4 of the 4000000000 declared, {DAMAGED}",
    ),
    (
        "huge_binary.ply",
        binary_ply(CORNERS, [0, 1, 2], vertices=9 * 10**18),
        f"{ENDS} vertex 4 of the 9000000000000000000 declared, {DAMAGED}",
    ),
    (
        "huge_big_endian.ply",
        binary_ply(CORNERS, [0, 1, 2], order="big", vertices=9 * 10**18),
        f"{ENDS} vertex 4 of the 9000000000000000000 declared, {DAMAGED}",
    ),
    (
        "huge_faces.ply",
        ply(POINTS + FACE, faces=4_000_000_000),
        f"{ENDS} face 1 of the 4000000000 declared, {DAMAGED}",
    ),
    (
        "beyond_63_bits.ply",
        ply(POINTS + FACE, vertices=2**64 - 1),
        f"its PLY header has the line 'element vertex 18446744073709551615'; {CORRECT}",
    ),
    (
        "beyond_64_bits.ply",
        ply(POINTS + FACE, vertices=2**64),
        f"its PLY header has the line 'element vertex 18446744073709551616'; {CORRECT}",
    ),
    (
        "huge_list.ply",
        ply(b"\xff" * 16 + bytes(44), 1, 1, "binary_little_endian", corners=LIST.replace("uchar", "uint")),
        f"{ENDS} face 0 of the 1 declared, {DAMAGED}",
    ),
    (
        "huge.stl",
        binary_stl(2**32 - 1, *FACET),
        f"{NO_STL} 134 bytes, its header declares 4294967295 triangles; {CUT_STL}",
    ),
    (
        "huge.off",
        off("4000000000 1 0", POINTS + FACE),
        f"{ENDS} vertex 4 of the 4000000000 declared, {DAMAGED}",
    ),
    (
        "huge_faces.off",
        off("3 4000000000 0", POINTS + FACE),
        f"{ENDS} face 1 of the 4000000000 declared, {DAMAGED}",
    ),
    ("no_faces.ply", ply(POINTS, faces=0), "has no faces, only points; triangulate the surface first"),
    ("only_lines.ply", ply(POINTS + "2 0 1\n"), "has no faces, only points; triangulate the surface first"),
    (
        "only_lines.off",
        off("3 1 0", POINTS + "2 0 1\n"),
        "has no faces, only points; triangulate the surface first",
    ),
    ("no_faces.stl", binary_stl(0), "has no faces; export the surface again"),
    ("no_facets.stl", b"solid nothing\nendsolid nothing\n", "has no faces; export the surface again"),
    ("no_faces.off", off("3 0 0", POINTS), "has no faces, only points; triangulate the surface first"),
    ("no_faces.obj", obj(""), "has no faces; it is no OBJ mesh or cut short, export it again"),
    # Cut short, and lines that are wrong.
    (
        "cut.ply",
        binary_ply(CORNERS, [0, 1, 2])[:-1],
        f"{ENDS} face 0 of the 1 declared, {DAMAGED}",
    ),
    (
        "cut.stl",
        binary_stl(1, *FACET)[:-1],
        f"{NO_STL} 133 bytes, its header declares 1 triangles; {CUT_STL}",
    ),
    (
        "no_endsolid.stl",
        ascii_stl(["0 0 0", "1 0 0", "0 1 0"], end=""),
        "has no endsolid, it is cut short; export or copy it again",
    ),
    (
        "two_vertices.stl",
        ascii_stl(["0 0 0", "1 0 0"]),
        f"{ENDS} facet 0, {DAMAGED}",
    ),
    (
        "two_corners.obj",
        obj("f 1 2\n"),
        f"line 4 is no complete vertex or face, {DAMAGED}",
    ),
    (
        "cut.obj",
        obj("f 1 2 3\nv 1 1", points=("0 0 0", "1 0 0", "0 1 0")),
        f"line 5 is no complete vertex or face, {DAMAGED}",
    ),
    (
        "unused.obj",
        obj("f 1 2 3", points=("0 0 0", "1 0 0", "0 1 0", "1 1 0")),
        "its last line has no end and some vertices have no face, it is cut short; export or copy it again",
    ),
    # Indices.
    (
        "index.ply",
        ply(POINTS + "3 0 1 3\n"),
        f"face 0 {NO_VERTEX}",
    ),
    (
        "index_negative.ply",
        ply(POINTS + "3 0 1 -1\n"),
        f"face 0 {NO_VERTEX}",
    ),
    (
        "index_2_32.ply",
        ply(POINTS + "3 0 1 4294967296\n"),
        f"face 0 {NO_VERTEX}",
    ),
    (
        "index_half.ply",
        ply(POINTS + "3 0 1 1.5\n"),
        f"face 0 {NO_VERTEX}",
    ),
    (
        "index_binary.ply",
        binary_ply(CORNERS, [0, 1, -1]),
        f"face 0 {NO_VERTEX}",
    ),
    (
        "four_corners.ply",
        ply(POINTS + "4 0 1 2 3\n"),
        f"face 0 {NO_VERTEX}",
    ),
    (
        "corners_negative.ply",
        ply(POINTS + "-3 0 1 2\n"),
        f"{ENDS} face 0 of the 1 declared, {DAMAGED}",
    ),
    (
        "index.off",
        off("3 1 0", POINTS + "3 0 1 3\n"),
        f"face 0 {NO_VERTEX}",
    ),
    (
        "index_negative.off",
        off("3 1 0", POINTS + "3 0 1 -1\n"),
        f"face 0 {NO_VERTEX}",
    ),
    (
        "four_corners.off",
        off("3 1 0", POINTS + "4 0 1 2 3\n"),
        f"face 0 {NO_VERTEX}",
    ),
    (
        "corners_negative.off",
        off("3 1 0", POINTS + "-3 0 1 2\n"),
        f"{ENDS} face 0 of the 1 declared, {DAMAGED}",
    ),
    (
        "index_0.obj",
        obj("f 1 2 0\n"),
        f"a face {NO_VERTEX}",
    ),
    (
        "index_4.obj",
        obj("f 1 2 4\n"),
        f"a face {NO_VERTEX}",
    ),
    (
        "index_back.obj",
        obj("f 1 2 -4\n"),
        f"line 4 is no complete vertex or face, {DAMAGED}",
    ),
    (
        "index_20_digits.obj",
        obj("f 1 2 99999999999999999999\n"),
        f"line 4 is no complete vertex or face, {DAMAGED}",
    ),
    # Coordinates.
    (
        "nan.ply",
        ply("0 0 nan\n1 0 0\n0 1 0\n" + FACE),
        NOT_FINITE,
    ),
    (
        "nan_binary.ply",
        binary_ply([NAN, *CORNERS[1:]], [0, 1, 2]),
        NOT_FINITE,
    ),
    (
        "infinite.ply",
        ply("0 0 -inf\n1 0 0\n0 1 0\n" + FACE),
        NOT_FINITE,
    ),
    (
        "beyond_float.ply",
        ply("0 0 1e39\n1 0 0\n0 1 0\n" + FACE),
        NOT_FINITE,
    ),
    (
        "word.ply",
        ply("0 0 zero\n1 0 0\n0 1 0\n" + FACE),
        f"{ENDS} vertex 0 of the 3 declared, {DAMAGED}",
    ),
    (
        "hexadecimal.ply",
        ply("0 0 0x1p3\n1 0 0\n0 1 0\n" + FACE),
        f"{ENDS} vertex 0 of the 3 declared, {DAMAGED}",
    ),
    (
        "comma.off",
        off("3 1 0", "0,5 0 0\n1 0 0\n0 1 0\n" + FACE),
        f"{ENDS} vertex 0 of the 3 declared, {DAMAGED}",
    ),
    (
        "nan.stl",
        binary_stl(1, 0, 0, 1, NAN, *CORNERS[1:]),
        NOT_FINITE,
    ),
    (
        "infinite.stl",
        binary_stl(1, 0, 0, 1, float("inf"), *CORNERS[1:]),
        NOT_FINITE,
    ),
    (
        "word.stl",
        ascii_stl(["0 0 zero", "1 0 0", "0 1 0"]),
        f"{ENDS} facet 0, {DAMAGED}",
    ),
    (
        "nan.off",
        off("3 1 0", "0 0 nan\n1 0 0\n0 1 0\n" + FACE),
        NOT_FINITE,
    ),
    (
        "infinite.off",
        off("3 1 0", "0 0 inf\n1 0 0\n0 1 0\n" + FACE),
        NOT_FINITE,
    ),
    (
        "beyond_double.off",
        off("3 1 0", "0 0 1e999\n1 0 0\n0 1 0\n" + FACE),
        NOT_FINITE,
    ),
    (
        "nan.obj",
        obj("f 1 2 3\n", points=("0 0 NaN", "1 0 0", "0 1 0")),
        NOT_FINITE,
    ),
    (
        "beyond_float.obj",
        obj("f 1 2 3\n", points=("0 0 1e39", "1 0 0", "0 1 0")),
        NOT_FINITE,
    ),
    (
        "word.obj",
        obj("f 1 2 3\n", points=("0 0 zero", "1 0 0", "0 1 0")),
        f"line 1 is no complete vertex or face, {DAMAGED}",
    ),
    # Shapes.
    (
        "collinear.off",
        off("3 1 0", "0 0 0\n1 1 1\n3 3 3\n" + FACE),
        "none of its faces has an area; export the surface again",
    ),
    ("one_point.stl", binary_stl(1, *[0.0] * 12), "none of its faces has an area; export the surface again"),
    (
        "ten_corners.off",
        off("10 1 0", DECAGON),
        "only 0 of its 1 faces could be read; triangulate it and export it as STL",
    ),
]
