# SPDX-License-Identifier: GPL-3.0-or-later
# @name      limit-time
# @question  The error of the limits of all motions against their time: ours, and FCL, VTK and ODE in steps.
# @data      limit_time
"""Largest error against processor time, from meshes to the limits of all motions: a panel a joint, lower left is better."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import limit_time

ROW = 0.32  # decades between methods that are right: each has a row of its own
COLUMNS = 2


def main(options) -> common.Figure:
    table = limit_time.load(options.results)
    joints = list(dict.fromkeys(table.joint))
    methods = list(dict.fromkeys(table.line))
    looks = common.look(methods)
    rows = -(-len(joints) // COLUMNS)
    figure, grid = plt.subplots(rows, COLUMNS, figsize=(common.WIDTH, 3.5 * rows), sharex=True, sharey=True, squeeze=False)
    for axes, joint in zip(grid.flat, joints):
        draw(axes, table[table.joint == joint], methods, looks)
    for axes in grid.flat[len(joints) :]:
        axes.set_axis_off()
    scale(grid[0, 0], table, len(methods))
    for axes in grid.flat[max(0, len(joints) - COLUMNS) : len(joints)]:  # nothing is below them
        axes.tick_params(labelbottom=True)
        axes.set_xlabel("processor time of all motions, building included, ms")
    for axes in grid[:, 0]:
        axes.set_ylabel("largest error, degrees")
    keys = [common.key(method, **looks[method]) for method in methods]
    keys.append(common.key("hollow: scaled from fewer motions", color="black", marker="o", linestyle="", fillstyle="none"))
    figure.legend(handles=keys, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=len(keys), columnspacing=1.2)
    figure.tight_layout()
    return figure


def place(error: float, row: int) -> float:
    """Height of an error: its decades above what counts as right, or below it the row of the method."""
    return np.log10(error / limit_time.RIGHT) if error > limit_time.RIGHT else -ROW * (row + 1)


def draw(axes: plt.Axes, rows: pd.DataFrame, methods: list[str], looks: dict) -> None:
    """One line a method, its steps written at their points."""
    axes.set_title(limit_time.title(rows))
    if rows.missed.sum() == 0:
        axes.text(0.98, 0.95, "no contact missed in the motions asked", transform=axes.transAxes, ha="right", va="top")
    axes.axhspan(-ROW * (len(methods) + 0.6), 0, color="#f2f2f2", linewidth=0, zorder=0)
    for line, own in rows.groupby("line", sort=False):
        look, row = looks[line], methods.index(line)
        y = [place(error, row) for error in own.largest_error_deg]
        axes.plot(own.total_ms, y, color=look["color"], linestyle=look["linestyle"], zorder=2)
        for point, height in zip(own.itertuples(), y):
            face = "white" if point.extrapolated else look["color"]
            axes.plot(point.total_ms, height, marker=look["marker"], color=look["color"], markerfacecolor=face, zorder=3)
            common.note(axes, words(point), (point.total_ms, height), (0, 5), ha="center", color=look["color"])


def words(point) -> str:
    """The step, and how many contacts it missed."""
    if pd.isna(point.step_deg):
        return ""
    missed = f", misses {point.missed} of {point.asked}" if point.missed else ""
    return f"{point.step_deg:g}°{missed}"


def scale(axes: plt.Axes, table: pd.DataFrame, methods: int) -> None:
    """Errors in decades above a band of what is right."""
    most = max(0.1, table.largest_error_deg.max())
    decades = [k for k in range(-1, 3) if 10.0**k <= 1.5 * most]
    ticks = [place(10.0**k, 0) for k in decades]
    axes.set_yticks([-ROW * (methods + 1) / 2, *ticks], ["right\nto 0.02°", *(f"{10.0**k:g}" for k in decades)])
    axes.set(xscale="log", ylim=(-ROW * (methods + 0.6), place(1.5 * most, 0) + 0.15))
    axes.set_xlim(table.total_ms.min() / 2, table.total_ms.max() * 2)


common.run(main)
