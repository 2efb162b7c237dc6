# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files that VTK writes are read, and VTK reads those of the program: places, faces, values and frame."""
import itertools
import math

import impinge
import numpy as np
import pytest
from shared import asked, program, sphere, table
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkStripper
from vtkmodules.vtkFiltersParallel import vtkExtractPolyDataPiece
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

READERS = {"ply": vtkPLYReader, "stl": vtkSTLReader, "obj": vtkOBJReader, "vtp": vtkXMLPolyDataReader, "vtk": vtkPolyDataReader}


def poly_data(vertices, faces, kind="<f8"):
    """With values of the vertices and a name, as users' files have them."""
    points, cells, data, title = vtkPoints(), vtkCellArray(), vtkPolyData(), vtkStringArray()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(vertices, kind), deep=True))
    cells.SetCells(len(faces), numpy_to_vtkIdTypeArray(np.hstack([np.full((len(faces), 1), 3), faces]).astype(np.int64).ravel(), deep=True))
    data.SetPoints(points)
    data.SetPolys(cells)
    values = numpy_to_vtk(np.arange(3.0 * len(vertices)).reshape(-1, 3), deep=True)
    values.SetName("normals of a kind")
    data.GetPointData().AddArray(values)
    title.SetName("name")
    title.InsertNextValue("a femur" * 20)
    data.GetFieldData().AddArray(title)
    return data


@pytest.fixture(name="ball", scope="module")
def made_ball():
    """Welded; its places are floats."""
    vertices, faces = sphere(24)
    clean = vtkCleanPolyData()
    clean.SetInputData(poly_data(vertices.astype("<f4"), faces))
    clean.ToleranceIsAbsoluteOn()
    clean.SetAbsoluteTolerance(1e-3)
    clean.Update()
    return places_of(clean.GetOutput()).astype("<f4").astype(float), faces_of(clean.GetOutput())


@pytest.fixture(name="socket", scope="module")
def made_socket(tmp_path_factory):
    return written(poly_data(*sphere(27, open_above=5)), vtkXMLPolyDataWriter(), tmp_path_factory.mktemp("socket") / "socket.vtp")


def written(data, writer, file):
    writer.SetInputData(data)
    writer.SetFileName(str(file))
    assert writer.Write() == 1
    return file


def read(file):
    reader = READERS[file.suffix[1:]]()
    reader.SetFileName(str(file))
    reader.Update()
    return reader, reader.GetOutput()


def places_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def faces_of(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def corners(vertices, faces):
    """Each triangle from its least corner on: the same for all orders of vertices and faces."""
    return sorted(min(t[k:] + t[:k] for k in range(3)) for t in (tuple(map(tuple, np.round(vertices[f], 3) + 0.0)) for f in faces))


def assert_read(file, ball, socket, within=0.0):
    joint = impinge.Joint.read(file, socket, side="right", centre=(0, 0, 0))
    assert np.allclose(joint.ball.vertices, ball[0], rtol=within, atol=0) and (joint.ball.faces == ball[1]).all(), file.name
    return joint


def test_all_that_the_xml_writer_can_do(ball, socket, tmp_path):
    modes = [("Ascii", 0), ("Binary", 0), ("Appended", 0), ("Appended", 1)]
    for n, ((mode, encoded), packed, header, order, kind) in enumerate(itertools.product(
            modes, ("None", "ZLib"), ("32", "64"), ("LittleEndian", "BigEndian"), ("<f4", "<f8"))):
        writer = vtkXMLPolyDataWriter()
        getattr(writer, f"SetDataModeTo{mode}")()
        getattr(writer, f"SetCompressorTypeTo{packed}")()
        getattr(writer, f"SetByteOrderTo{order}")()
        getattr(writer, f"SetHeaderTypeToUInt{header}")()
        getattr(writer, f"SetIdTypeToInt{header}")()
        writer.SetEncodeAppendedData(encoded)
        writer.SetBlockSize(1024 * (1 + n % 3))
        file = written(poly_data(*ball, kind), writer, tmp_path / f"{n}_{mode}_{encoded}_{packed}_{header}_{order}.vtp")
        assert_read(file, ball, socket)
    whole = file.read_bytes()
    for size in range(len(whole) // 37, len(whole) - 1, len(whole) // 37):
        file.write_bytes(whole[:size])
        with pytest.raises(impinge.FileError, match="its end is not </VTKFile>; export or copy it again"):
            impinge.Joint.read(file, socket)


def test_all_that_the_legacy_writer_can_do(ball, socket, tmp_path):
    for kind, version, binary in itertools.product(("<f4", "<f8"), (42, 51), (False, True)):
        writer = vtkPolyDataWriter()
        writer.SetFileVersion(version)
        writer.SetFileType(1 + binary)
        writer.SetHeader("3D Slicer output. SPACE=LPS")
        file = written(poly_data(*ball, kind), writer, tmp_path / f"{version}_{binary}.vtk")
        within = 0.0 if binary else 1e-5  # six digits
        assert assert_read(file, ball, socket, within).axes == "LPS"


def test_strips_and_pieces(ball, socket, tmp_path):
    stripper = vtkStripper()
    stripper.SetInputData(poly_data(*ball))
    stripper.Update()
    strips = stripper.GetOutput()
    assert strips.GetNumberOfStrips() > 10
    cut, pieces = vtkExtractPolyDataPiece(), vtkXMLPolyDataWriter()
    cut.SetInputData(poly_data(*ball))
    pieces.SetInputConnection(cut.GetOutputPort())
    pieces.SetNumberOfPieces(3)
    pieces.SetFileName(str(tmp_path / "pieces.vtp"))
    assert pieces.Write() == 1 and (tmp_path / "pieces.vtp").read_bytes().count(b"</Piece>") == 3
    written(strips, vtkXMLPolyDataWriter(), tmp_path / "strips.vtp")
    written(strips, vtkPolyDataWriter(), tmp_path / "strips.vtk")
    for name in ("pieces.vtp", "strips.vtp", "strips.vtk"):
        file = tmp_path / name
        found = impinge.Joint.read(file, socket, centre=(0, 0, 0)).ball
        assert corners(found.vertices, found.faces) == corners(*ball), name


def test_the_frame_is_where_slicer_writes_it(ball, socket, tmp_path):
    for mode in ("Ascii", "Binary", "Appended"):
        data, space, writer = poly_data(*ball), vtkStringArray(), vtkXMLPolyDataWriter()
        space.SetName("SPACE")
        space.InsertNextValue("LPS")
        data.GetFieldData().AddArray(space)
        getattr(writer, f"SetDataModeTo{mode}")()
        assert assert_read(written(data, writer, tmp_path / f"{mode}.vtp"), ball, socket).axes == "LPS"


def frame_of(reader, data, kind):
    """As 3D Slicer looks for it: vtkMRMLModelStorageNode."""
    if kind == "vtp":
        return data.GetFieldData().GetAbstractArray("SPACE").GetValue(0)
    said = {"ply": lambda: " ".join(reader.GetComments().GetValue(k) for k in range(reader.GetComments().GetNumberOfValues())),
            "obj": lambda: reader.GetComment(), "stl": lambda: reader.GetHeader(), "vtk": lambda: reader.GetHeader()}[kind]()
    return said.split("SPACE=")[1][:3]


def test_vtk_reads_what_the_program_writes(files, tmp_path):
    for kind in READERS:
        out = tmp_path / kind
        asked(files, out, "gaps", "--pose", "flexion=110,internal_rotation=30", "--mesh-format", kind)
        rows = table(out, "gaps.csv")
        assert min(float(row["gap_mm"] or 0) for row in rows) < 0 and any(not row["gap_mm"] for row in rows)
        for surface in ("ball", "socket"):
            reader, data = read(out / f"{surface}.{kind}")
            assert frame_of(reader, data, kind) == "RAS", kind
            mine = [row for row in rows if row["surface"] == surface]
            places = np.array([[float(row[axis]) for axis in "xyz"] for row in mine])
            if kind != "stl":  # which has them once for each face
                assert np.allclose(places_of(data), places, rtol=0 if kind in ("vtp", "vtk") else 1e-6, atol=0), kind
            if kind not in ("vtp", "vtk"):
                continue
            gaps = np.array([float(row["gap_mm"] or "nan") for row in mine])
            overlap = np.where(gaps < 0, -gaps, np.where(gaps >= 0, 0, math.nan))
            for name, truth in (("gap", gaps), ("radial_overlap", overlap)):
                assert np.array_equal(vtk_to_numpy(data.GetPointData().GetArray(name)), truth, equal_nan=True), (kind, name)
            assert data.GetPointData().GetScalars().GetName() == "gap"
        assert impinge.Joint.read(out / f"ball.{kind}", out / f"socket.{kind}", side="right", centre=(0, 0, 0)).axes == "RAS"
    out = tmp_path / "cut"
    found = asked(files, out, "resect", "--require", "flexion=110", "--mesh-format", "vtp")
    depth = vtk_to_numpy(read(out / "resected_ball.vtp")[1].GetPointData().GetArray("depth"))
    assert found["depth_mm"][0] - 1e-9 <= depth.max() <= found["depth_mm"][1] + 1e-9
    done = program("IMPINGE", "hip", "cam", "--faces", 500, "--out", tmp_path / "hip", "--mesh-format", "vtk")
    assert done.returncode == 0 and read(tmp_path / "hip/socket.vtk")[1].GetNumberOfPolys() > 200, done.stderr
