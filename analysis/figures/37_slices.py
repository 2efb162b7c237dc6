# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-37
# @question  From slices to a surface of 12,000 triangles a model (Figure 37 of the thesis).
# @data      slices_to_surface_image slices_to_surface_mesh
# @outputs   png svg pdf
# @seconds   3 3
"""From slices to a surface (Figure 37): a slice, the contours of all of them, the mesh."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.collections import LineCollection

import common
from common import ply, render, sphere_view

COLOURS = {"ball": (0.45, 0.68, 0.45), "socket": (0.42, 0.55, 0.80)}
LINES = {"ball": "#1b7837", "socket": "#2b5c9e"}
SLICE = 1.25  # mm
EVERY = 3  # slices between two contours drawn
EYE = (18.0, 60.0)  # degrees: from in front, a little from above and from the patient's left


def main(options) -> common.Figure:
    image = common.load(options.results, "slices_to_surface_image")
    meshes = read_meshes(common.load(options.results, "slices_to_surface_mesh"))
    figure, axes = plt.subplots(1, 3, figsize=(9.6, 3.9))
    draw_slice(axes[0], image)
    draw_contours(axes[1], meshes)
    draw_surface(axes[2], meshes)
    faces = {name: len(mesh.triangles) for name, mesh in meshes.items()}
    axes[2].set_title(f"c) surface: {faces['ball']:,} and\n{faces['socket']:,} triangles", loc="center", fontsize=9.5)
    handles = [common.key(name, color=colour) for name, colour in LINES.items()]
    figure.legend(handles=handles, loc="lower center", ncol=2, fontsize=9)
    figure.suptitle("From the slices of a simulated CT scan to the surfaces of a generated hip", fontsize=10.5)
    figure.subplots_adjust(left=0.06, right=0.99, top=0.8, bottom=0.16, wspace=0.08)
    return figure


def read_meshes(table: pd.DataFrame) -> dict[str, ply.Mesh]:
    """One mesh a body; corners at one place become one vertex."""
    meshes = {}
    for name, rows in table.groupby("body", sort=False):
        corners = rows.drop(columns="body").to_numpy().reshape(-1, 3)
        vertices, index = np.unique(corners, axis=0, return_inverse=True)
        meshes[name] = ply.Mesh(vertices, index.reshape(-1, 3), {})
    return meshes


def draw_slice(axes: plt.Axes, image: pd.DataFrame) -> None:
    """Pixels as they are, the level of the surface on top."""
    x, y = np.unique(image.x_mm), np.unique(image.y_mm)
    values = image.value_hu.to_numpy().reshape(len(y), len(x))
    parameters = image.attrs["parameters"]
    level = 0.5 * (parameters["bone_hu"] + parameters["tissue_hu"])
    half = 0.5 * parameters["pixel_mm"]
    extent = (x[0] - half, x[-1] + half, y[0] - half, y[-1] + half)
    axes.imshow(values, cmap="gray", origin="lower", extent=extent, interpolation="none")
    axes.contour(x, y, values, levels=[level], colors="#E69F00", linewidths=0.9)
    axes.set(xlabel="patient's left to right, mm", ylabel="back to front, mm")
    axes.set_title(f"a) slice at the centre of the head;\norange: {level:g} HU", loc="center", fontsize=9.5)
    axes.grid(visible=False)


def cut(mesh: ply.Mesh, height: float) -> np.ndarray:
    """Segments (n, 2, 3) in which the plane z = height cuts the triangles."""
    corners = mesh.vertices[mesh.triangles]
    above = corners[:, :, 2] > height
    crossed = above.any(axis=1) & ~above.all(axis=1)
    corners, above = corners[crossed], above[crossed]
    alone = np.where(above.sum(axis=1) == 1, above.argmax(axis=1), (~above).argmax(axis=1))
    rows = np.arange(len(corners))
    tip = corners[rows, alone]
    ends = []
    for step in (1, 2):
        other = corners[rows, (alone + step) % 3]
        share = (height - tip[:, 2]) / (other[:, 2] - tip[:, 2])
        ends.append(tip + share[:, None] * (other - tip))
    return np.stack(ends, axis=1)


def draw_contours(axes: plt.Axes, meshes: dict[str, ply.Mesh]) -> None:
    """Every third slice, seen obliquely."""
    right, up, _ = sphere_view.view(*EYE)
    for name, mesh in meshes.items():
        low, high = mesh.vertices[:, 2].min(), mesh.vertices[:, 2].max()
        steps = np.arange(np.ceil(low / (EVERY * SLICE)), np.floor(high / (EVERY * SLICE)) + 1)
        segments = np.concatenate([cut(mesh, EVERY * SLICE * step + 1e-6) for step in steps])
        flat = np.stack([segments @ right, segments @ up], axis=-1)
        axes.add_collection(LineCollection(flat, colors=LINES[name], linewidths=0.7))
    axes.set_title(f"b) contours, every {EVERY}rd slice\nof {SLICE:g} mm", loc="center", fontsize=9.5)
    frame(axes, meshes)
    axes.axis("off")


def frame(axes: plt.Axes, meshes: dict[str, ply.Mesh]) -> None:
    """The same window for contours and surface."""
    focus, size = window(meshes)
    right, up, _ = sphere_view.view(*EYE)
    axes.set(
        xlim=(focus @ right - size, focus @ right + size), ylim=(focus @ up - size, focus @ up + size), aspect="equal"
    )


def window(meshes: dict[str, ply.Mesh]) -> tuple[np.ndarray, float]:
    """Middle and half width of what is seen, mm."""
    points = np.concatenate([mesh.vertices for mesh in meshes.values()])
    focus = 0.5 * (points.min(axis=0) + points.max(axis=0))
    view = sphere_view.view(*EYE)
    return focus, 1.03 * np.abs((points - focus) @ view[:2].T).max()


def draw_surface(axes: plt.Axes, meshes: dict[str, ply.Mesh]) -> None:
    """The mesh with its edges."""
    focus, size = window(meshes)
    _, up, towards = sphere_view.view(*EYE)
    with render.screen():
        actors = [render.plain_surface(mesh, COLOURS[name], edges=True) for name, mesh in meshes.items()]
        picture = render.picture(actors, render.View(focus, -towards, up, size))
    axes.imshow(picture, interpolation="none")
    axes.axis("off")


common.run(main)
