# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scene-omissions
# @question  What does each omission of a scene save by itself?
# @data      scene_needs scene_needs_totals
"""What each omission of a scene's plan saves by itself, in memory and time."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import scene_needs

OMISSIONS = {
    "vertices": "vertices",
    "entries": "entries",
    "second_scan": "second scan",
    "fine_table": "fine table",
    "all": "all together",
}
BY_THEMSELVES = ("local change", "motion volume")  # with one omission each, not those of a plan


def main(options) -> common.Figure:
    totals = scene_needs.load(options.results, "scene_needs_totals")
    needs = scene_needs.load(options.results, "scene_needs")
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.4, 5.4), sharey=True)
    draw_alone(left, needs, totals, "bytes")
    draw_alone(right, needs, totals, "us")
    figure.tight_layout()
    figure.legend(*left.get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=3)
    return figure


def draw_alone(axes: plt.Axes, needs: pd.DataFrame, totals: pd.DataFrame, unit: str) -> None:
    """What is left of the whole tables' memory or time with one omission alone, median over the joints."""
    shown = [o for o in OMISSIONS if (needs.left_out == o).any()]
    questions = [q for q in scene_needs.QUESTIONS if (totals.question == q).any() and q not in BY_THEMSELVES]
    whole = totals.set_index("scene")
    column = "bytes_saved" if unit == "bytes" else "time_saved_us"
    height = 0.8 / len(questions)
    for k, question in enumerate(questions):
        rows = needs[(needs.question == question) & needs.left_out.isin(shown)]
        base = whole.loc[rows.scene, f"tables_{unit}"].to_numpy()
        everything = whole.loc[rows.scene, f"everything_{unit}"].to_numpy()
        full = np.where(rows.left_out == "all", everything, base)
        share = 100 * (full - rows[column].to_numpy()) / base
        share = pd.Series(share, index=rows.left_out.to_numpy()).groupby(level=0).median()
        places = [shown.index(o) - 0.4 + (k + 0.5) * height for o in share.index]
        bars = axes.barh(
            places,
            share.to_numpy(),
            height=0.85 * height,
            color=common.COLOURS[k],
            hatch=["", "//", "..", "xx", "--"][k % 5],
            edgecolor="white",
            label=scene_needs.QUESTIONS[question],
        )
        axes.bar_label(bars, [common.digits(value, 2) for value in share], padding=2, fontsize=7)
    axes.axvline(100, color="black", linewidth=1, linestyle="--")
    axes.set_yticks(range(len(shown)), [OMISSIONS[o] for o in shown])
    axes.set_ylim(len(shown) - 0.5, -0.5)
    axes.set_xlim(0, 115)
    what = "memory" if unit == "bytes" else "time"
    axes.set_xlabel("% of that of whole tables and all look-ups")
    axes.set_title(f"{what.capitalize()} that remains with each omission alone", fontsize=10)


common.run(main)
