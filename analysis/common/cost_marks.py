# SPDX-License-Identifier: GPL-3.0-or-later
"""The signs in a plot of error against cost: spread, bound, setting and failures of a line, the front, the roundings, and the
legend that explains them. A line is given as its rows of data/error_against_time.csv, with `x`, um, where each stands across.
"""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import pareto

FADED = "#c9c9c9"
FLOORS = {"float": 2.0**-24, "double": 2.0**-53}  # half an ulp of 1
MOST = 1e5  # um: larger errors stand here


def whiskers(axes: plt.Axes, group: pd.DataFrame, cost: str, colour: str) -> None:
    """The spread of the times, between their quartiles."""
    spread = {"query_ns": "query_iqr_ns", "build_ms": "build_iqr_ms"}.get(cost)
    if spread and np.isfinite(group[spread]).any():
        half = group[spread] / 2
        below = np.minimum(half, 0.9 * group[cost])  # a logarithmic axis has no zero
        axes.errorbar(
            group.x, group[cost], yerr=[below, half], fmt="none", ecolor=colour, capsize=2, linewidth=0.8
        )


def bounds(axes: plt.Axes, group: pd.DataFrame, cost: str, look: dict) -> None:
    """A hollow marker at the proven bound, joined to what was measured."""
    proven = group[np.isfinite(group.bound_um)]
    axes.hlines(proven[cost], proven.x, proven.bound_um, color=look["color"], linewidth=0.7, zorder=2)
    common.marks(
        axes,
        proven.bound_um,
        proven[cost],
        marker=look["marker"],
        markersize=4.5,
        markerfacecolor="white",
        markeredgecolor=look["color"],
        markeredgewidth=0.9,
        zorder=2,
    )


def steps(axes: plt.Axes, group: pd.DataFrame, cost: str, colour: str) -> None:
    """The setting beside the ends of a line of several, where it covers no other."""
    if len(group) < 2:
        return
    for row in group.iloc[[0, -1]].itertuples():
        taken = [text.get_window_extent() for text in axes.texts]
        text = common.note(axes, pareto.step_of(row), (row.x, getattr(row, cost)), (0, 5), ha="center", color=colour)
        if text.get_window_extent().count_overlaps(taken):
            text.remove()


def staircase(axes: plt.Axes, shown: pd.DataFrame, cost: str) -> None:
    """Left of it and below it is nothing."""
    on = shown[shown[f"{cost}_front"].eq(True)].sort_values("x")
    if on.empty:
        return
    x = np.append(on.x, MOST)
    y = np.append(on[cost], on[cost].iloc[-1])
    axes.step(x, y, where="post", color="black", linewidth=0.9, alpha=0.7, zorder=2)


def floors(axes: plt.Axes) -> None:
    """The rounding of a radius of 25 mm in float and double."""
    for name, share in FLOORS.items():
        axes.axvline(25e3 * share, color="#888888", linestyle=":", linewidth=0.8, zorder=0)
        axes.annotate(
            name,
            (25e3 * share, 0.01),
            xycoords=("data", "axes fraction"),
            xytext=(2, 0),
            textcoords="offset points",
            fontsize=common.SMALL,
            color="#666666",
        )


def failures(axes: plt.Axes, group: pd.DataFrame, cost: str) -> None:
    """A cross over what answered where there is no surface."""
    failed = group[group.false_hits > 0]
    common.marks(
        axes, failed.x, failed[cost], marker="x", color=common.COLOURS[1], markersize=5, markeredgewidth=0.9, zorder=4
    )


def legend(where: plt.Figure | plt.Axes, looks: dict, **place) -> None:
    """The coloured lines, and what the other signs mean; place is what matplotlib's legend() takes."""
    handles = [
        common.key(pareto.label(line), **look | {"markersize": 5.5}) for line, look in looks.items()
    ]
    handles += [
        common.key("another method or storage", color=FADED, marker="."),
        common.key(
            "another question: nearest point or pose", color=FADED, marker="o", markersize=4, markerfacecolor="white"
        ),
        common.key("also answers where no surface is", color=common.COLOURS[1], marker="x", linestyle="none"),
        common.key("Pareto front (radial distance)", color="black", linewidth=0.9),
        common.key("hollow, joined: proven bound", color="black", marker="o", markerfacecolor="white", linewidth=0.7),
    ]
    where.legend(handles=handles, **place)
