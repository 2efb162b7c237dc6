# SPDX-License-Identifier: GPL-3.0-or-later
"""Stiff and extreme cases: the error of every method over condition times unit roundoff. From
data/stability.csv, stability_detail.csv and stability_families.csv.

Name `stability-overview` gives every family a panel; `stability-FAMILY` draws one in detail.
"""

import textwrap

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
import stability
import stability_family
import stability_plot

ALL = "stability-overview"
COLUMNS = 4
TOP = 1e8  # of the overview: larger errors stand at its edge


def main() -> None:
    """Writes figures/NAME.svg, .png and .pdf."""
    options = common.arguments(__doc__, "--name")
    cases = stability.load(options.results)
    families = stability.families(options.results)
    common.style()
    if options.name == ALL:
        figure = draw_all(cases, families)
    else:
        family = options.name.removeprefix("stability-").replace("-", "_")
        if family not in families.index:
            raise common.Refused(f"stability_families.csv has no family {family}: run the experiment again")
        of_family = cases[cases.family == family]
        figure = stability_family.draw(of_family, families.loc[family], stability_plot.looks(cases))
    common.save_figure(figure, options.out, options.name)


def draw_all(cases: pd.DataFrame, families: pd.DataFrame) -> plt.Figure:
    """A panel a family, the same scale in all."""
    of_all = stability_plot.looks(cases)
    rows = -(-len(families) // COLUMNS)
    figure, grid = plt.subplots(rows, COLUMNS, figsize=(3.6 * COLUMNS, 2.9 * rows), squeeze=False)
    high = min(stability_plot.ceiling(cases), TOP)
    for axes, (name, family) in zip(grid.flat, families.iterrows()):
        of_family = cases[cases.family == name]
        stability_plot.band(axes, family.threshold, high)
        stability_plot.draw_errors(axes, of_family, "error_over_condition_u", of_all)
        failing = draw_failures(axes, of_family, of_all)
        stability_plot.ticks(axes, of_family)
        stability_plot.fewer_ticks(axes)
        axes.tick_params(axis="x", labelsize=7.5)
        axes.set_title(name.replace("_", " "), pad=8 + 9 * failing, fontsize=10.5)
        axes.set_xlabel(textwrap.fill(f"{family.knob}{stability_plot.unit_text(family)}", 50), fontsize=7.5)
    for axes in list(grid.flat)[len(families) :]:
        axes.set_visible(False)
    for axes in grid[:, 0]:
        axes.set_ylabel("error / (condition · u)")
    figure.tight_layout(h_pad=1.6)
    figure.suptitle(
        "Every method from harmless (left) to extreme (right): error over what the input's rounding may cost",
        x=0.01,
        ha="left",
        y=1.015,
        fontsize=12,
    )
    figure.legend(
        handles=stability_plot.legend_of(of_all), loc="upper left", bbox_to_anchor=(0.02, 0.0), ncols=4
    )
    return figure


def draw_failures(axes: plt.Axes, cases: pd.DataFrame, of_all: dict[str, dict]) -> int:
    """A cross above the axes where a line has failures, in its colour. Returns how many such lines."""
    failures = stability_plot.lines_of(cases, "failures")
    row = 0
    for name in failures.columns:
        places = np.flatnonzero(failures[name].to_numpy() > 0)
        if len(places) == 0:
            continue
        axes.plot(
            places,
            np.full(len(places), 1.04 + 0.055 * row),
            linestyle="none",
            marker="x",
            markersize=5,
            markeredgewidth=1.6,
            color=of_all[name]["color"],
            transform=axes.get_xaxis_transform(),
            clip_on=False,
        )
        row += 1
    return row


common.run(main)
