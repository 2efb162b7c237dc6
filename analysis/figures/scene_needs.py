# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scene-needs
# @question  What does a scene save by leaving out what it does not need?
# @data      scene_needs_totals
"""What a scene saves by leaving out what it does not need: memory and time of everything beside those of the plan."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import scene_needs

EVERYTHING, TABLES, PLAN = common.COLOURS[1], common.COLOURS[4], common.COLOURS[0]


def main(options) -> common.Figure:
    totals = scene_needs.load(options.results, "scene_needs_totals")
    figure, (left, right) = plt.subplots(1, 2, figsize=(common.WIDTH, 3.6), sharey=True)
    draw_totals(left, totals, "bytes", 1e6, "memory, MB")
    draw_totals(right, totals, "us", 1e3, "time, ms")
    left.set_title("Memory: one dot per joint; line: median", fontsize=10)
    right.set_title("Time of the same answer", fontsize=10)
    figure.tight_layout()
    figure.legend(*right.get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=3)
    return figure


def fewer(least: str, most: str) -> str:
    """How many times less the plan takes, over all joints."""
    if least != most:
        return f"{least} to {most} times less"
    return "the same" if float(least) == 1 else f"{least} times less"


def draw_totals(axes: plt.Axes, totals: pd.DataFrame, unit: str, scale: float, label: str) -> None:
    """Everything, whole tables and plan of each question."""
    shown = [q for q in scene_needs.QUESTIONS if (totals.question == q).any()]
    looks = {
        "everything": ("everything, outputs nobody asked for included", EVERYTHING, "s", 0.22),
        "tables": ("whole tables and all look-ups", TABLES, "D", 0.0),
        "plan": ("what the plan leaves", PLAN, "o", -0.22),
    }
    for name, (text, colour, marker, shift) in looks.items():
        for row, question in enumerate(shown):
            values = totals[totals.question == question][f"{name}_{unit}"] / scale
            common.marks(
                axes,
                values,
                np.full(len(values), row + shift),
                marker=marker,
                markersize=5,
                color=colour,
                markerfacecolor=colour if name == "plan" else "white",
                label=text if row == 0 else None,
            )
            axes.plot([values.median()] * 2, [row + shift - 0.1, row + shift + 0.1], color=colour, linewidth=2)
    for row, question in enumerate(shown):
        ratio = totals[totals.question == question]["bytes_ratio" if unit == "bytes" else "time_ratio"]
        axes.annotate(
            fewer(common.digits(ratio.min(), 2), common.digits(ratio.max(), 2)),
            (0.985, row - 0.42),
            xycoords=("axes fraction", "data"),
            ha="right",
            va="center",
            fontsize=common.SMALL,
        )
    axes.set(xscale="log", xlabel=label)
    axes.set_xlim(right=8 * axes.get_xlim()[1])  # room for the words, right of all marks
    axes.set_yticks(range(len(shown)), [scene_needs.QUESTIONS[q] for q in shown])
    axes.set_ylim(len(shown) - 0.4, -0.6)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:,g}")


common.run(main)
