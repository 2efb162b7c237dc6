# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scene saves by leaving out what it does not need: memory and time of everything beside those of the plan,
and what each omission does by itself. From data/scene_needs.csv and scene_needs_totals.csv.
"""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common

EVERYTHING, TABLES, PLAN = common.COLOURS[1], common.COLOURS[4], common.COLOURS[0]
QUESTIONS = {
    "all gaps": "all gaps, one pose",
    "smallest gap": "smallest gap, one pose",
    "touch in a motion": "touch, 19 poses",
    "touch in small steps": "touch, 721 poses",
    "gaps in a motion": "all gaps to 0.05 mm, 181 poses",
    "local change": "table after a local change",
}
OMISSIONS = {
    "vertices": "vertices",
    "entries": "entries",
    "second_scan": "second scan",
    "equal_poses": "equal poses",
    "single_vertices": "single vertices",
    "fine_table": "fine table",
    "all": "all together",
}


def main() -> None:
    """Writes figures/scene-needs.svg, .png and .pdf."""
    options = common.arguments(__doc__)
    totals = with_question(common.load(options.results, "scene_needs_totals"))
    needs = with_question(common.load(options.results, "scene_needs"))
    common.style()
    figure, axes = plt.subplots(2, 2, figsize=(10.4, 8.6), sharey="row")
    draw_totals(axes[0, 0], totals, "bytes", 1e6, "memory, MB")
    draw_totals(axes[0, 1], totals, "us", 1e3, "time, ms")
    axes[0, 0].set_title("Memory: a dot a joint, the line is the median", fontsize=10)
    axes[0, 1].set_title("Time of the same answer", fontsize=10)
    draw_alone(axes[1, 0], needs, totals, "bytes")
    draw_alone(axes[1, 1], needs, totals, "us")
    figure.tight_layout()
    handles, labels = axes[0, 1].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=3, fontsize=9)
    common.save_figure(figure, options.out, "scene-needs")


def with_question(table: pd.DataFrame) -> pd.DataFrame:
    """The columns `joint` and `question` that the name of a scene consists of."""
    parts = table.scene.str.split(" ", n=1, expand=True)
    return table.assign(joint=parts[0], question=parts[1])


def draw_totals(axes: plt.Axes, totals: pd.DataFrame, unit: str, scale: float, label: str) -> None:
    """Everything, whole tables and plan of each question."""
    shown = [q for q in QUESTIONS if (totals.question == q).any()]
    looks = {
        "everything": ("everything, outputs nobody asked for included", EVERYTHING, "s", 0.22),
        "tables": ("whole tables and all look-ups", TABLES, "D", 0.0),
        "plan": ("what the plan leaves", PLAN, "o", -0.22),
    }
    for name, (text, colour, marker, shift) in looks.items():
        for row, question in enumerate(shown):
            values = totals[totals.question == question][f"{name}_{unit}"] / scale
            axes.plot(
                values,
                np.full(len(values), row + shift),
                linestyle="none",
                marker=marker,
                markersize=5,
                color=colour,
                markerfacecolor=colour if name == "plan" else "white",
                label=text if row == 0 else None,
            )
            axes.plot(
                [values.median()] * 2, [row + shift - 0.1, row + shift + 0.1], color=colour, linewidth=2
            )
    for row, question in enumerate(shown):
        ratio = totals[totals.question == question]["bytes_ratio" if unit == "bytes" else "time_ratio"]
        axes.annotate(
            f"{common.digits(ratio.min(), 2)} to {common.digits(ratio.max(), 2)} times less"
            if len(ratio) > 1
            else f"{common.digits(ratio.min(), 2)} times less",
            (0.985, row - 0.42),
            xycoords=("axes fraction", "data"),
            ha="right",
            va="center",
            fontsize=8,
        )
    axes.set(xscale="log", xlabel=label)
    axes.set_yticks(range(len(shown)), [QUESTIONS[q] for q in shown])
    axes.set_ylim(len(shown) - 0.4, -0.6)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:,g}")


def draw_alone(axes: plt.Axes, needs: pd.DataFrame, totals: pd.DataFrame, unit: str) -> None:
    """What is left of the whole tables' memory or time with one omission alone, median over the joints."""
    shown = [o for o in OMISSIONS if (needs.left_out == o).any()]
    questions = [q for q in QUESTIONS if (totals.question == q).any() and q != "local change"]
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
            label=QUESTIONS[question],
        )
        axes.bar_label(bars, [common.digits(value, 2) for value in share], padding=2, fontsize=7)
    axes.axvline(100, color="black", linewidth=1, linestyle="--")
    axes.set_yticks(range(len(shown)), [OMISSIONS[o] for o in shown])
    axes.set_ylim(len(shown) - 0.5, -0.5)
    axes.set_xlim(0, 125)
    what = "memory" if unit == "bytes" else "time"
    axes.set_xlabel(f"{what} that is left, % of whole tables and all look-ups")
    axes.set_title(f"Left of the {what} by each omission alone", fontsize=10)
    if unit == "bytes":
        axes.legend(fontsize=7, loc="lower right", bbox_to_anchor=(0.79, 0.03))


common.run(main)
