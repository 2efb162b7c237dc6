# SPDX-License-Identifier: GPL-3.0-or-later
"""One panel of error against cost: a line for each method with the settings written at its points, and proven bounds as ticks.
Rows have line, step (the words at a point), error, cost and bound.
"""

from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common

LINE = 10.5  # points between labels that would cover one another
NOTE = 6.5  # points of the words at a point


@dataclass(frozen=True)
class Errors:
    """The axis of errors. Values below `least` are drawn at `least`; the name of a line that ends beyond `near` is on the
    right."""

    least: float
    near: float
    label: str
    ticks: dict[float, str] | None = None  # of a logarithmic axis; without them it is linear
    most: float = np.inf  # where bounds are cut off


MICROMETRES = Errors(
    1e-3, 0.1, "largest error of a gap", {1e-3: "≤ 1 nm", 0.1: "0.1 µm", 10.0: "10 µm", 1e3: "1 mm"}, 2e4
)
DEGREES = Errors(1e-7, 1e-5, "largest error, degrees", {1e-7: "≤ 1e-7", 1e-5: "1e-5", 1e-3: "0.001", 0.1: "0.1", 10.0: "10"})
PERCENT = Errors(0.0, 0.2, "overlaps missed or invented, % of poses", most=100.0)


def grid_of(lines: int, height: float, foot: str) -> tuple[plt.Figure, np.ndarray]:
    """Rows of two panels, each with room for its labels on the right, and words below all of them."""
    figure, grid = plt.subplots(lines, 2, figsize=(common.WIDTH, height * lines), squeeze=False)
    inch = 1.0 / height / lines
    figure.subplots_adjust(left=0.07, right=0.865, bottom=0.85 * inch, top=1.0 - 0.3 * inch, wspace=0.68, hspace=0.32)
    figure.text(0.01, 0.06 * inch, foot, fontsize=common.SMALL)
    return figure, grid


def draw(axes: plt.Axes, rows: pd.DataFrame, errors: Errors, looks: dict) -> None:
    """Draws the panel without its title and the label of the cost."""
    rows = rows[np.isfinite(rows.error)].copy()
    rows["x"] = rows.error.clip(lower=errors.least)
    rows["bound"] = rows.bound.clip(errors.least, errors.most)
    axes.set(yscale="log", xscale="log" if errors.ticks else "linear", xlabel=errors.label)
    for line, group in rows.groupby("line", sort=False):
        look = looks[line]
        group = group.sort_values("x", ascending=False, kind="stable")
        axes.plot(group.x, group.cost, **look, markersize=4.5, linewidth=1.2, zorder=3)
        for row in group[np.isfinite(group.bound)].itertuples():
            axes.plot([row.x, row.bound], [row.cost] * 2, color=look["color"], linewidth=0.35, alpha=0.6, zorder=1)
            axes.plot(row.bound, row.cost, "|", color=look["color"], markersize=6, markeredgewidth=1.2, zorder=2)
    if errors.ticks:
        axes.set_xticks(list(errors.ticks), list(errors.ticks.values()))
        axes.set_xlim(errors.least / 2, max(axes.get_xlim()[1], 2 * max(errors.ticks)))
        axes.minorticks_off()
    else:
        axes.set_xlim(-1.0, max(10.0, 1.1 * rows.x.max()))
    low, high = axes.get_ylim()
    axes.set(xlim=axes.get_xlim(), ylim=(low / 1.3, high * 1.5))
    write_steps(axes, rows, looks)
    label(axes, rows, errors, looks)


def write_steps(axes: plt.Axes, rows: pd.DataFrame, looks: dict) -> None:
    """Writes the words at the points, the ends of a line first. Leaves out words that would cover others."""
    taken = []
    place = rows.groupby("line").cumcount()
    ends = (place == 0) | (rows.groupby("line").cumcount(ascending=False) == 0)
    for row in pd.concat([rows[ends], rows[~ends]]).itertuples():
        x, y = axes.transData.transform((row.x, row.cost)) * 72.0 / axes.figure.dpi
        width = 0.65 * NOTE * len(row.step)
        for rise in (4.0, -9.5):
            box = (x - width / 2, y + rise, x + width / 2, y + rise + NOTE)
            if all(box[0] > b[2] or box[2] < b[0] or box[1] > b[3] or box[3] < b[1] for b in taken):
                colour = looks[row.line]["color"]
                common.note(axes, row.step, (row.x, row.cost), (0, rise), ha="center", fontsize=NOTE, color=colour, zorder=4)
                taken.append(box)
                break


def label(axes: plt.Axes, rows: pd.DataFrame, errors: Errors, looks: dict) -> None:
    """Writes names on the right, or beside what is near to exact, moved up or down until none covers another."""
    figure = axes.figure
    ends = rows.sort_values("x", kind="stable").drop_duplicates("line", keep="last")
    for near in (True, False):
        own = ends[(ends.x < errors.near) == near].sort_values("cost")
        if own.empty:
            continue
        points = axes.transData.transform(np.column_stack([own.x, own.cost])) * 72.0 / figure.dpi
        heights = spread(points[:, 1])
        right = axes.bbox.x1 * 72.0 / figure.dpi + 5.0
        for row, at, height in zip(own.itertuples(), points, heights):
            colour = looks[row.line]["color"]
            leader = {"arrowstyle": "-", "color": colour, "linewidth": 0.5, "alpha": 0.7}
            common.note(
                axes,
                row.line,
                (row.x, row.cost),
                (8.0 if near else right - at[0], height - at[1]),
                va="center",
                color=colour,
                path_effects=common.drawing.HALO,
                zorder=5,
                arrowprops=None if near else leader,
            )


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
