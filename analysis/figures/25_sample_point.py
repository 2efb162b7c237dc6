# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-25
# @question  A triangle, a sample point on it, and all of its sample points (Figure 25).
# @data      diagram_corners diagram_coverage
"""Figure 25: a real triangle of a socket, a sample point on it, all of its sample points, and what they make of it."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import diagram, diagram_chart, sphere_view

FACE = "plain"
FROM_BESIDE = diagram.Eye(sphere_view.view(16, 48))
FROM_OUTSIDE = diagram.Eye(sphere_view.view(32, 110))


def main(options) -> common.Figure:
    corners = common.load(options.results, "diagram_corners")
    entries = diagram_chart.of_face(common.load(options.results, "diagram_coverage"), FACE)
    entries = entries[entries.met].assign(
        phi=lambda e: e.row * e.precision_deg, theta=lambda e: e.column * e.precision_deg
    )
    face = diagram.faces(corners, FACE)[0]
    points = entries.met_mm.to_numpy()[:, None] * diagram.direction(entries.phi, entries.theta)
    figure, panels = plt.subplots(1, 3, figsize=(8.6, 3.5))
    one = int(np.argmin(np.linalg.norm(points - face.mean(axis=0), axis=1)))
    draw_point(panels[0], face, points[one], entries.iloc[one])
    draw_face(panels[1], face)
    diagram.dots(panels[1], FROM_OUTSIDE.see(points))
    draw_face(panels[2], face, alpha=0.35)
    draw_net(panels[2], entries, points)
    diagram.title(panels[1], f"b) its {len(points)} sample points,\none an entry of the table")
    diagram.title(panels[2], "c) the table's stand-in for it:\nthe points alone")
    figure.suptitle(
        f"A triangle becomes entries of a table (socket, {diagram.HIP}, coarse mesh; RSID at 1°)", fontsize=10.5
    )
    figure.subplots_adjust(left=0.01, right=0.99, top=0.78, bottom=0.02, wspace=0.05)
    return figure


def draw_face(axes: plt.Axes, face: np.ndarray, alpha: float = 1.0) -> None:
    """The triangle with its corners named."""
    seen = FROM_OUTSIDE.see(face)
    diagram.polygon(axes, seen, facecolor=diagram.FILL["socket"], edgecolor=diagram.SOCKET, alpha=alpha)
    diagram.frame(axes, seen, room=0.06)


def draw_point(axes: plt.Axes, face: np.ndarray, point: np.ndarray, entry: pd.Series) -> None:
    """The triangle before the centre of rotation, and the ray of one entry."""
    origin = FROM_BESIDE.see(np.zeros(3))
    seen = FROM_BESIDE.see(face)
    for corner, name, offset in zip(seen, "abc", ((-2, 9), (9, -5), (-9, 5))):
        axes.plot(*np.array([origin, corner]).T, color=common.THESIS_GREY, linewidth=0.8, zorder=1)
        diagram.note(axes, corner, name, offset, fontsize=11)
    diagram.polygon(axes, seen, facecolor=diagram.FILL["socket"], edgecolor=diagram.SOCKET)
    for axis, name in zip(np.eye(3), "xyz"):
        diagram.arrow(axes, origin, FROM_BESIDE.see(9 * axis), name, linewidth=0.9)
    diagram.arrow(axes, origin, FROM_BESIDE.see(point), linewidth=1.6, color=diagram.POLE)
    diagram.dots(axes, FROM_BESIDE.see(point[None]), markersize=5, color=diagram.POLE)
    diagram.dots(axes, origin[None], marker="s", markersize=5)
    diagram.note(axes, origin, "centre of\nrotation", (-6, -19), fontsize=8.5)
    diagram.note(axes, FROM_BESIDE.see(point), "sample\npoint", (29, 8), fontsize=9, color=diagram.POLE)
    diagram.note(axes, FROM_BESIDE.see(0.55 * point), f"d = {entry.met_mm:.2f} mm", (34, -12), color=diagram.POLE)
    everything = np.vstack([seen, origin[None], FROM_BESIDE.see(9 * np.eye(3))])
    diagram.frame(axes, everything, room=0.05)
    diagram.title(axes, f"a) φ = {entry.phi:g}°, θ = {entry.theta:g}°:\nLUT[{entry.row}][{entry.column}] = d")


def draw_net(axes: plt.Axes, entries: pd.DataFrame, points: np.ndarray) -> None:
    """The points, each joined to those next to it in the table."""
    at = {(row, column): k for k, (row, column) in enumerate(zip(entries.row, entries.column))}
    seen = FROM_OUTSIDE.see(points)
    for (row, column), k in at.items():
        for other in ((row + 1, column), (row, column + 1)):
            if other in at:
                axes.plot(*seen[[k, at[other]]].T, color=diagram.SOCKET, linewidth=0.9, zorder=3)
    diagram.dots(axes, seen)


common.run(main)
