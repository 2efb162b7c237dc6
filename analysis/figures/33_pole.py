# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-33
# @question  A triangle that holds the pole, and what mapping its corners directly misses (Figure 33).
# @data      diagram_corners diagram_coverage
"""Figure 33: a triangle that holds the pole, in space and between its three corners as mapped directly, which misses the
pole.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Patch

import common
from common import diagram, diagram_chart

FACE = "pole_inside"
LOOKS = {
    "right": {"facecolors": "#9CC9E8"},
    "missed": {"facecolors": "#D55E00"},
    "wrong": {"facecolors": "#303030"},
}


def main(options) -> common.Figure:
    corners = common.load(options.results, "diagram_corners")
    corners = corners[corners.name == FACE]
    entries = diagram_chart.of_face(common.load(options.results, "diagram_coverage"), FACE)
    kinds = {
        "right": entries[entries.met & entries.direct],
        "missed": entries[entries.met & ~entries.direct],
        "wrong": entries[~entries.met & entries.direct],
    }
    figure, (space, flat) = plt.subplots(1, 2, figsize=(8.8, 3.7), width_ratios=[1, 1.9])
    diagram_from_above(space, corners)
    for kind, part in kinds.items():
        diagram_chart.cells(flat, part, linewidth=0.1, **LOOKS[kind])
    mapped = corners[["theta_deg", "phi_deg"]].to_numpy()
    diagram.polygon(flat, mapped, facecolor="none", linewidth=1.8, zorder=4)
    for point, name, offset in zip(mapped, "abc", ((0, -10), (0, 10), (8, -8))):
        diagram.dots(flat, point[None], markersize=5)
        diagram.note(flat, point, name, offset, fontsize=11)
    diagram_chart.true_edges(flat, corners[["x", "y", "z"]].to_numpy())
    diagram_chart.chart_axes(flat, "b) between the corners as mapped directly (table at 1°)")
    diagram_chart.turns(flat)
    flat.set(ylim=(mapped[:, 1].max() + 1.2, -0.5))
    handles = [
        common.key("edges as mapped directly", color=diagram.INK, linewidth=1.8),
        common.key("edges as they are", color="black", linewidth=1.3, linestyle="--"),
        Patch(color=LOOKS["right"]["facecolors"], label=f"entries filled, rightly: {len(kinds['right'])}"),
        Patch(color=LOOKS["missed"]["facecolors"], label=f"entries missed: {len(kinds['missed']):,}"),
        Patch(color=LOOKS["wrong"]["facecolors"], label=f"entries filled, wrongly: {len(kinds['wrong'])}"),
    ]
    figure.legend(handles=handles, loc="lower center", ncol=3, fontsize=9)
    figure.suptitle(f"A triangle round the pole (socket, {diagram.HIP}, coarse mesh)", fontsize=10.5)
    figure.subplots_adjust(left=0.02, right=0.985, top=0.84, bottom=0.31, wspace=0.14)
    return figure


def diagram_from_above(axes: plt.Axes, corners) -> None:
    """The triangle as seen along the z axis, and rays of the table every 30 degrees."""
    points = corners[["x", "y"]].to_numpy()
    reach = 1.12 * np.linalg.norm(points, axis=1).max()
    for theta in range(0, 360, 30):
        tip = reach * diagram.direction(90, theta)[:2]
        axes.plot(*np.array([(0, 0), tip]).T, color=common.THESIS_GREY, linewidth=0.7, zorder=1)
        if theta % 90 == 0:
            diagram.note(axes, tip, f"θ = {theta}°", 11 * tip / reach, fontsize=8.5)
    diagram.polygon(axes, points, facecolor="#9CC9E8", linewidth=1.8, alpha=0.75)
    for point, name in zip(points, "abc"):
        diagram.note(axes, point, name, 9 * point / np.linalg.norm(point), fontsize=11)
    diagram.dots(axes, np.zeros((1, 2)), color=diagram.POLE, markersize=6)
    diagram.note(axes, (0, 0), "pole, φ = 0°", (38, 11), fontsize=9, color=diagram.POLE)
    turn = np.linspace(0, 2 * np.pi, 9)[:, None]
    diagram.frame(axes, reach * np.hstack([np.cos(turn), np.sin(turn)]), room=0.12)
    diagram.title(axes, "a) in space, along the z axis")


common.run(main)
