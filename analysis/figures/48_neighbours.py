# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-48
# @question  The entries that a look-up on the helix reads (Figure 48).
# @data      helix_curve helix_neighbours
"""Figure 48: the four entries that a look-up on the helix reads, and travelled distance."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import sphere_view

AXES = ["x", "y", "z"]
CURVE, VERTEX, ENTRY, CROSSING = (common.COLOURS[i] for i in (0, 6, 1, 2))
NAMES = {"vertex": "v", "P_a": "$P_a$", "P_b": "$P_b$"} | {f"P_{i}": f"$P_{i}$" for i in range(4)}
OFFSETS = {
    "vertex": (10, -3),
    "P_a": (8, 8),
    "P_b": (8, -16),
    "P_0": (-4, 9),
    "P_1": (-2, 9),
    "P_2": (-8, -18),
    "P_3": (-2, -18),
}


def markers(point: str) -> dict:
    """How a point of the look-up is drawn."""
    if point == "vertex":
        return {"marker": "*", "color": VERTEX, "markersize": 13}
    if point in ("P_a", "P_b"):
        return {"marker": "D", "color": CROSSING, "markersize": 6.5}
    return {"marker": "o", "color": ENTRY, "markersize": 7.5}


def draw_helix(axes: plt.Axes, helix: pd.DataFrame, eye: np.ndarray, width: float) -> None:
    """Ball, curve and small entries."""
    sphere_view.draw_sphere(axes)
    sphere_view.draw_line(axes, helix[helix.kind == "curve"][AXES].to_numpy(), eye, color=CURVE, linewidth=width)
    entries = helix[helix.kind == "entry"][AXES].to_numpy()
    sphere_view.draw_points(axes, entries, eye, color=ENTRY, marker="o", markersize=3, markeredgewidth=0)


def draw_look_up(axes: plt.Axes, points: pd.DataFrame, eye: np.ndarray, labels: bool) -> None:
    """Vertex, crossings and entries, and the line of one theta from P_a over v to P_b."""
    ends = points.loc[["P_a", "vertex", "P_b"], AXES].to_numpy()
    axes.plot(*(ends @ eye.T)[:, :2].T, color=CROSSING, linestyle="--", linewidth=1.2, zorder=4)
    for point, row in points.iterrows():
        at = eye @ row[AXES].to_numpy(float)
        axes.plot(*at[:2], linestyle="none", zorder=6, markeredgecolor="white", markeredgewidth=0.8, **markers(point))
        if labels:
            common.note(axes, NAMES[point], at[:2], OFFSETS[point], fontsize=13, zorder=7)


def zoom(axes: plt.Axes, points: pd.DataFrame, eye: np.ndarray) -> None:
    """Limits round the points."""
    seen = points[AXES].to_numpy(float) @ eye.T
    middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
    reach = 0.75 * np.ptp(seen[:, :2], axis=0).max()
    axes.set(xlim=middle[0] + np.array([-reach, reach]), ylim=middle[1] + np.array([-reach, reach]))


def main(options) -> common.Figure:
    rows = common.load(options.results, "helix_neighbours")
    points = rows[rows.point != "path"].set_index("point")
    path = rows[rows.point == "path"]
    helix = common.load(options.results, "helix_curve")
    turns = helix.turns.min()
    helix = helix[helix.turns == turns]
    azimuth = np.degrees(np.arctan2(points.y["vertex"], points.x["vertex"]))
    eye = sphere_view.view(25, azimuth - 15)
    figure, panels = plt.subplots(1, 3, figsize=(12.6, 4.7))
    for axes in panels:
        draw_helix(axes, helix, eye, 1.0 if axes is not panels[1] else 1.8)
    draw_look_up(panels[0], points, eye, labels=False)
    draw_look_up(panels[1], points, eye, labels=True)
    zoom(panels[1], points, eye)
    sphere_view.draw_line(panels[2], path[AXES].to_numpy(), eye, color="black", linewidth=2.6)
    end = eye @ points.loc["P_b", AXES].to_numpy(float)
    panels[2].plot(*end[:2], zorder=6, markeredgecolor="white", linestyle="none", **markers("P_b"))
    common.note(panels[2], "$P_b$", end[:2], (8, -14), fontsize=13, zorder=7)
    panels[0].set_title(f"a) vertex v (star) on the helix, k = {turns}", loc="center")
    panels[1].set_title("b) its neighbours on the turns above and below", loc="center")
    panels[2].set_title(
        f"c) travelled distance of $P_b$: {points.travelled['P_b']:.2f} radii by Eq. 10", loc="center"
    )
    figure.tight_layout()
    return figure


common.run(main)
