# SPDX-License-Identifier: GPL-3.0-or-later
# @name      limit-time
# @question  How long do the limits of all motions take, from meshes on, and who misses a contact: ours, and other libraries in steps?
# @data      limit_time
"""Processor time from meshes to the limits of all motions, a panel a joint, a row a method and step; contacts missed are written."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import limit_time

COLUMNS = 2
WRONG = {"marker": "X", "color": "#A5300B", "markersize": 8}


def main(options) -> common.Figure:
    table = limit_time.load(options.results)
    table["row"] = [line if pd.isna(step) else f"{line}, steps of {step:g}°" for line, step in zip(table.line, table.step_deg)]
    table = table.sort_values("step_deg", ascending=False, na_position="first", kind="stable")
    names = [name for line in table.line.unique() for name in table.row[table.line == line].unique()]
    joints = list(dict.fromkeys(limit_time.load(options.results).joint))
    looks = common.look(list(table.line))
    lines = -(-len(joints) // COLUMNS)
    figure, grid = plt.subplots(
        lines, COLUMNS, figsize=(common.WIDTH, (0.24 * len(names) + 1.1) * lines), sharex=True, sharey=True, squeeze=False
    )
    grid[0, 0].set(xscale="log", xlim=(table.total_ms.min() / 2, table.total_ms.max() * 4))
    for axes, joint in zip(grid.flat, joints):
        draw(axes, table[table.joint == joint], names, looks)
    for axes in grid.flat[len(joints) :]:
        axes.set_axis_off()
    for axes in grid.flat[max(0, len(joints) - COLUMNS) : len(joints)]:  # nothing is below them
        axes.tick_params(labelbottom=True)
        axes.set_xlabel("processor time of all motions, building included, ms")
    keys = [
        common.key(f"right to {limit_time.RIGHT:g}°", color="black", marker="o", linestyle=""),
        common.key("misses contacts", linestyle="", **WRONG),
        common.key("hollow: scaled from fewer motions", color="black", marker="o", linestyle="", fillstyle="none"),
    ]
    figure.legend(handles=keys, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=len(keys))
    figure.suptitle("Time to the limits of all motions, and contacts missed", x=0.01, ha="left", fontsize=12)
    figure.tight_layout()
    return figure


def draw(axes: plt.Axes, rows: pd.DataFrame, names: list[str], looks: dict) -> None:
    """A row a method and step."""
    axes.set_title(limit_time.title(rows))
    for point in rows.itertuples():
        look = {key: looks[point.line][key] for key in ("color", "marker")}
        if point.largest_error_deg > limit_time.RIGHT:
            look = WRONG
            words = f"misses {point.missed} of {point.asked}, off by {common.digits(point.largest_error_deg, 2)}°"
            side = 1 if point.total_ms < np.sqrt(np.prod(axes.get_xlim())) else -1
            at = point.total_ms, names.index(point.row)
            common.note(axes, words, at, (8 * side, 0), va="center", ha="left" if side > 0 else "right", color=WRONG["color"])
        face = "white" if point.extrapolated else look["color"]
        axes.plot(point.total_ms, names.index(point.row), linestyle="", markerfacecolor=face, zorder=3, **look)
    axes.set(ylim=(len(names) - 0.4, -0.6))
    axes.set_yticks(range(len(names)), names)
    axes.tick_params(axis="y", length=0)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:,g}")


common.run(main)
