# SPDX-License-Identifier: GPL-3.0-or-later
"""One panel of error against cost. What is wrong has the width of the axes, from a least error on; what is exact has a band of
its own at the left. Rows have error, cost, bound, group (a line each), name, and always (to be labelled on or off the front).
"""

from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import pareto

BAND = 1.2  # decades: width of what is exact
FADED = "#c4c4c4"
LINE = 12.0  # points between labels that would cover one another


@dataclass(frozen=True)
class Errors:
    """The axis of errors: what is less than `least` is exact, what is more than `most` stands at the end, and the axis goes to
    `shown` at least.
    """

    least: float
    most: float
    shown: float
    label: str

    def place(self, error: float) -> float:
        """Where an error stands across."""
        return BAND / 5 if error < self.least else BAND + np.log10(min(error, self.most) / self.least)


MICROMETRES = Errors(0.1, 1e4, 100.0, "largest error measured, µm")
DEGREES = Errors(1e-2, 1e3, 1.0, "largest error measured, degrees")


def grid_of(lines: int, height: float) -> tuple[plt.Figure, np.ndarray]:
    """Lines of two panels, each with room for its labels at the right."""
    figure, grid = plt.subplots(lines, 2, figsize=(common.WIDTH, height * lines), squeeze=False)
    inch = 1.0 / height / lines
    figure.subplots_adjust(left=0.075, right=0.86, bottom=0.75 * inch, top=1.0 - 0.3 * inch, wspace=0.72, hspace=0.35)
    figure.text(
        0.01,
        0.08 * inch,
        "black: Pareto front · line to a tick: proven bound · grey: other schemes, storages and settings",
        fontsize=common.SMALL,
    )
    return figure, grid


def draw(axes: plt.Axes, rows: pd.DataFrame, errors: Errors = MICROMETRES) -> None:
    """All of it but title and label of the cost."""
    rows = rows[np.isfinite(rows.error)].copy()
    rows["x"] = [errors.place(error) for error in rows.error]
    rows["exact"] = rows.error < errors.least
    rows["front"] = pareto.front(rows.error.clip(errors.least, None).to_numpy(), rows.cost.to_numpy())
    most = min(errors.most, max(errors.shown, 1.5 * rows.error.max()))
    axes.set(yscale="log", xlim=(-0.1, errors.place(most)), ylim=(rows.cost.min() / 2, rows.cost.max() * 2))
    axes.axvspan(-0.1, BAND, color="#f2f2f2", zorder=0, linewidth=0)
    decades = range(round(np.log10(errors.least)), int(np.floor(np.log10(most))) + 1)
    axes.set_xticks(
        [BAND / 4, *(errors.place(10.0**k) for k in decades)], ["exact", *(f"{10.0**k:g}" for k in decades)]
    )
    axes.set_xlabel(errors.label)
    for _, group in rows.groupby("group", sort=False):
        group = group.sort_values("x")
        axes.plot(group.x, group.cost, ".-", color=FADED, linewidth=0.7, markersize=4, zorder=1)
    chosen = choose(rows)
    names = list(dict.fromkeys(chosen.sort_values("cost", ascending=False).name))
    colours = {name: common.COLOURS[k % (len(common.COLOURS) - 1)] for k, name in enumerate(names)}
    for row in chosen.itertuples():
        colour = colours[row.name]
        axes.plot(row.x, row.cost, "o", color=colour, markersize=6, zorder=4)
        if np.isfinite(row.bound):
            axes.plot([row.x, errors.place(row.bound)], [row.cost] * 2, "-|", color=colour, linewidth=0.8, zorder=3)
    on = rows[rows.front].sort_values(["x", "cost"])
    end = np.append(on.x, axes.get_xlim()[1])
    axes.step(end, np.append(on.cost, on.cost.iloc[-1]), where="post", color="black", linewidth=1.1, zorder=2)
    label(axes, chosen, colours)


def choose(rows: pd.DataFrame) -> pd.DataFrame:
    """One row a name: its cheapest on the front, or its cheapest where it is always shown."""
    shown = rows[rows.front | rows.always]
    ranked = shown.sort_values(["front", "cost"], ascending=[False, True])
    return ranked.drop_duplicates("name")


def label(axes: plt.Axes, chosen: pd.DataFrame, colours: dict) -> None:
    """Names at the edge, or beside what is exact, moved up or down until none covers another."""
    figure = axes.figure
    for exact in (True, False):
        own = chosen[chosen.exact == exact].sort_values("cost")
        if own.empty:
            continue
        points = axes.transData.transform(np.column_stack([own.x, own.cost])) * 72.0 / figure.dpi
        heights = spread(points[:, 1])
        right = axes.bbox.x1 * 72.0 / figure.dpi + 5.0
        for row, at, height in zip(own.itertuples(), points, heights):
            leader = {"arrowstyle": "-", "color": colours[row.name], "linewidth": 0.6}
            common.note(
                axes,
                row.name,
                (row.x, row.cost),
                (7.0 if exact else right - at[0], height - at[1]),
                va="bottom" if exact else "center",
                color=colours[row.name],
                path_effects=common.drawing.HALO,
                zorder=5,
                arrowprops=None if exact else leader,
            )


def spread(heights: np.ndarray) -> np.ndarray:
    """Rising heights, moved as little as it takes to be LINE apart."""
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
