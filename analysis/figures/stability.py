# SPDX-License-Identifier: GPL-3.0-or-later
# @name      stability-overview
# @question  How large are errors in ill-conditioned and extreme cases, relative to what rounding explains?
# @data      stability stability_detail stability_families
"""Stiff and extreme cases: the error of every method over condition times unit roundoff, a panel a family."""

import textwrap

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.patches import Patch

import common
from common import stability

COLUMNS = 5
FLOOR, TOP = 1e-3, 1e8  # smaller errors, and none at all, are drawn at the floor, larger ones at the edge
BAND = "#dceefb"  # errors of order one
LIMIT = (0, (5, 3))  # the dashes of a threshold


def main(options) -> common.Figure:
    """The same scale in all panels."""
    cases = stability.load(options.results)
    families = stability.families(options.results)
    of_all = looks(cases)
    rows = -(-len(families) // COLUMNS)
    figure, grid = plt.subplots(rows, COLUMNS, figsize=(common.WIDTH, 1.42 * rows), sharey=True, squeeze=False)
    for axes, (name, family) in zip(grid.flat, families.iterrows()):
        of_family = cases[cases.family == name]
        draw_errors(axes, of_family, family.threshold, of_all)
        failing = draw_failures(axes, of_family, of_all)
        axes.set_xticks(range(len(stability.magnitudes(of_family))), [])
        axes.set_title(textwrap.fill(name.replace("_", " "), 20), pad=5 + 6 * failing, fontsize=9.5)
    for axes in list(grid.flat)[len(families) :]:
        axes.set_visible(False)
    for axes in list(grid.flat)[max(len(families) - COLUMNS, 0) : len(families)]:
        axes.set_xlabel("harmless → extreme", fontsize=common.SMALL)
    figure.supylabel("error / (condition · u)", fontsize=10)
    figure.tight_layout(h_pad=0.6, w_pad=0.3)
    figure.legend(handles=legend_of(of_all), loc="upper left", bbox_to_anchor=(0.02, 0.0), ncols=3)
    return figure


def looks(cases: pd.DataFrame) -> dict[str, dict]:
    """Ours are full, others hollow."""
    found = common.look(list(cases.who.cat.categories))
    for name, look in found.items():
        look |= {"linewidth": 1.2, "markersize": 5}
        if name not in stability.OURS.values():
            look |= {"markerfacecolor": "white", "linewidth": 0.9}
    return found


def lines_of(cases: pd.DataFrame, column: str) -> pd.DataFrame:
    """The worst of the methods behind each line: a row a magnitude, a column a line."""
    worst = cases.pivot_table(index="magnitude", columns="who", values=column, aggfunc="max", observed=True)
    return worst.reindex(stability.magnitudes(cases))


def draw_errors(axes: plt.Axes, cases: pd.DataFrame, threshold: float, of_all: dict[str, dict]) -> None:
    """A line a method, errors of order one behind them, and the threshold."""
    axes.set(yscale="log", ylim=(FLOOR, TOP))
    axes.axhspan(FLOOR, 1, color=BAND, zorder=0)
    axes.axhline(threshold, color="black", linewidth=0.8, linestyle=LIMIT)
    axes.minorticks_off()
    worst = lines_of(cases, "error_over_condition_u").clip(lower=FLOOR, upper=TOP)
    for name in worst.columns:
        axes.plot(np.arange(len(worst)), worst[name], **of_all[name], clip_on=False)


def draw_failures(axes: plt.Axes, cases: pd.DataFrame, of_all: dict[str, dict]) -> int:
    """A cross above the axes where a line has failures, in its colour. Returns how many such lines."""
    failures = lines_of(cases, "failures") > 0
    failing = [name for name in failures.columns if failures[name].any()]
    for row, name in enumerate(failing):
        places = np.flatnonzero(failures[name])
        common.marks(
            axes,
            places,
            np.full(len(places), 1.04 + 0.055 * row),
            marker="x",
            markersize=5,
            markeredgewidth=1.6,
            color=of_all[name]["color"],
            transform=axes.get_xaxis_transform(),
            clip_on=False,
        )
    return len(failing)


def legend_of(of_all: dict[str, dict]) -> list:
    """The lines, and what else is drawn."""
    lines = [common.key(name, **look) for name, look in of_all.items()]
    return lines + [
        Patch(color=BAND, label="as good as the input, rounded once"),
        common.key("allowed of ours (analysis)", color="black", linewidth=0.8, linestyle=LIMIT),
        common.key("hits missed or false, wrong values", color="black", marker="x", linestyle="none"),
    ]


common.run(main)
