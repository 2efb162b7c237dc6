# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scene-needs
# @question  What does a scene save by leaving out what it does not need?
# @data      scene_needs_totals
"""What a scene saves by leaving out what it does not need: memory and time of whole tables beside what the answer needs."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common

QUESTIONS = {
    "all gaps": "all gaps, one pose",
    "smallest gap": "smallest gap, one pose",
    "touch in a motion": "touch, 19 poses",
    "gaps in a motion": "all gaps to 0.05 mm, 181 poses",
}
LOOKS = {
    "tables": ("whole tables and all look-ups", common.COLOURS[4], "D", -0.11),
    "needed": ("only what the answer needs", common.COLOURS[0], "o", 0.11),
}


def main(options) -> common.Figure:
    totals = common.load(options.results, "scene_needs_totals")
    totals["question"] = totals.scene.str.split(" ", n=1).str[1]
    figure, (left, right) = plt.subplots(1, 2, figsize=(common.WIDTH, 2.8), sharey=True)
    draw_totals(left, totals, "bytes", 1e6, "memory, MB")
    draw_totals(right, totals, "us", 1e3, "time, ms")
    left.set_title("Memory: one dot per joint; line: median", fontsize=10)
    right.set_title("Time of the same answer", fontsize=10)
    figure.tight_layout()
    figure.legend(*right.get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=2)
    return figure


def draw_totals(axes: plt.Axes, totals: pd.DataFrame, unit: str, scale: float, label: str) -> None:
    """Whole tables and what is needed, of each question."""
    for row, question in enumerate(QUESTIONS):
        rows = totals[totals.question == question]
        for name, (text, colour, marker, shift) in LOOKS.items():
            values = rows[f"{name}_{unit}"] / scale
            common.marks(
                axes,
                values,
                np.full(len(values), row + shift),
                marker=marker,
                markersize=5,
                color=colour,
                markerfacecolor=colour if name == "needed" else "white",
                label=text if row == 0 else None,
            )
            axes.plot([values.median()] * 2, [row + shift - 0.1, row + shift + 0.1], color=colour, linewidth=2)
        less = (rows[f"tables_{unit}"] / rows[f"needed_{unit}"]).agg(["min", "max"]).map(lambda x: common.digits(x, 2))
        words = f"1/{less['min']}" + ("" if less["min"] == less["max"] else f" to 1/{less['max']}")
        axes.annotate(words, (0.985, row - 0.38), xycoords=("axes fraction", "data"), ha="right", va="center", fontsize=common.SMALL)
    axes.set(xscale="log", xlabel=label)
    axes.set_xlim(right=8 * axes.get_xlim()[1])  # room for the words, right of all marks
    axes.set_yticks(range(len(QUESTIONS)), QUESTIONS.values())
    axes.set_ylim(len(QUESTIONS) - 0.4, -0.6)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:,g}")


common.run(main)
