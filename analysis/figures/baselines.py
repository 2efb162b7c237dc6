# SPDX-License-Identifier: GPL-3.0-or-later
# @name      baseline-cost
# @question  What the methods of Section 3.6 lose and get wrong, against memory.
# @data      baselines
"""What the methods of Section 3.6 lose, and how often they are wrong, against memory."""

import matplotlib.pyplot as plt
import pandas as pd

import common

FLOOR = 0.02  # per cent: where none is drawn on a logarithmic axis


def main(options) -> common.Figure:
    table = common.load(options.results, "baselines")
    table = table[table.joint == table.joint.iloc[0]]
    looks = common.look(list(table.method.unique()))
    figure, axes = plt.subplots(2, 2, figsize=(7.2, 6.2))
    lost, wrong = table.faces_missed / table.faces, (table.false_touches + table.missed_touches) / table.poses
    draw(axes[0, 0], table, looks, floored(lost))
    axes[0, 0].set(ylabel="of the ball's triangles, %", title="Triangles that no entry samples")
    draw(axes[0, 1], table, looks, floored(wrong))
    axes[0, 1].set(ylabel="of the poses, %", title="Wrong answers near a contact")
    for panel in axes[0]:
        ticks(panel)
    draw(axes[1, 0], table, looks, table.rms_error_mm.where(table.rms_error_mm > 1e-9))  # of those that interpolate
    axes[1, 0].set(ylabel="root mean square, mm", title="Error of a distance")
    building(axes[1, 1], table, looks)
    figure.legend(*axes[0, 1].get_legend_handles_labels(), loc="lower center", ncol=4, fontsize=8)
    figure.tight_layout(rect=(0, 0.05, 1, 1))
    return figure


def draw(axes: plt.Axes, table: pd.DataFrame, looks: dict, values: pd.Series) -> None:
    """One line a method, memory along x."""
    for method in looks:
        mine = table.method == method
        if values[mine].notna().any():
            axes.plot(table.bytes[mine] / 1e3, values[mine], label=common.label(method), **looks[method])
    axes.set(xscale="log", yscale="log", xlabel="memory, kB")


def floored(share: pd.Series) -> pd.Series:
    """Per cent, with none at the floor."""
    return (100 * share).clip(lower=FLOOR)


def ticks(axes: plt.Axes) -> None:
    """Per cent on a logarithmic axis whose lowest tick says none."""
    axes.set_ylim(0.7 * FLOOR, 140)
    axes.set_yticks([FLOOR, 0.1, 1, 10, 100], ["none", "0.1", "1", "10", "100"])
    axes.minorticks_off()


def building(axes: plt.Axes, table: pd.DataFrame, looks: dict) -> None:
    """Time to fill; hollow where scaled."""
    draw(axes, table, looks, table.build_ms)
    scaled = table[table.build_extrapolated]
    for method in scaled.method.unique():
        mine = scaled[scaled.method == method]
        look = looks[method]
        common.marks(
            axes, mine.bytes / 1e3, mine.build_ms, marker=look["marker"], color=look["color"], markerfacecolor="white"
        )
    axes.set(ylabel="ms", title="Time to fill (hollow: scaled)")


common.run(main)
