# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of meshes and points by VTK: what all renders share."""

import contextlib
import os
import subprocess
from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter
)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  # registers the renderer

import common
from common import ply

PIXELS = 900  # a side of one view, if it does not say otherwise


@dataclass(frozen=True)
class View:
    """A camera without perspective that looks along `towards` at `focus`. `size` (mm) is from the middle of the picture to its
    border; a side of the picture has `pixels`.
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


def framed(points: np.ndarray, towards: np.ndarray, up: np.ndarray, share: float, pixels: int = PIXELS) -> View:
    """A view of the points; the distance from its middle to its border is `share` of their larger extent across. Directions
    are unit vectors."""
    frame = np.array([np.cross(towards, up), up, towards])
    seen = points @ frame.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    return View((low + high) / 2 @ frame, towards, up, share * float((high - low)[:2].max()), pixels)


@dataclass(frozen=True)
class Shades:
    """Colours (n, 3) from 0 to 1, evenly spaced over the limits of a number, and the colour of no number. Beyond the limits
    the first or the last colour is used.
    """

    rgb: np.ndarray
    limits: tuple[float, float]
    nothing: tuple[float, float, float] = (0.85, 0.85, 0.85)


def _data(vertices: np.ndarray, cells: np.ndarray) -> tuple[vtkPolyData, vtkCellArray]:
    """The points for VTK, with cells (n, corners) that all have the same number of corners."""
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
    """The mesh for VTK with smooth normals."""
    data, triangles = _data(mesh.vertices, mesh.triangles)
    data.SetPolys(triangles)
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def surface(mapper: vtkPolyDataMapper, opacity: float = 1.0) -> vtkActor:
    """A surface that is lit in the same way on both sides."""
    thing = vtkActor()
    thing.SetMapper(mapper)
    look = thing.GetProperty()
    look.SetOpacity(opacity)
    look.SetAmbient(0.5)
    look.SetDiffuse(0.55)
    look.SetSpecular(0.05)
    return thing


def scalar_surface(mesh: ply.Mesh, values: np.ndarray, shades: Shades, opacity: float = 1.0) -> vtkActor:
    """The mesh in the colours of one number per vertex, which is interpolated before it is coloured."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(shades.rgb))
    for i, colour in enumerate(shades.rgb):
        table.SetTableValue(i, *colour, 1)
    table.SetNanColor(*shades.nothing, 1)
    data = polydata(mesh)
    data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(values), deep=True))
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(*shades.limits)
    mapper.InterpolateScalarsBeforeMappingOn()
    return surface(mapper, opacity)


def plain_surface(
    mesh: ply.Mesh, colour: tuple[float, float, float], edges: bool = False, opacity: float = 1.0
) -> vtkActor:
    """The mesh in one colour; its edges are drawn if asked for."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(polydata(mesh))
    thing = surface(mapper, opacity)
    thing.GetProperty().SetColor(*colour)
    if edges:
        thing.GetProperty().EdgeVisibilityOn()
        thing.GetProperty().SetEdgeColor(0.35, 0.35, 0.35)
    return thing


def _unlit(data: vtkPolyData, colour: tuple[float, float, float]) -> vtkActor:
    """Points or lines in one colour, without light."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    thing = vtkActor()
    thing.SetMapper(mapper)
    look = thing.GetProperty()
    look.SetColor(*colour)
    look.LightingOff()
    return thing


def dots(points: np.ndarray, colour: tuple[float, float, float], size: float) -> vtkActor:
    """Round points in one colour, `size` pixels wide, without light."""
    data, vertices = _data(points, np.arange(len(points), dtype=np.int64)[:, None])
    data.SetVerts(vertices)
    thing = _unlit(data, colour)
    thing.GetProperty().SetPointSize(size)
    thing.GetProperty().RenderPointsAsSpheresOn()
    return thing


def rings(curves: list[np.ndarray], colour: tuple[float, float, float], width: float) -> vtkActor:
    """Closed curves, each through points (n, 3), `width` pixels wide, without light."""
    starts = np.cumsum([0] + [len(curve) for curve in curves[:-1]])
    pairs = [
        start + np.column_stack([np.arange(len(curve)), np.roll(np.arange(len(curve)), -1)])
        for start, curve in zip(starts, curves)
    ]
    data, lines = _data(np.vstack(curves), np.vstack(pairs).astype(np.int64))
    data.SetLines(lines)
    thing = _unlit(data, colour)
    thing.GetProperty().SetLineWidth(width)
    return thing


def picture(actors: list[vtkActor], view: View) -> np.ndarray:
    """Renders one view as an image."""
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
    """The direction superior from a text such as RAS; another direction if the socket's axis runs along it."""
    up = np.array([{"S": 1.0, "I": -1.0}.get(end, 0.0) for end in axes])
    return up if abs(up @ axis) < 0.9 else np.roll(up, 1)


@contextlib.contextmanager
def screen():
    """A screen for OpenGL: the existing one, or Xvfb for as long as it is needed."""
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
