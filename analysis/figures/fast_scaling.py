# SPDX-License-Identifier: GPL-3.0-or-later
# @name      fast-scaling
# @question  How does the time of a gap grow with the triangles, and what does a second thread gain?
# @data      all_gaps
"""How the time of a vertex grows with the triangles, beside every peer, and what a second thread gains."""

import matplotlib.pyplot as plt
import pandas as pd

import common
from common import fast

OWN = ["cube_gnomonic_mesh_exact", "cube_cells_exact"]
SETTINGS = ["n=291", "4/face"]
DIRECTION = "socket->ball"


def main(options) -> common.Figure:
    table = fast.load(options.results)
    sets = table.instruction_set.isin(["none", fast.best_set(table)])
    rows = shown(table[sets & (table.direction == DIRECTION)])
    figure, (times, gains) = plt.subplots(1, 2, figsize=(9.6, 5.0), width_ratios=[3, 2])
    one = rows[rows.threads == 1]
    common.medians(times, one, "triangles", "ns_vertex", "iqr_ns", common.look(list(one.line)))
    times.set(yscale="log", ylabel=f"time per vertex, ns (one thread, {fast.set_name(table)})")
    times.set_title("socket to ball")
    draw_threads(gains, rows[(rows.method == OWN[0])])
    for axes in (times, gains):
        sizes = sorted(rows.triangles.unique())
        axes.set_xscale("log")
        axes.set_xlabel("triangles of each model")
        axes.set_xticks(sizes, [f"{size / 1000:g}k" for size in sizes])
        axes.minorticks_off()
    figure.legend(*times.get_legend_handles_labels(), loc="lower center", ncol=3)
    figure.tight_layout(rect=(0, 0.15, 1, 1))
    return figure


def shown(table: pd.DataFrame) -> pd.DataFrame:
    """The cube in 16 bits, the exact cells, the fastest of Embree's rays at each size, and what else is exact."""
    own = table[table.method.isin(OWN) & table.setting.isin(SETTINGS) & (table.storage != "double")]
    own = own[(own.method != OWN[0]) | (own.storage == "uint16")]
    rays = table[table.method.str.startswith("embree_ray")]
    best = rays.loc[rays.groupby("triangles").ns_vertex.idxmin()].assign(line="Embree, the fastest rays")
    return pd.concat([own, best, table[table.method.isin(fast.RAYS + fast.CLOSEST)]])


def draw_threads(axes: plt.Axes, rows: pd.DataFrame) -> None:
    """Vertices a second of one thread and of two, of the cube."""
    for threads, look in zip((1, 2), common.look(["one thread", "two threads"]).values()):
        own = rows[rows.threads == threads].sort_values("triangles")
        rate = 1e3 / own.ns_vertex  # millions a second
        axes.errorbar(
            own.triangles,
            rate,
            yerr=rate * own.iqr_ns / own.ns_vertex / 2,
            label=f"{threads} thread{'s' if threads > 1 else ''}",
            capsize=2,
            **look,
        )
    axes.set(ylabel="million vertices a second, all threads", ylim=(0, None), title="cube kernel, 16 bits")
    axes.legend(loc="best")


common.run(main)
