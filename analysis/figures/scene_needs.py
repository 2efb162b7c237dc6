# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scene-needs
# @question  What does one question need, beside answering all of them and beside a library that answers the same?
"""Processor time, memory and faces of each question asked alone, beside everything at once and beside other libraries."""

import matplotlib.pyplot as plt
import pandas as pd

import common
from common import limit_time, scene_needs

PANELS = {"cpu_ms": "processor time, ms", "peak_MB": "peak memory, MB", "faces_looked_at": "faces looked at one by one"}
EVERYTHING = {"color": common.THESIS_GREY, "linestyle": "-", "linewidth": 3}


def main(options) -> common.Figure:
    table = scene_needs.load(options.results)
    joints = list(dict.fromkeys(table.joint))
    joints = joints[:1] + joints[1:][-1:]  # the generated one, and the largest
    ways = table[~table.way.isin(["needed", "everything"])]
    looks = common.look(["impinge", *dict.fromkeys(ways.label)])
    figure, grid = plt.subplots(
        len(joints), len(PANELS), figsize=(common.WIDTH, 3.2 * len(joints)), sharey=True, sharex="col", squeeze=False
    )
    for line, joint in zip(grid, joints):
        for axes, (column, words) in zip(line, PANELS.items()):
            draw(axes, table[table.joint == joint], column, looks)
            axes.tick_params(labelbottom=True)
            axes.set_xlabel(words)
    keys = [common.key("impinge, this question alone", color=looks["impinge"]["color"], marker="o", linestyle="")]
    keys.append(common.key("impinge, everything at once", **EVERYTHING))
    keys += [common.key(label, **{**looks[label], "linestyle": ""}) for label in dict.fromkeys(ways.label)]
    keys.append(common.key("hollow: scaled from fewer poses", color="black", marker="o", linestyle="", fillstyle="none"))
    figure.legend(handles=keys, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=4)
    figure.tight_layout(h_pad=2.5)
    for line, joint in zip(grid, joints):
        rows = table[table.joint == joint]
        less = 1 / rows[rows.way == "needed"].of_all
        title = limit_time.title(rows)
        words = f"{title.replace('normal', 'Normal', 1)}. One question takes 1/{less.max():.0f} to 1/{less.min():.0f} of the time of all."
        common.note(line[0], words, (0, 1), (-140, 10), xycoords="axes fraction", fontsize=11, fontweight="bold")
    return figure


def draw(axes: plt.Axes, rows: pd.DataFrame, column: str, looks: dict) -> None:
    """A question a line; what all of them take is a line down the panel."""
    everything = rows.loc[rows.question == "everything", column].iloc[0]
    axes.axvline(everything, zorder=1, **EVERYTHING)
    for line, question in enumerate(scene_needs.QUESTIONS):
        for row in rows[rows.question == question].itertuples():
            value = getattr(row, column)
            if pd.isna(value):
                if row.way == "needed":
                    axes.text(0.5, line, "not counted", transform=axes.get_yaxis_transform(), ha="center", va="center", fontsize=common.SMALL)
                continue
            ours = row.way == "needed"
            look = looks["impinge" if ours else row.label]
            face = "white" if row.extrapolated else look["color"]
            axes.plot(
                max(value, 1) if column.startswith("faces") else value,
                line + (0.0 if ours else 0.18),
                marker=look["marker"],
                color=look["color"],
                markerfacecolor=face,
                markersize=9 if ours else 7,
                zorder=3,
            )
            if column.startswith("faces"):
                words = f"{value / everything:.1%}" if value else "none"
                common.note(axes, words, (max(value, 1), line), (0, 7), ha="center" if value else "left")
    axes.set(xscale="log")
    axes.set_yticks(range(len(scene_needs.QUESTIONS)), scene_needs.QUESTIONS.values())
    axes.set_ylim(len(scene_needs.QUESTIONS) - 0.5, -0.6)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:,g}")


common.run(main)
