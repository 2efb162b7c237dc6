# SPDX-License-Identifier: GPL-3.0-or-later
"""One family of stiff and extreme cases in detail: errors forward and backward, look-ups against their bounds, failures."""

import textwrap

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import stability, stability_plot


def draw(cases: pd.DataFrame, family: pd.Series, of_all: dict[str, dict]) -> plt.Figure:
    """Forward errors, backward errors, look-ups against their bounds, and how often who failed."""
    of_all = {name: look for name, look in of_all.items() if (cases.who == name).any()}
    figure, grid = plt.subplots(2, 2, figsize=(11, 7.6))
    high = stability_plot.ceiling(cases)
    for axes, column, title in (
        (grid[0, 0], "error_over_condition_u", "Forward error / (condition number · u), u: unit roundoff"),
        (grid[0, 1], "backward_error_over_u", "Backward error over u: |e| / (r tan ψ u), tan ψ ≥ 1"),
    ):
        stability_plot.band(axes, family.threshold, high)
        stability_plot.draw_errors(axes, cases, column, of_all)
        stability_plot.ticks(axes, cases)
        axes.set_title(title)
    if cases.backward_error_over_u.isna().all():
        say_nothing(grid[0, 1], "no face is so steep here")
    draw_bounds(grid[1, 0], cases, of_all)
    draw_counts(grid[1, 1], cases)
    for axes in grid.flat:
        stability_plot.fewer_ticks(axes)
        axes.set_xlabel(textwrap.fill(f"{family.parameter}{stability_plot.unit_text(family)}", 70), fontsize=8.5)
    figure.tight_layout(h_pad=2)
    title = cases.family.iloc[0].replace("_", " ").capitalize()
    heading = textwrap.wrap(f"{title}. Expected: {family.expected}", 130)
    figure.suptitle("\n".join(heading), x=0.01, ha="left", y=1.0 + 0.026 * len(heading), fontsize=11)
    figure.legend(handles=stability_plot.legend_of(of_all), loc="upper left", bbox_to_anchor=(0.02, 0.0), ncols=3)
    return figure


def say_nothing(axes: plt.Axes, why: str) -> None:
    """Where a panel has nothing to show."""
    axes.text(0.5, 0.5, why, transform=axes.transAxes, ha="center", va="center", color=common.THESIS_GREY)


def draw_bounds(axes: plt.Axes, cases: pd.DataFrame, of_all: dict[str, dict]) -> None:
    """The largest share of its proven bound that a look-up of any table takes."""
    tables = cases[cases.bound_um.notna() & cases.error_um.notna()].copy()
    axes.set_title("Error of look-ups over its proven bound, worst table")
    stability_plot.ticks(axes, cases)
    if tables.empty:
        say_nothing(axes, "no table is looked up here")
        return
    tables["share"] = tables.error_um / tables.bound_um.where(tables.bound_um > 0)
    shares = stability_plot.lines_of(tables, "share").reindex(stability.magnitudes(cases))
    axes.set_yscale("log")
    axes.set_ylim(1e-4, 10)
    axes.axhspan(1e-4, 1, color=stability_plot.BAND, zorder=0)
    axes.axhline(1, color="black", linewidth=0.8)
    for name in shares.columns:
        axes.plot(np.arange(len(shares)), shares[name].clip(lower=1e-4), **of_all[name], clip_on=False)
    axes.set_ylabel("above 1 the bound does not hold")
    axes.minorticks_off()


def draw_counts(axes: plt.Axes, cases: pd.DataFrame) -> None:
    """Failures of each line at each magnitude, as numbers; dots for none."""
    values = stability.magnitudes(cases)
    names = [name for name in cases.who.cat.categories if (cases.who == name).any()]
    axes.set_title("Failures (in brackets: cases refused)")
    axes.set_yticks(range(len(names)), names)
    axes.set_ylim(len(names) - 0.5, -0.5)
    axes.grid(False)
    axes.tick_params(axis="y", length=0)
    stability_plot.ticks(axes, cases)
    for i, name in enumerate(names):
        for k, magnitude in enumerate(values):
            cell = cases[(cases.who == name) & (cases.magnitude == magnitude)]
            failures, refused = int(cell.failures.sum()), int(cell.refused.sum())
            text = f"{failures:,}" if failures else "·"
            if refused:
                text = f"({refused})" if not failures else f"{text} ({refused})"
            colour = common.COLOURS[1] if failures else "black"
            weight = "bold" if failures else "normal"
            axes.text(k, i, text, ha="center", va="center", fontsize=7.5, color=colour, fontweight=weight)
