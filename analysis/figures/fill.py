# SPDX-License-Identifier: GPL-3.0-or-later
# @name      fill-time
# @question  How long does a table take to fill, against triangles and entries, beside Embree?
# @data      fill
"""Time to fill the tables of a joint against its triangles and against its entries, beside Embree."""

import matplotlib.pyplot as plt
import pandas as pd
from matplotlib.ticker import LogLocator

import common
from common import fill

CELLS = 256  # along an edge of the cube, of the tables that are shown against triangles


def main(options) -> common.Figure:
    table = fill.load(options.results)
    shown = table[table.memory == "used again"]
    looks = common.look(list(shown.line))
    figure, axes = plt.subplots(1, 2, figsize=(common.WIDTH, 3.4), sharey=True)
    draw(axes[0], shown[shown.cells == CELLS], "triangles", looks)
    axes[0].set(xlabel="triangles of each model", ylabel="time to fill both tables, ms")
    axes[0].set_title(f"{CELLS} cells along an edge ({90 / CELLS:.2g}°)")
    draw(axes[1], shown[shown.triangles == fill.TRIANGLES], "entries", looks)
    axes[1].set(xlabel="entries of both tables", title=f"{fill.TRIANGLES:,} triangles a model")
    fresh = table[(table.memory == "fresh") & (table.triangles == fill.TRIANGLES)]
    for line, look in looks.items():
        own = fresh[fresh.line == line]
        common.marks(
            axes[1], own.entries, own.median_ms, color=look["color"], marker=look["marker"], markerfacecolor="white"
        )
    common.marks(axes[1], [], [], color="black", marker="o", markerfacecolor="white", label="hollow: fresh memory")
    figure.legend(*axes[1].get_legend_handles_labels(), loc="lower center", ncol=3)
    figure.tight_layout(rect=(0, 0.1, 1, 1))
    return figure


def draw(axes: plt.Axes, rows: pd.DataFrame, key: str, looks: dict) -> None:
    """A line a way, bars of the interquartile range."""
    common.medians(axes, rows, key, "median_ms", "iqr_ms", looks)
    axes.set(xscale="log", yscale="log")
    places = sorted(rows[key].unique())
    axes.set_xticks(places, [common.digits(place, 2) for place in places])
    axes.minorticks_off()
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter("{x:g}")


common.run(main)
