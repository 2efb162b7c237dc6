# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-32
# @question  One triangle drawn into tables of three precisions (Figure 32).
# @data      diagram_chart diagram_coverage
"""Figure 32: one triangle of a socket drawn into tables of three precisions."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import diagram, diagram_chart

FACE = "plain"


def main(options) -> common.Figure:
    triangle = diagram_chart.drawn(common.load(options.results, "diagram_chart"), FACE)[0]
    coverage = common.load(options.results, "diagram_coverage")
    coverage = coverage[(coverage.name == FACE) & coverage.drawn]
    figure, panels = plt.subplots(1, 3, figsize=(8.8, 3.9), sharey=True)
    limits = (coverage.drawn_mm.min(), coverage.drawn_mm.max())
    colours = plt.get_cmap("gray")
    for letter, axes, precision in zip("abc", panels, sorted(coverage.precision_deg.unique())):
        entries = coverage[coverage.precision_deg == precision]
        draw(axes, triangle, entries, colours(plt.Normalize(*limits)(entries.drawn_mm)))
        diagram_chart.chart_axes(axes, f"{letter}) precision {precision:g}°: {len(entries)} entries")
    for axes in panels[1:]:
        axes.set_ylabel("")
    shades = plt.cm.ScalarMappable(plt.Normalize(*limits), colours)
    bar = figure.colorbar(shades, ax=panels, location="bottom", shrink=0.5, aspect=35, pad=0.2)
    bar.set_ticks(np.arange(26.85, 27, 0.05))
    bar.set_label("distance in the entry, mm")
    figure.suptitle(
        f"One triangle, drawn at three precisions (socket, {diagram.HIP}, coarse mesh)", fontsize=10.5, y=1.03
    )
    return figure


def draw(axes: plt.Axes, triangle: np.ndarray, entries: pd.DataFrame, shades: np.ndarray) -> None:
    """The entries as pixels, the triangle with the distances of its corners on top."""
    diagram_chart.cells(axes, entries, facecolors=shades, edgecolors=diagram.SOCKET, linewidth=0.3)
    diagram.polygon(axes, triangle[:, :2], facecolor="none", edgecolor=diagram.POLE, linewidth=1.6, zorder=4)
    middle = triangle[:, :2].mean(axis=0)
    for corner in triangle:
        way = (corner[:2] - middle) * [1, -1]
        offset = 15 * way / np.hypot(*way)
        diagram.note(axes, corner[:2], f"{corner[2]:.2f}", offset, fontsize=8.5, color=diagram.POLE)
    low, high = triangle[:, :2].min(axis=0) - 2.6, triangle[:, :2].max(axis=0) + 2.6
    axes.set(xlim=(low[0], high[0]), ylim=(high[1], low[1]), aspect="equal", xticks=range(115, 126, 5))
    axes.set_yticks(range(50, 64, 5))


common.run(main)
