# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of meshes and points by VTK: what every render shares."""

from __future__ import annotations

import contextlib
import os
import subprocess
from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  # registers the renderer

import common
import ply

PIXELS = 900  # a side of one view, if it does not say otherwise


@dataclass(frozen=True)
class View:
    """A camera without perspective that looks along `towards` at `focus`; `size` (mm) is from the middle of the
    picture to its border, `pixels` a side of it.
    """

    focus: np.ndarray
    towards: np.ndarray
    up: np.ndarray
    size: float
    pixels: int = PIXELS

    def place(self, point: np.ndarray) -> np.ndarray:
        """Pixel (column, row from above) at which a point is seen."""
        right = np.cross(self.towards, self.up)
        right = right / np.linalg.norm(right)
        offset = point - self.focus
        seen = np.array([offset @ right, -offset @ np.cross(right, self.towards)])
        return (self.pixels - 1) / 2 + seen / self.size * self.pixels / 2


def _data(vertices: np.ndarray, cells: np.ndarray) -> tuple[vtkPolyData, vtkCellArray]:
    """Points for VTK, and cells of the same number of corners each, (n, corners)."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(vertices), deep=True))
    array = vtkCellArray()
    offsets = np.arange(0, cells.size + 1, cells.shape[1], dtype=np.int64)
    array.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True),
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells).ravel(), deep=True),
    )
    data = vtkPolyData()
    data.SetPoints(points)
    return data, array


def polydata(mesh: ply.Mesh) -> vtkPolyData:
    """The mesh for VTK with smooth normals, and the gap on its vertices if it has one."""
    data, triangles = _data(mesh.vertices, mesh.triangles)
    data.SetPolys(triangles)
    if "gap" in mesh.properties:
        gap = np.ascontiguousarray(mesh.properties["gap"])
        data.GetPointData().SetScalars(numpy_to_vtk(gap, deep=True))
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def surface(mapper: vtkPolyDataMapper, opacity: float = 1.0) -> vtkActor:
    """A surface lit alike on both sides."""
    thing = vtkActor()
    thing.SetMapper(mapper)
    look = thing.GetProperty()
    look.SetOpacity(opacity)
    look.SetAmbient(0.5)
    look.SetDiffuse(0.55)
    look.SetSpecular(0.05)
    return thing


def plain_surface(mesh: ply.Mesh, colour: tuple[float, float, float], edges: bool = False) -> vtkActor:
    """The mesh in one colour, its edges drawn if that is asked for."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(polydata(mesh))
    mapper.ScalarVisibilityOff()
    thing = surface(mapper)
    thing.GetProperty().SetColor(*colour)
    if edges:
        thing.GetProperty().EdgeVisibilityOn()
        thing.GetProperty().SetEdgeColor(0.35, 0.35, 0.35)
    return thing


def dots(points: np.ndarray, colour: tuple[float, float, float], size: float) -> vtkActor:
    """Round points of one colour, `size` pixels wide, without light."""
    data, vertices = _data(points, np.arange(len(points), dtype=np.int64)[:, None])
    data.SetVerts(vertices)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    thing = vtkActor()
    thing.SetMapper(mapper)
    look = thing.GetProperty()
    look.SetColor(*colour)
    look.SetPointSize(size)
    look.RenderPointsAsSpheresOn()
    look.SetAmbient(1)
    look.SetDiffuse(0)
    return thing


def picture(actors: list[vtkActor], view: View) -> np.ndarray:
    """One view, as an image."""
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for thing in actors:
        renderer.AddActor(thing)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*view.focus)
    camera.SetPosition(*(view.focus - 10 * view.size * view.towards))
    camera.SetViewUp(*view.up)
    camera.SetParallelScale(view.size)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(view.pixels, view.pixels)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    return np.flipud(image.reshape(view.pixels, view.pixels, 3))


def upwards(axes: str, axis: np.ndarray) -> np.ndarray:
    """Where superior is, from a text such as RAS; another direction where the socket's axis runs that way
    itself.
    """
    up = np.array([{"S": 1.0, "I": -1.0}.get(end, 0.0) for end in axes])
    return up if abs(up @ axis) < 0.9 else np.roll(up, 1)


@contextlib.contextmanager
def screen():
    """A screen for OpenGL: the one that is there, or Xvfb for as long as it is needed."""
    if os.environ.get("DISPLAY"):
        yield
        return
    read, write = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset"],
        pass_fds=[write],
        stderr=subprocess.DEVNULL,
    )
    os.close(write)
    try:
        with os.fdopen(read) as pipe:
            display = pipe.readline().strip()
        if not display:
            raise common.Refused("Xvfb, the screen that VTK asks for, did not start")
        os.environ["DISPLAY"] = f":{display}"
        yield
    finally:
        os.environ.pop("DISPLAY", None)
        server.terminate()
        server.wait()
