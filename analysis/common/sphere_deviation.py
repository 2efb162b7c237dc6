# SPDX-License-Identifier: GPL-3.0-or-later
"""How far the surface of a ball is from the sphere that was fitted to it, with colours: what Figures 38, 39, 60 and 61 share. From
data/head_maps.csv and data/head_maps/NAME.ply.
"""

from dataclasses import dataclass, replace
from pathlib import Path

import matplotlib
import numpy as np
import pandas as pd
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm, ListedColormap
from vtkmodules.vtkRenderingCore import vtkActor

import common
from common import hip, panels, ply, render

STEP, LARGEST = 0.5, 2.75  # mm: of a colour, and where the last begins; the middle one is within a quarter of 0
EXCESS = 1.0  # mm beyond the sphere that Figures 60 and 61 mark
NECK = (0.25, 0.6)  # of the radius: what is that far out is the neck
BESIDE_NECK = np.radians(55)  # from the axis of the neck: nearer, the head rises to it
CLUSTER = np.radians(30)  # half width of the region that is marked


def edges() -> np.ndarray:
    """Where one colour ends and the next begins, mm."""
    return np.arange(-LARGEST, LARGEST + STEP / 2, STEP)


def colours() -> ScalarMappable:
    """Blue inside the sphere, red outside, pale on it; the ends hold everything beyond."""
    count = len(edges()) + 1
    shades = ListedColormap(matplotlib.colormaps["RdBu_r"](np.linspace(0.03, 0.97, count)))
    norm = BoundaryNorm(edges(), count, extend="both")
    return ScalarMappable(norm, shades)


@dataclass(frozen=True)
class HeadMap:
    """A ball in the joint frame about the centre of its sphere. Each vertex has its distance from the sphere (mm, positive
    outside) and whether it was fitted. With the row of head_maps.csv.
    """

    ball: ply.Mesh
    deviation: np.ndarray
    fitted: np.ndarray
    fit: pd.Series


def load(results: Path, joint: hip.Hip) -> HeadMap:
    """The map of a joint's ball, as scanned or modelled."""
    table = common.load(results, "head_maps").set_index("joint")
    mesh = ply.read(results / "data" / "head_maps" / f"{joint.name}.ply")
    turned = hip.to_joint(mesh.vertices, {**joint.summary, "centre": dict.fromkeys("xyz", 0.0)})
    deviation, fitted = (mesh.properties[name] for name in ("deviation", "fitted"))
    return HeadMap(replace(mesh, vertices=turned), deviation, fitted > 0.5, table.loc[joint.name])


def coloured(head: HeadMap) -> vtkActor:
    """The ball in these colours."""
    limits = (-LARGEST - STEP, LARGEST + STEP)
    scale = colours()
    middles = np.arange(limits[0] + STEP / 2, limits[1], STEP)
    return render.scalar_surface(head.ball, head.deviation, render.Shades(scale.to_rgba(middles)[:, :3], limits))


@dataclass(frozen=True)
class Region:
    """The region in which the ball rises most above the sphere: its middle, the largest deviation, and its extent."""

    middle: np.ndarray  # on the surface, mm
    most: float  # mm
    reach: float  # mm from the middle


def excess(head: HeadMap) -> Region | None:
    """The largest region with a deviation of EXCESS or more that does not belong to the neck; none if there is none."""
    off = head.deviation
    share = off / head.fit.radius_mm
    area = vertex_areas(head.ball)
    unit = head.ball.vertices / np.linalg.norm(head.ball.vertices, axis=1)[:, None]
    neck = (unit * area[:, None])[(share > NECK[0]) & (share < NECK[1])].sum(axis=0)
    length = np.linalg.norm(neck)
    beside = unit @ neck < length * np.cos(BESIDE_NECK) if length else np.full(len(unit), True)
    chosen = (off > EXCESS) & (share < NECK[0]) & beside
    if not chosen.any():
        return None
    points, unit = head.ball.vertices[chosen], unit[chosen]
    weight = area[chosen] * off[chosen]
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


def colour_bar(figure) -> None:
    """Draws the bar of colours below the panels, with the meaning of the letters in them."""
    height = figure.get_size_inches()[1]
    axes = figure.add_axes([0.2, 0.45 / height, 0.6, 0.12 / height])
    bar = figure.colorbar(colours(), cax=axes, orientation="horizontal", extend="both", extendfrac="auto")
    bar.set_ticks(np.arange(-2, 3))
    bar.set_ticks([], minor=True)
    bar.ax.tick_params(labelsize=common.SMALL, length=2, pad=1)
    text = f"distance from the sphere, mm, outwards positive\n{panels.wrapped(figure, hip.WAYS)}"
    bar.set_label(text, fontsize=common.SMALL, labelpad=2)
