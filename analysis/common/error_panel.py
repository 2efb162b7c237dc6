# SPDX-License-Identifier: GPL-3.0-or-later
"""One panel of error against cost: a line a method, proven bounds as ticks. Rows have line, error, cost and bound, where lines
are named, name, and where steps are written, step.
"""

import math
from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common

LINE = 11.0  # points between names that would cover one another
NOTE = 7.0  # points, the size of a step


@dataclass(frozen=True)
class Errors:
    """The axis of errors: what is less than `least` stands there."""

    least: float
    label: str
    ticks: dict[float, str] | None = None  # of a logarithmic axis; without them it is linear
    most: float = np.inf  # where bounds are cut off


MICROMETRES = Errors(1e-3, "largest error of a gap", {1e-3: "≤ 1 nm", 0.1: "0.1 µm", 10.0: "10 µm", 1e3: "1 mm"}, 2e4)
DEGREES = Errors(1e-7, "largest error, degrees", {1e-7: "≤ 1e-7", 1e-5: "1e-5", 1e-3: "0.001", 0.1: "0.1", 10.0: "10"})
PERCENT = Errors(0.0, "overlaps missed or invented, % of poses", most=100.0)


def grid_of(title: str, foot: str, height: float, below: float, wide: float) -> tuple[plt.Figure, np.ndarray]:
    """Two lines of two panels of that height in inches, `below` inches for words and a legend under them; `wide` is the share of
    a panel's width that is kept free at its right.
    """
    whole = 2 * height + below + 0.3
    figure, grid = plt.subplots(2, 2, figsize=(common.WIDTH, whole), squeeze=False)
    right = 1.0 - 0.43 * wide
    figure.subplots_adjust(left=0.075, right=right, bottom=(below + 0.5) / whole, top=1.0 - 0.55 / whole, wspace=0.2 + wide, hspace=0.34)
    figure.suptitle(title, x=0.01, y=1.0 - 0.02 / whole, ha="left", va="top", fontsize=12)
    figure.text(0.01, 0.05 / whole, foot, fontsize=common.SMALL, va="bottom")
    return figure, grid


def draw(axes: plt.Axes, rows: pd.DataFrame, errors: Errors, looks: dict) -> None:
    """All of it but title, label of the cost, and names."""
    rows = placed(rows, errors)
    axes.set(yscale="log", xscale="log" if errors.ticks else "linear", xlabel=errors.label)
    for line, group in rows.groupby("line", sort=False):
        look = looks[line]
        axes.plot(group.x, group.cost, **look, markersize=5, linewidth=1.2, zorder=3)
        bounded = group[np.isfinite(group.bound)]
        axes.plot(bounded.bound, bounded.cost, "|", linestyle=":", color=look["color"], markersize=6, linewidth=0.8, zorder=2)
    if errors.ticks:
        axes.set_xticks(list(errors.ticks), list(errors.ticks.values()))
        axes.set_xlim(errors.least / 2, max(axes.get_xlim()[1], 2 * max(errors.ticks)))
        axes.minorticks_off()
    else:
        axes.set_xlim(-1.0, max(10.0, 1.1 * rows.x.max()))
    low, high = axes.get_ylim()
    span = high / low
    axes.set(xlim=axes.get_xlim(), ylim=(low / span**0.12, high * span**0.03))
    costs(axes)


def placed(rows: pd.DataFrame, errors: Errors) -> pd.DataFrame:
    """What has an error, from coarse to fine along each line; x is its place."""
    rows = rows[np.isfinite(rows.error)]
    rows = rows.assign(x=rows.error.clip(lower=errors.least), bound=rows.bound.clip(errors.least, errors.most))
    return rows.sort_values("x", ascending=False, kind="stable")


def costs(axes: plt.Axes) -> None:
    """Ticks of a logarithmic axis as numbers: 1, 2, 5 in each decade, or the decades where those would be too many."""
    low, high = axes.get_ylim()
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    for steps in ((1, 2, 5), (1,)):
        ticks = [step * 10.0**k for k in decades for step in steps if low <= step * 10.0**k <= high]
        if len(ticks) <= 7:
            break
    axes.set_yticks(ticks, [f"{tick:,.10g}" for tick in ticks])
    axes.minorticks_off()


def write_steps(axes: plt.Axes, rows: pd.DataFrame, errors: Errors, looks: dict) -> None:
    """The step of each point beside it, the ends of lines first; left out where it would cover a point or another step."""
    rows = placed(rows[rows.step != ""], errors)
    marks = axes.transData.transform(placed(rows, errors)[["x", "cost"]]) * 72.0 / axes.figure.dpi
    taken = [(x - 3.0, y - 3.0, x + 3.0, y + 3.0) for x, y in marks]
    ends = (rows.groupby("line").cumcount() == 0) | (rows.groupby("line").cumcount(ascending=False) == 0)
    order = np.concatenate([np.flatnonzero(ends), np.flatnonzero(~ends)])
    for row, (x, y) in zip(rows.iloc[order].itertuples(), marks[order]):
        width = 0.6 * NOTE * len(row.step)
        for left, low in ((x - width / 2, y + 4.0), (x - width / 2, y - 4.0 - NOTE), (x + 5.0, y - NOTE / 2), (x - 5.0 - width, y - NOTE / 2)):
            box = (left, low, left + width, low + NOTE)
            if all(box[0] > b[2] or box[2] < b[0] or box[1] > b[3] or box[3] < b[1] for b in taken):
                look = {"ha": "center", "va": "center", "fontsize": NOTE, "color": looks[row.line]["color"]}
                common.note(axes, row.step, (row.x, row.cost), (left + width / 2 - x, low + NOTE / 2 - y), **look)
                taken.append(box)
                break


def name_lines(axes: plt.Axes, rows: pd.DataFrame, errors: Errors, looks: dict, apart: bool = False) -> None:
    """The name of each line at the right of its last point; in the right half of the panel below that point or, if `apart`, at the
    right of the panel. Moved up or down until none covers another.
    """
    ends = placed(rows, errors).sort_values(["x", "cost"], ascending=[False, True]).drop_duplicates("line").sort_values("cost")
    points = axes.transData.transform(np.column_stack([ends.x, ends.cost])) * 72.0 / axes.figure.dpi
    left, right = axes.bbox.x0 * 72.0 / axes.figure.dpi, axes.bbox.x1 * 72.0 / axes.figure.dpi
    below = (points[:, 0] > (left + right) / 2) & (not apart)
    for row, at, height, lower in zip(ends.itertuples(), points, spread(points[:, 1] - LINE * below), below):
        look = {"va": "center", "color": looks[row.line]["color"], "ha": "right" if lower else "left", "path_effects": common.drawing.HALO}
        away = 4.0 if lower else 8.0
        if apart and at[0] > (left + right) / 2:
            away = right + 5.0 - at[0]
            look["arrowprops"] = {"arrowstyle": "-", "color": look["color"], "linewidth": 0.5, "shrinkB": 4}
        common.note(axes, row.name, (row.x, row.cost), (away, height - at[1]), **look)


def spread(heights: np.ndarray) -> np.ndarray:
    """Moves ascending heights as little as possible until they are at least LINE apart."""
    placed = heights.astype(float).copy()
    for _ in range(200):
        gaps = np.diff(placed)
        close = np.flatnonzero(gaps < LINE - 1e-6)
        if close.size == 0:
            break
        for k in close:
            push = (LINE - (placed[k + 1] - placed[k])) / 2
            placed[k] -= push
            placed[k + 1] += push
    return placed
