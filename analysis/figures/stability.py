# SPDX-License-Identifier: GPL-3.0-or-later
# @data      stability stability_detail stability_families
# @options   --name NAME
# @name      stability-overview
# @question  How large are errors in ill-conditioned and extreme cases, relative to what rounding explains?
# @name      stability-FAMILY
# @for       FAMILY in FAMILIES
# @question  Ill-conditioned and extreme cases: FAMILY.
"""Stiff and extreme cases: the error of every method over condition times unit roundoff.

Name `stability-overview` gives every family a panel; `stability-FAMILY` draws one in detail.
"""

import textwrap

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import stability, stability_family, stability_plot

ALL = "stability-overview"
COLUMNS = 5
TOP = 1e8  # of the overview: larger errors stand at its edge


def main(options) -> common.Figure:
    cases = stability.load(options.results)
    families = stability.families(options.results)
    if options.name == ALL:
        return draw_all(cases, families)
    family = options.name.removeprefix("stability-").replace("-", "_")
    if family not in families.index:
        raise common.Refused(f"stability_families.csv has no family {family}: run the experiment again")
    of_family = cases[cases.family == family]
    return stability_family.draw(of_family, families.loc[family], stability_plot.looks(cases))


def draw_all(cases: pd.DataFrame, families: pd.DataFrame) -> plt.Figure:
    """A panel a family, the same scale in all; what is turned, and how far, is in the figure of each."""
    of_all = stability_plot.looks(cases)
    rows = -(-len(families) // COLUMNS)
    figure, grid = plt.subplots(rows, COLUMNS, figsize=(common.WIDTH, 1.42 * rows), sharey=True, squeeze=False)
    high = min(stability_plot.ceiling(cases), TOP)
    for axes, (name, family) in zip(grid.flat, families.iterrows()):
        of_family = cases[cases.family == name]
        stability_plot.band(axes, family.threshold, high)
        stability_plot.draw_errors(axes, of_family, "error_over_condition_u", of_all)
        failing = draw_failures(axes, of_family, of_all)
        axes.set_xticks(range(len(stability.magnitudes(of_family))), [])
        axes.set_title(textwrap.fill(name.replace("_", " "), 20), pad=5 + 6 * failing, fontsize=9.5)
    for axes in list(grid.flat)[len(families) :]:
        axes.set_visible(False)
    for axes in list(grid.flat)[max(len(families) - COLUMNS, 0) : len(families)]:
        axes.set_xlabel("harmless → extreme", fontsize=common.SMALL)
    figure.supylabel("error / (condition · u)", fontsize=10)
    figure.tight_layout(h_pad=0.6, w_pad=0.3)
    draw_legend(figure, of_all, room=rows * COLUMNS - len(families))
    return figure


def draw_legend(figure: plt.Figure, of_all: dict[str, dict], room: int) -> None:
    """Beside the last panels where three are left empty, or else below."""
    beside = {
        "loc": "lower right",
        "bbox_to_anchor": (1.0, 0.0),
        "ncols": 2,
        "columnspacing": 1.2,
        "handlelength": 1.6,
    }
    below = {"loc": "upper left", "bbox_to_anchor": (0.02, 0.0), "ncols": 3}
    figure.legend(handles=stability_plot.legend_of(of_all), **(beside if room >= 3 else below))


def draw_failures(axes: plt.Axes, cases: pd.DataFrame, of_all: dict[str, dict]) -> int:
    """A cross above the axes where a line has failures, in its colour. Returns how many such lines."""
    failures = stability_plot.lines_of(cases, "failures")
    row = 0
    for name in failures.columns:
        places = np.flatnonzero(failures[name].to_numpy() > 0)
        if len(places) == 0:
            continue
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
        row += 1
    return row


common.run(main, "--name")
