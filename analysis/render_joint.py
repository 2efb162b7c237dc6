# SPDX-License-Identifier: GPL-3.0-or-later
"""A joint coloured by its gap, from four sides. From scenes/NAME (ball.ply, socket.ply with a gap in mm,
summary.json).

Colours and thresholds are those of the scene (libcore/joint/gap_levels.hpp): the thesis' five, darker towards
contact, so that the picture reads in grey and with every common colour vision.
"""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Patch
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
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

PIXELS = 900  # a side of one view
SHADES = 4096  # entries of a colour table: so finely are thresholds resolved


@dataclass(frozen=True)
class Colours:
    """Upper ends of the levels in mm, the last one infinite, and the colour of each and of no gap, from 0 to
    1.
    """

    upper: np.ndarray
    rgb: np.ndarray
    nothing: np.ndarray


def colours_of(summary: dict, part: str) -> Colours:
    """The levels that the scene used for the ball or the socket."""
    levels = summary["colours"][part]
    upper = [np.inf if level["up_to_mm"] is None else level["up_to_mm"] for level in levels]
    return Colours(
        np.array(upper),
        np.array([level["rgb"] for level in levels]) / 255,
        np.array(summary["colours"]["no_gap_rgb"]) / 255,
    )


def lookup(colours: Colours) -> tuple[vtkLookupTable, tuple[float, float]]:
    """Colour by gap, and the range of gaps that it spans; beyond, the first and the last colour hold."""
    limits = (-1.0, float(colours.upper[-2]) + 1.0)
    gaps = np.linspace(*limits, SHADES)
    table = vtkLookupTable()
    table.SetNumberOfTableValues(SHADES)
    for i, level in enumerate(np.searchsorted(colours.upper, gaps)):
        table.SetTableValue(i, *colours.rgb[level], 1)
    table.SetNanColor(*colours.nothing, 1)
    return table, limits


def polydata(mesh: ply.Mesh) -> vtkPolyData:
    """The mesh for VTK, with the gap on its vertices and smooth normals."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(mesh.vertices), deep=True))
    cells = vtkCellArray()
    offsets = np.arange(0, mesh.triangles.size + 1, 3, dtype=np.int64)
    cells.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True),
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(mesh.triangles).ravel(), deep=True),
    )
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


def actor(mesh: ply.Mesh, colours: Colours, opacity: float = 1.0) -> vtkActor:
    """The mesh with its colours; both sides lit alike."""
    table, limits = lookup(colours)
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


def picture(
    actors: list[vtkActor], focus: np.ndarray, towards: np.ndarray, up: np.ndarray, size: float
) -> np.ndarray:
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


def upwards(axes: str, axis: np.ndarray) -> np.ndarray:
    """Where superior is, from a text such as RAS; another direction where the socket's axis runs that way
    itself.
    """
    up = np.array([{"S": 1.0, "I": -1.0}.get(end, 0.0) for end in axes])
    return up if abs(up @ axis) < 0.9 else np.roll(up, 1)


def views(ball: ply.Mesh, socket: ply.Mesh, summary: dict) -> dict[str, np.ndarray]:
    """Four images by title. The socket's axis points from the centre to the middle of the socket."""
    centre = np.array([summary["centre"][axis] for axis in "xyz"])
    axis = socket.vertices.mean(axis=0) - centre
    axis /= np.linalg.norm(axis)
    up = upwards(summary["axes"], axis)
    side = np.cross(axis, up)
    side /= np.linalg.norm(side)
    points = np.vstack([ball.vertices, socket.vertices])
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    both = float(np.linalg.norm(points - middle, axis=1).max())
    alone = {
        part: float(np.linalg.norm(mesh.vertices - centre, axis=1).max())
        for part, mesh in (("ball", ball), ("socket", socket))
    }
    ball_actor = actor(ball, colours_of(summary, "ball"))
    socket_actor = actor(socket, colours_of(summary, "socket"))
    glass = actor(socket, colours_of(summary, "socket"), opacity=0.45)
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


def legend(summary: dict) -> list[Patch]:
    """The colours from contact outwards; the last differs between ball and socket."""
    ball, socket = colours_of(summary, "ball"), colours_of(summary, "socket")
    patches = [Patch(color=ball.rgb[0], label="bones touch or overlap")]
    for low, high, colour in zip(ball.upper, ball.upper[1:-1], ball.rgb[1:-1]):
        patches.append(Patch(color=colour, label=f"{low:.2g} to {high:.2g} mm"))
    patches += [
        Patch(color=colours.rgb[-1], label=f"{part}, over {colours.upper[-2]:.2g} mm")
        for part, colours in (("ball", ball), ("socket", socket))
    ]
    return [*patches, Patch(color=ball.nothing, label="no surface opposite")]


def compose(images: dict[str, np.ndarray], name: str, summary: dict) -> plt.Figure:
    """The views two by two, a title and the legend."""
    common.style()
    figure, grid = plt.subplots(2, 2, figsize=(6.8, 7.6))
    for axes, (title, image) in zip(grid.flat, images.items()):
        axes.imshow(image)
        axes.set_title(title, loc="center", fontsize=10)
        axes.axis("off")
    smallest = summary["smallest_gap"]
    gap = f": smallest gap {smallest['gap_mm']:.2f} mm" if smallest else ""
    pose = f", {summary['pose'].replace('=', ' ')}°" if "=" in summary["pose"] else ""
    figure.suptitle(f"{name.replace('_', ' ')}{pose}{gap}", fontsize=12, y=0.97)
    figure.legend(handles=legend(summary), loc="lower center", ncol=3, title="gap, mm", fontsize=9)
    figure.subplots_adjust(left=0.02, right=0.98, top=0.90, bottom=0.14, wspace=0.02, hspace=0.10)
    return figure


def main() -> None:
    """Writes figures/joint-NAME.png."""
    options = common.arguments(__doc__, "--scene")
    folder: Path = options.results / "scenes" / options.scene
    summary = json.loads((folder / "summary.json").read_text())
    ball, socket = ply.read(folder / "ball.ply"), ply.read(folder / "socket.ply")
    with screen():
        images = views(ball, socket, summary)
    figure = compose(images, options.scene, summary)
    path = options.out / "figures" / f"joint-{options.scene}.png"
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Software": None})


common.run(main)
