# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-30
# @question  The triangles of a mesh in space and on the chart of angles (Figure 30).
# @data      diagram_corners diagram_chart
"""Figure 30: the triangles of a closed mesh, in space and on the chart of angles."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.collections import PolyCollection

import common
from common import diagram, diagram_chart, sphere_view

MESH = "pair_ball"
EYE = sphere_view.view(20, 36)
SHOWN = {"A": (95, 75), "B": (118, 10), "C": (70, 0), "D": (8, 40)}  # near these angles, degrees
LOOKS = dict(zip(SHOWN, [*diagram.PARTS, {"facecolor": "#E7B8D3", "hatch": "xxxx"}]))


def main(options) -> common.Figure:
    faces = diagram.faces(common.load(options.results, "diagram_corners"), MESH)
    chart = common.load(options.results, "diagram_chart")
    chart = chart[chart.name == MESH]
    middles = faces.mean(axis=1) / np.linalg.norm(faces.mean(axis=1), axis=1)[:, None]
    chosen = {letter: int(np.argmax(middles @ diagram.direction(*angles))) for letter, angles in SHOWN.items()}
    chosen["C"] = across_seam(chart, middles @ diagram.direction(*SHOWN["C"]))
    figure, (space, flat) = plt.subplots(1, 2, figsize=(8.8, 3.9), width_ratios=[1, 1.75])
    draw_space(space, faces, chosen)
    draw_chart(flat, chart, chosen)
    diagram.title(space, f"a) {len(faces)} triangles in space")
    diagram_chart.chart_axes(flat, "b) the same on the chart: C lies across the seam, D at the pole")
    figure.suptitle("A ball with a bump, mapped to its angles (generated pair, coarse mesh)", fontsize=10.5)
    figure.subplots_adjust(left=0.01, right=0.985, top=0.84, bottom=0.14, wspace=0.14)
    return figure


def across_seam(chart: pd.DataFrame, nearness: np.ndarray) -> int:
    """The nearest of the faces that reach beyond 0 or 360 degrees on the chart."""
    reach = chart.groupby("face").theta_deg.agg(["min", "max"])
    beyond = reach[(reach["min"] < -1) | (reach["max"] > 361)].index
    return int(max(beyond, key=lambda face: nearness[face]))


def draw_space(axes: plt.Axes, faces: np.ndarray, chosen: dict[str, int]) -> None:
    """The near side, lit, and the axis of the poles."""
    normals = np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    near = normals @ EYE[2] > 0
    light = np.clip(normals @ EYE.T @ (sphere_view.LIGHT / np.linalg.norm(sphere_view.LIGHT)), 0, 1)
    grey = np.repeat((0.72 + 0.26 * light)[:, None], 3, axis=1)
    flat = faces @ EYE[:2].T
    axes.add_collection(
        PolyCollection(flat[near], facecolors=grey[near], edgecolors="#6a6a6a", linewidths=0.5, zorder=2)
    )
    for letter, face in chosen.items():
        diagram.polygon(axes, flat[face], zorder=3, **LOOKS[letter])
        diagram.note(axes, flat[face].mean(axis=0), letter, fontsize=10, weight="bold")
    eye = diagram.Eye(EYE)
    diagram.arrow(axes, eye.see([0, 0, 22]), eye.see([0, 0, 32]), "z, φ = 0°")
    diagram.arrow(axes, eye.see([23, 0, 0]), eye.see([46, 0, 0]), "x, θ = 0°")
    diagram.frame(axes, np.vstack([flat.reshape(-1, 2), eye.see([[0, 0, 36], [50, 0, 0]])]), room=0.03)


def draw_chart(axes: plt.Axes, chart: pd.DataFrame, chosen: dict[str, int]) -> None:
    """Every flat triangle, cut where it leaves the chart; those beyond the seam drawn on both sides."""
    letters = {face: letter for letter, face in chosen.items()}
    for (face, _), rows in chart.groupby(["face", "part"], sort=False):
        triangle = rows[["theta_deg", "phi_deg"]].to_numpy()
        look = {"facecolor": "#f4f4f4", "linewidth": 0.5, "edgecolor": "#6a6a6a", "zorder": 2}
        if face in letters:
            look = {**LOOKS[letters[face]], "linewidth": 0.9, "zorder": 3}
        diagram_chart.area(axes, triangle, **look)
    for letter, face in chosen.items():
        rows = chart[chart.face == face]
        place = (np.clip(rows.theta_deg.mean() % 360, 6, 354), rows.phi_deg.mean())
        places = [place] if letter != "C" else [(13, place[1]), (347, place[1])]
        for x, y in places:
            diagram.note(axes, (x, y), letter, fontsize=10, weight="bold")
    diagram_chart.turns(axes)
    axes.set(ylim=(180, 0), yticks=np.arange(0, 181, 30))


common.run(main)
