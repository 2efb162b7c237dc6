# SPDX-License-Identifier: GPL-3.0-or-later
"""Stiff and extreme cases: the error of every method over condition times unit roundoff. From
data/stability.csv, stability_detail.csv and stability_families.csv.

Name `stability-overview` gives every family a panel; `stability-FAMILY` draws one in detail.
"""

import textwrap

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

import common
import stability

ALL = "stability-overview"
FLOOR = 1e-3  # smaller errors, and none at all, are drawn here
BAND = "#dceefb"  # errors of order one
COLUMNS = 4
TOP = 1e8  # of the overview: larger errors stand at its edge
MOST_TICKS = 8  # of a panel of it
LIMIT = (0, (5, 3))  # the dashes of a threshold
FAILURES = "failures: hits missed or false, wrong values"


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
        figure = draw_one(of_family, families.loc[family], looks(cases))
    common.save_figure(figure, options.out, options.name)


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


def ticks(axes: plt.Axes, cases: pd.DataFrame) -> None:
    """One place a magnitude."""
    texts = [stability.power(value) for value in stability.magnitudes(cases)]
    axes.set_xticks(range(len(texts)), texts)
    axes.set_xlim(-0.4, len(texts) - 0.6)


def fewer_ticks(axes: plt.Axes) -> None:
    """Text at every second or third place, where a panel is narrow."""
    texts = [label.get_text() for label in axes.get_xticklabels()]
    step = -(-len(texts) // MOST_TICKS)
    axes.set_xticklabels([text if k % step == 0 else "" for k, text in enumerate(texts)])


def draw_errors(axes: plt.Axes, cases: pd.DataFrame, column: str, of_all: dict[str, dict]) -> None:
    """A line a method, between the floor and the ceiling of the axes; what is beyond stands at its edge."""
    worst = lines_of(cases, column)
    low, high = axes.get_ylim()
    for name in worst.columns:
        values = worst[name].clip(lower=low, upper=high)
        axes.plot(np.arange(len(values)), values, **of_all[name], clip_on=False)


def draw_failures(axes: plt.Axes, cases: pd.DataFrame, of_all: dict[str, dict]) -> int:
    """A cross above the axes where a line has failures, in its colour. Returns how many such lines."""
    failures = lines_of(cases, "failures")
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


def band(axes: plt.Axes, threshold: float, high: float) -> None:
    """Errors of order one, and the threshold."""
    axes.set_yscale("log")
    axes.set_ylim(FLOOR, high)
    axes.axhspan(FLOOR, 1, color=BAND, zorder=0)
    axes.axhline(threshold, color="black", linewidth=0.8, linestyle=LIMIT)
    axes.minorticks_off()


def legend_of(of_all: dict[str, dict]) -> list:
    """The lines, and what else is drawn."""
    lines = [Line2D([], [], **look, label=name) for name, look in of_all.items()]
    return lines + [
        Patch(color=BAND, label="as good as the input: one rounding of it costs as much"),
        Line2D([], [], color="black", linewidth=0.8, linestyle=LIMIT, label="allowed of ours (analysis)"),
        Line2D([], [], color="black", marker="x", linestyle="none", label=FAILURES),
    ]


def ceiling(cases: pd.DataFrame) -> float:
    """A power of ten above all that is finite."""
    values = cases.error_over_condition_u.replace(np.inf, np.nan)
    return 10.0 ** np.ceil(np.log10(max(values.max(), 1e3)) + 0.3)


def draw_all(cases: pd.DataFrame, families: pd.DataFrame) -> plt.Figure:
    """A panel a family, the same scale in all."""
    of_all = looks(cases)
    rows = -(-len(families) // COLUMNS)
    figure, grid = plt.subplots(rows, COLUMNS, figsize=(3.6 * COLUMNS, 2.9 * rows), squeeze=False)
    high = min(ceiling(cases), TOP)
    for axes, (name, family) in zip(grid.flat, families.iterrows()):
        of_family = cases[cases.family == name]
        band(axes, family.threshold, high)
        draw_errors(axes, of_family, "error_over_condition_u", of_all)
        failing = draw_failures(axes, of_family, of_all)
        ticks(axes, of_family)
        fewer_ticks(axes)
        axes.tick_params(axis="x", labelsize=7.5)
        axes.set_title(name.replace("_", " "), pad=8 + 9 * failing, fontsize=10.5)
        axes.set_xlabel(textwrap.fill(f"{family.knob}{unit_text(family)}", 50), fontsize=7.5)
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
    figure.legend(handles=legend_of(of_all), loc="upper left", bbox_to_anchor=(0.02, 0.0), ncols=4)
    return figure


def unit_text(family: pd.Series) -> str:
    """The unit in brackets, where there is one."""
    return "" if family.unit in ("1", "") else f" ({family.unit})"


def draw_one(cases: pd.DataFrame, family: pd.Series, of_all: dict[str, dict]) -> plt.Figure:
    """Forward errors, backward errors, look-ups against their bounds, and how often who failed."""
    of_all = {name: look for name, look in of_all.items() if (cases.who == name).any()}
    figure, grid = plt.subplots(2, 2, figsize=(11, 7.6))
    high = ceiling(cases)
    for axes, column, title in (
        (grid[0, 0], "error_over_condition_u", "Forward error over condition and unit roundoff u"),
        (grid[0, 1], "backward_error_over_u", "Backward error over u: |e| / (r tan ψ u), tan ψ ≥ 1"),
    ):
        band(axes, family.threshold, high)
        draw_errors(axes, cases, column, of_all)
        ticks(axes, cases)
        axes.set_title(title)
    if cases.backward_error_over_u.isna().all():
        say_nothing(grid[0, 1], "no face is so steep here")
    draw_bounds(grid[1, 0], cases, of_all)
    draw_counts(grid[1, 1], cases)
    for axes in grid.flat:
        fewer_ticks(axes)
        axes.set_xlabel(textwrap.fill(f"{family.knob}{unit_text(family)}", 70), fontsize=8.5)
    figure.tight_layout(h_pad=2)
    title = cases.family.iloc[0].replace("_", " ").capitalize()
    heading = textwrap.wrap(f"{title}. Expected: {family.expected}", 130)
    figure.suptitle("\n".join(heading), x=0.01, ha="left", y=1.0 + 0.026 * len(heading), fontsize=11)
    figure.legend(handles=legend_of(of_all), loc="upper left", bbox_to_anchor=(0.02, 0.0), ncols=3)
    return figure


def say_nothing(axes: plt.Axes, why: str) -> None:
    """Where a panel has nothing to show."""
    axes.text(0.5, 0.5, why, transform=axes.transAxes, ha="center", va="center", color=common.THESIS_GREY)


def draw_bounds(axes: plt.Axes, cases: pd.DataFrame, of_all: dict[str, dict]) -> None:
    """The largest share of its proven bound that a look-up of any table takes."""
    tables = cases[cases.bound_um.notna() & cases.error_um.notna()].copy()
    axes.set_title("Error of look-ups over its proven bound, worst table")
    ticks(axes, cases)
    if tables.empty:
        say_nothing(axes, "no table is looked up here")
        return
    tables["share"] = tables.error_um / tables.bound_um.where(tables.bound_um > 0)
    shares = lines_of(tables, "share").reindex(stability.magnitudes(cases))
    axes.set_yscale("log")
    axes.set_ylim(1e-4, 10)
    axes.axhspan(1e-4, 1, color=BAND, zorder=0)
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
    ticks(axes, cases)
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


common.run(main)
