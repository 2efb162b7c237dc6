# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-34
# @question  What is drawn for triangles at the pole and across the seam (Figure 34).
# @data      diagram_corners diagram_chart diagram_coverage
"""Figure 34: what the thesis draws for a triangle that holds the pole inside, on an edge or as a corner, and for one
across the seam.
"""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.patches import Patch
from matplotlib.ticker import MultipleLocator

import common
from common import diagram, diagram_chart

CASES = {
    "pole_inside": "case 3: pole inside\none triangle",
    "pole_on_edge": "case 2: pole on an edge\nof two triangles",
    "pole_at_vertex": "case 1: pole a corner\nof six triangles",
}
SEAM = "seam"
FILLED = "#b4b4b4"


def main(options) -> common.Figure:
    corners, chart, coverage = (
        common.load(options.results, f"diagram_{name}") for name in ("corners", "chart", "coverage")
    )
    figure = plt.figure(figsize=(9.0, 8.4))
    grid = figure.add_gridspec(5, 3, width_ratios=[1, 1.5, 1.5], height_ratios=[1, 1, 1, 0.12, 1])
    grid.update(hspace=0.5, wspace=0.12)
    for row, (name, title) in enumerate(CASES.items()):
        space, flat = figure.add_subplot(grid[row, 0]), figure.add_subplot(grid[row, 1:])
        faces = diagram.faces(corners, name)
        regions = pieces(chart[chart.name == name])
        from_above(space, faces, name)
        entries = diagram_chart.of_face(coverage, name)
        diagram_chart.cells(flat, entries[entries.drawn], facecolors=FILLED, linewidth=0.1)
        draw_regions(flat, regions)
        for face in faces:
            diagram_chart.true_edges(flat, face)
        if name == "pole_inside":
            name_corners(flat, regions)
        diagram.title(space, title)
        diagram_chart.chart_axes(flat)
        flat.set(ylabel="φ, degrees", xlabel=diagram_chart.THETA if row == 2 else "")
        diagram_chart.turns(flat)
        flat.set(ylim=(max(region[:, 1].max() for region, _ in regions) + 2.4, -0.5))
        flat.yaxis.set_major_locator(MultipleLocator(5 if name == "pole_at_vertex" else 2))
    seam([figure.add_subplot(grid[4, column]) for column in range(3)], corners, chart, coverage)
    handles = [
        *(Patch(**look, edgecolor=diagram.INK, label=f"part {k + 1}") for k, look in enumerate(diagram.PARTS)),
        Patch(facecolor=FILLED, edgecolor="white", label="entries filled (table at 1°)"),
        common.key("edges as they are", color="black", linewidth=1.3, linestyle="--"),
    ]
    figure.legend(handles=handles, loc="lower center", ncol=5, fontsize=9)
    figure.suptitle(
        "Triangles at the pole and across the seam: what is drawn on the chart\n"
        f"({diagram.HIP}, coarse mesh; case 1: generated ball)",
        fontsize=10.5,
        y=0.985,
    )
    figure.subplots_adjust(left=0.02, right=0.985, top=0.885, bottom=0.105)
    return figure


def pieces(chart: pd.DataFrame) -> list[tuple[np.ndarray, int]]:
    """The quadrilaterals (4, 2) that pairs of flat triangles make, each with its number."""
    found = []
    for _, rows in chart.groupby("face", sort=False):
        triangles = rows[["theta_deg", "phi_deg"]].to_numpy().reshape(-1, 3, 2)
        for first, second in zip(triangles[0::2], triangles[1::2]):
            found.append((np.vstack([first[:2], first[2], second[2]]), len(found)))
    return found


def draw_regions(axes: plt.Axes, regions: list[tuple[np.ndarray, int]]) -> None:
    """Each region in the look of its number, on both sides of the seam."""
    for region, number in regions:
        diagram_chart.area(axes, region, alpha=0.6, zorder=3, **diagram.PARTS[number % len(diagram.PARTS)])


def name_corners(axes: plt.Axes, regions: list[tuple[np.ndarray, int]]) -> None:
    """a, b, c and the pole's three images above them, as in the thesis."""
    for number, (name, image) in enumerate((("a", "$p_2$"), ("b", "$p_0$"), ("c", "$p_1$"))):
        theta, phi = regions[number][0][0]
        diagram.dots(axes, np.array([(theta, phi), (theta, 0)]), markersize=5)
        diagram.note(axes, (theta, phi), name, (0, -9), fontsize=11)
        diagram.note(axes, (theta, 0), image, (0, 9), fontsize=11)


def from_above(axes: plt.Axes, faces: np.ndarray, name: str) -> None:
    """The triangles along the z axis, cut at the pole as on the chart."""
    number = 0
    for face in faces:
        for k in range(3):
            a, b = face[k, :2], face[(k + 1) % 3, :2]
            if abs(a[0] * b[1] - a[1] * b[0]) < 1e-3:  # an edge through the pole bounds nothing
                continue
            look = diagram.PARTS[number % len(diagram.PARTS)]
            diagram.polygon(axes, np.array([a, b, (0, 0)]), linewidth=0.8, linestyle="--", **look)
            number += 1
        diagram.polygon(axes, face[:, :2], facecolor="none", linewidth=1.6, zorder=4)
        if name == "pole_inside":
            for point, letter in zip(face[:, :2], "abc"):
                diagram.note(axes, point, letter, 9 * point / np.linalg.norm(point), fontsize=11)
    diagram.dots(axes, np.zeros((1, 2)), color=diagram.POLE, markersize=6)
    diagram.note(axes, (0, 0), "p", (7, -8), fontsize=11, color=diagram.POLE)
    diagram.frame(axes, faces[:, :, :2].reshape(-1, 2), room=0.08)


def seam(panels: list[plt.Axes], corners, chart, coverage) -> None:
    """The triangle across the meridian of azimuth 0: in space, mapped directly, and unrolled."""
    space, direct, flat = panels
    beside_meridian(space, diagram.faces(corners, SEAM)[0])
    entries = diagram_chart.of_face(coverage, SEAM)
    missed = entries[entries.met & ~entries.direct]
    wrong = entries[entries.direct & ~entries.met]
    diagram_chart.cells(direct, wrong, facecolors="#303030", linewidth=0.1)
    diagram_chart.cells(direct, missed, facecolors=diagram.POLE, linewidth=0.1)
    mapped = corners.loc[corners.name == SEAM, ["theta_deg", "phi_deg"]].to_numpy()
    diagram.polygon(direct, mapped, facecolor="none", linewidth=1.6, zorder=4)
    diagram_chart.chart_axes(
        direct, f"as mapped: {len(missed)} missed (orange),\n{len(wrong):,} filled wrongly (black)"
    )
    diagram_chart.turns(direct, step=90)
    unrolled = entries[entries.drawn].assign(column=lambda e: np.where(e.column > 180, e.column - 360, e.column))
    diagram_chart.cells(flat, unrolled, facecolors=FILLED, linewidth=0.3)
    region = chart.loc[chart.name == SEAM, ["theta_deg", "phi_deg"]].to_numpy()
    region[:, 0] -= 360 * np.round(region[:, 0].mean() / 360)
    diagram.polygon(flat, region, alpha=0.6, zorder=3, **diagram.PARTS[0])
    flat.axvline(0, color=diagram.POLE, linestyle="--", linewidth=1.4, zorder=5)
    diagram_chart.chart_axes(flat, f"unrolled: {len(unrolled)} entries,\non both sides of θ = 0°")
    flat.set(xlim=(-5, 22), ylabel="")
    direct.set_ylabel("φ, degrees")
    for axes in (direct, flat):
        axes.set(ylim=(mapped[:, 1].max() + 1.5, mapped[:, 1].min() - 1.5))


def beside_meridian(space: plt.Axes, face: np.ndarray) -> None:
    """A triangle as seen from outside, and the half circle of azimuth 0."""
    middle = face.mean(axis=0)
    right = np.cross([0, 0, 1], middle)
    right /= np.linalg.norm(right)
    up = np.cross(middle, right) / np.linalg.norm(middle)
    seen = face @ np.array([right, up]).T
    diagram.polygon(space, seen, linewidth=1.6, **diagram.PARTS[0])
    meridian = np.linalg.norm(middle) * diagram.direction(np.arange(46, 68), 0.0) @ np.array([right, up]).T
    space.plot(*meridian.T, color=diagram.POLE, linewidth=1.4, linestyle="--", zorder=5)
    diagram.note(space, meridian[-1], "θ = 0°", (0, -8), color=diagram.POLE)
    for point, letter in zip(seen, "abc"):
        way = point - seen.mean(axis=0)
        diagram.note(space, point, letter, 9 * way / np.linalg.norm(way), fontsize=11)
    diagram.frame(space, seen, room=0.12)
    diagram.title(space, "across the seam")


common.run(main)
