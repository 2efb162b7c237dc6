# SPDX-License-Identifier: GPL-3.0-or-later
# @name      contact-time
# @question  How long does it take to tell whether a joint touches, beside other libraries?
# @data      contact
"""Time to tell whether a joint touches, and its smallest gap, against its triangles."""

import matplotlib.pyplot as plt
import pandas as pd

import common
from common import contact


def main(options) -> common.Figure:
    table = contact.load(options.results)
    looks = common.look(list(table.line[~table.method.isin(contact.NOT_DRAWN)].unique()))
    figure, axes = plt.subplots(1, 3, figsize=(common.WIDTH, 3.4), sharey=True)
    for panel, (case, title) in zip(axes, contact.CASES.items()):
        draw(panel, table[table.gap_case == case], looks)
        panel.set_title(title)
    axes[0].set(ylabel="time of a pose, µs", ylim=(table.us_pose.min() / 2, table.us_pose.max() * 2))
    figure.legend(*axes[0].get_legend_handles_labels(), loc="lower center", ncol=3)
    figure.tight_layout(rect=(0, 0.16, 1, 1))
    return figure


def draw(axes: plt.Axes, rows: pd.DataFrame, looks: dict) -> None:
    """A line a method, bars of the interquartile range."""
    common.medians(axes, rows, "triangles", "us_pose", "iqr_us", looks)
    sizes = sorted(rows.triangles.unique())
    axes.set(xscale="log", yscale="log", xlabel="triangles of each model")
    axes.set_xticks(sizes, [f"{size / 1000:g}k" for size in sizes])
    axes.minorticks_off()


common.run(main)
