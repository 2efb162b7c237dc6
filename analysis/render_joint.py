# SPDX-License-Identifier: GPL-3.0-or-later
"""A joint coloured by its gap, from four sides. From scenes/NAME (ball.ply, socket.ply with a gap in mm, summary.json).

The thesis names five colours (its Figure 41): purple where the bones touch, then red, orange and yellow within the thickness of the
cartilage, and beyond it green on the ball and blue on the socket. It does not say where one colour ends: equal steps are our
choice. Shades darken steadily towards contact, so that the picture reads in grey and with every common colour vision.
"""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Patch
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  # registers the renderer

import common
import ply

CARTILAGE_MM = 4.0  # where the scene does not say
TOUCHING = ("#3b0f70", "touching or overlapping")
STEPS = ["#b3282d", "#f07f1c", "#f7dc6f"]  # from contact to the edge of the cartilage, equal steps
BEYOND = {"ball": "#3f9f6b", "socket": "#3b7fbf"}
NO_SURFACE = "#d9d9d9"
PIXELS = 900  # a side of one view


def bands(cartilage: float) -> list[tuple[float, float, str]]:
    """Lower end, upper end and colour of each step between contact and the cartilage's thickness, mm."""
    edges = np.linspace(0, cartilage, len(STEPS) + 1)
    return [(low, high, colour) for low, high, colour in zip(edges, edges[1:], STEPS)]


def lookup(part: str, cartilage: float) -> tuple[vtkLookupTable, tuple[float, float]]:
    """Colours by gap: one entry for a step, the first for contact, the last for beyond."""
    step = cartilage / len(STEPS)
    colours = [TOUCHING[0], *STEPS, BEYOND[part]]
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(colours))
    for i, colour in enumerate(colours):
        table.SetTableValue(i, *_rgb(colour))
    table.SetNanColor(*_rgb(NO_SURFACE), 1)
    return table, (-step, cartilage + step)


def _rgb(colour: str) -> tuple[float, ...]:
    """Red, green and blue from 0 to 1."""
    return tuple(int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5))


def polydata(mesh: ply.Mesh) -> vtkPolyData:
    """The mesh for VTK, with the gap on its vertices and smooth normals."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(mesh.vertices), deep=True))
    cells = vtkCellArray()
    offsets = np.arange(0, mesh.triangles.size + 1, 3, dtype=np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(np.ascontiguousarray(mesh.triangles).ravel(), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(mesh.properties["gap"]), deep=True))
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def actor(mesh: ply.Mesh, part: str, cartilage: float, opacity: float = 1.0) -> vtkActor:
    """The mesh with its colours; both sides lit alike."""
    table, limits = lookup(part, cartilage)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(polydata(mesh))
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(*limits)
    mapper.InterpolateScalarsBeforeMappingOn()
    thing = vtkActor()
    thing.SetMapper(mapper)
    surface = thing.GetProperty()
    surface.SetOpacity(opacity)
    surface.SetAmbient(0.5)
    surface.SetDiffuse(0.55)
    surface.SetSpecular(0.05)
    return thing


def picture(actors: list[vtkActor], focus: np.ndarray, towards: np.ndarray, up: np.ndarray, size: float) -> np.ndarray:
    """One view, as an image: a camera without perspective that looks along towards at focus."""
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for thing in actors:
        renderer.AddActor(thing)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*(focus - 10 * size * towards))
    camera.SetViewUp(*up)
    camera.SetParallelScale(1.03 * size)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(PIXELS, PIXELS)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    return np.flipud(vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(PIXELS, PIXELS, 3))


def views(ball: ply.Mesh, socket: ply.Mesh, centre: np.ndarray, cartilage: float) -> dict[str, np.ndarray]:
    """Four images by title. The socket's axis points from the centre to the middle of the socket."""
    axis = socket.vertices.mean(axis=0) - centre
    axis /= np.linalg.norm(axis)
    up = np.array([0.0, 0.0, 1.0]) if abs(axis[2]) < 0.9 else np.array([0.0, 1.0, 0.0])
    side = np.cross(axis, up)
    side /= np.linalg.norm(side)
    points = np.vstack([ball.vertices, socket.vertices])
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    both = float(np.linalg.norm(points - middle, axis=1).max())
    alone = {part: float(np.linalg.norm(mesh.vertices - centre, axis=1).max())
             for part, mesh in (("ball", ball), ("socket", socket))}
    ball_actor = actor(ball, "ball", cartilage)
    socket_actor = actor(socket, "socket", cartilage)
    glass = actor(socket, "socket", cartilage, opacity=0.45)
    return {
        "together, socket as glass": picture([ball_actor, glass], middle, side, up, both),
        "socket, from outside": picture([socket_actor], centre, -axis, up, alone["socket"]),
        "socket, from inside": picture([socket_actor], centre, axis, up, alone["socket"]),
        "ball, from the socket": picture([ball_actor], centre, -axis, up, alone["ball"]),
    }


@contextlib.contextmanager
def screen():
    """A screen for OpenGL: the one that is there, or Xvfb for as long as it is needed."""
    if os.environ.get("DISPLAY"):
        yield
        return
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"],
                              pass_fds=[write], stderr=subprocess.DEVNULL)
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


def legend(cartilage: float) -> list[Patch]:
    """The colours, from contact outwards."""
    steps = [Patch(color=colour, label=f"{low:.2g} to {high:.2g} mm") for low, high, colour in bands(cartilage)]
    return [Patch(color=TOUCHING[0], label=TOUCHING[1]), *steps,
            Patch(color=BEYOND["ball"], label=f"ball, over {cartilage:g} mm"),
            Patch(color=BEYOND["socket"], label=f"socket, over {cartilage:g} mm"),
            Patch(color=NO_SURFACE, label="no surface opposite")]


def compose(images: dict[str, np.ndarray], name: str, summary: dict) -> plt.Figure:
    """The views in one row of two by two, a title and the legend."""
    cartilage = summary.get("cartilage_mm") or CARTILAGE_MM
    common.style()
    figure, grid = plt.subplots(2, 2, figsize=(6.8, 7.6))
    for axes, (title, image) in zip(grid.flat, images.items()):
        axes.imshow(image)
        axes.set_title(title, loc="center", fontsize=10)
        axes.axis("off")
    smallest = summary.get("smallest_gap_mm")
    gap = f": smallest gap {smallest:.2f} mm" if smallest is not None else ""
    figure.suptitle(f"{name.replace('_', ' ')}{gap}", fontsize=12, y=0.97)
    figure.legend(handles=legend(cartilage), loc="lower center", ncol=3, title="gap, mm", fontsize=9)
    figure.subplots_adjust(left=0.02, right=0.98, top=0.90, bottom=0.14, wspace=0.02, hspace=0.10)
    return figure


def main() -> None:
    """Writes figures/joint-NAME.png."""
    options = common.arguments(__doc__, "--scene")
    folder: Path = options.results / "scenes" / options.scene
    summary = json.loads((folder / "summary.json").read_text())
    cartilage = summary.get("cartilage_mm") or CARTILAGE_MM
    ball, socket = ply.read(folder / "ball.ply"), ply.read(folder / "socket.ply")
    with screen():
        images = views(ball, socket, np.array(summary["centre"], dtype=float), cartilage)
    figure = compose(images, options.scene, summary)
    path = options.out / "figures" / f"joint-{options.scene}.png"
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Software": None})


common.run(main)
