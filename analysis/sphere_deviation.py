# SPDX-License-Identifier: GPL-3.0-or-later
"""How far the surface of a ball is from the sphere fitted to it, and its colours: what Figures 38, 39, 60 and 61
share.
"""

from __future__ import annotations

from dataclasses import dataclass

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm, ListedColormap
from vtkmodules.vtkRenderingCore import vtkActor

import hip
import panels
import ply
import render

STEP, LARGEST = 0.5, 3.0  # mm: of a colour, and where the last begins
TRIM = 0.06  # residuals up to this share of the radius are fitted (libcore/joint/sphere_fit.hpp)
EXCESS = 1.0  # mm beyond the sphere that Figures 60 and 61 mark
REACH = 0.25  # of the radius: what is farther out is neck or trochanter
CLUSTER = np.radians(30)  # half width of the region that is marked


def edges() -> np.ndarray:
    """Where one colour ends and the next begins, mm."""
    return np.arange(-LARGEST, LARGEST + STEP / 2, STEP)


def colours() -> ScalarMappable:
    """Blue inside the sphere, red outside, white at it; the ends hold all that is beyond."""
    count = len(edges()) + 1
    shades = ListedColormap(matplotlib.colormaps["RdBu_r"](np.linspace(0.03, 0.97, count)))
    norm = BoundaryNorm(edges(), count, extend="both")
    return ScalarMappable(norm, shades)


def deviation(joint: hip.Hip) -> np.ndarray:
    """Of each vertex of the ball, mm, beyond the sphere positive."""
    return np.linalg.norm(joint.ball.vertices, axis=1) - joint.summary["centre"]["radius_mm"]


def coloured(joint: hip.Hip) -> vtkActor:
    """The ball in these colours."""
    limits = (-LARGEST - STEP, LARGEST + STEP)
    scale = colours()
    middles = np.arange(limits[0] + STEP / 2, limits[1], STEP)
    return render.scalar_surface(joint.ball, deviation(joint), render.Shades(scale.to_rgba(middles)[:, :3], limits))


@dataclass(frozen=True)
class Region:
    """Where the ball rises above the sphere most: its middle, the largest deviation there, and how far it reaches."""

    middle: np.ndarray  # on the surface, mm
    most: float  # mm
    reach: float  # mm from the middle


def excess(joint: hip.Hip) -> Region | None:
    """The largest region of EXCESS or more that is still of the head; none where there is none."""
    off = deviation(joint)
    radius = joint.summary["centre"]["radius_mm"]
    chosen = (off > EXCESS) & (off < REACH * radius)
    if not chosen.any():
        return None
    points = joint.ball.vertices[chosen]
    unit = points / np.linalg.norm(points, axis=1)[:, None]
    weight = vertex_areas(joint.ball)[chosen] * off[chosen]
    near = unit @ unit.T > np.cos(CLUSTER)
    best = near[int(np.argmax(near @ weight))]
    middle = np.average(points[best], axis=0, weights=weight[best])
    middle *= np.linalg.norm(points[best], axis=1).mean() / np.linalg.norm(middle)
    reach = np.quantile(np.linalg.norm(points[best] - middle, axis=1), 0.9)
    return Region(middle, float(off[chosen][best].max()), float(reach))


def vertex_areas(mesh: ply.Mesh) -> np.ndarray:
    """A third of the faces round each vertex, mm^2."""
    a, b, c = (mesh.vertices[mesh.triangles[:, k]] for k in range(3))
    share = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 6
    return np.bincount(mesh.triangles.ravel(), np.repeat(share, 3), minlength=len(mesh.vertices))


def colour_bar(figure, grid) -> None:
    """Below the panels, with what the letters in them mean."""
    height = figure.get_size_inches()[1]
    axes = figure.add_axes([0.2, 0.45 / height, 0.6, 0.12 / height])
    bar = figure.colorbar(colours(), cax=axes, orientation="horizontal", extend="both", extendfrac="auto")
    bar.set_ticks(edges()[::2])
    bar.ax.tick_params(labelsize=8, length=2, pad=1)
    bar.set_label(f"distance from the sphere, mm, outwards positive\n{panels.WAYS}", fontsize=8, labelpad=2)
