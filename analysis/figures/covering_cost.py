# SPDX-License-Identifier: GPL-3.0-or-later
# @name      covering-cost
# @question  How much memory does each scheme take for an equal covering of the sphere, and how long does a look-up take?
# @data      schemes scheme_covering lookup_time
"""Covering constant of every scheme against the time of one look-up."""

import textwrap

import matplotlib.pyplot as plt

import common
from common import scheme_plot


def main(options) -> common.Figure:
    labels = common.scheme_labels(options.results)
    table = common.load(options.results, "scheme_covering").merge(
        common.load(options.results, "lookup_time"), on="scheme"
    )
    top = 1.1 * scheme_plot.reach(table.constant)
    names = [
        textwrap.fill(labels[row.scheme] + (f" ({row.constant:,.0f} ↑)" if row.constant > top else ""), 24)
        for row in table.itertuples()
    ]
    height = table.constant.clip(upper=top)
    figure, axes = plt.subplots(figsize=(4.5, 4.5))
    axes.set(
        xscale="log",
        xlim=(0.7 * table.median_ns.min(), 4 * table.median_ns.max()),
        ylim=(scheme_plot.FLOOR - 0.55, top + 0.3),
    )
    axes.vlines(table.median_ns, table.constant_away.clip(upper=top), height, color=common.THESIS_GREY, linewidth=1)
    common.marks(
        axes,
        table.median_ns,
        table.constant_away.clip(upper=top),
        marker="_",
        color=common.THESIS_GREY,
        label="the same away from the poles",
    )
    common.marks(axes, table.median_ns, height, marker="o", color=common.COLOURS[0], label="whole sphere")
    best = table.sort_values(["median_ns", "constant"])
    best = best[best.constant <= best.constant.cummin()]
    axes.step(
        best.median_ns,
        best.constant.clip(upper=top),
        where="post",
        color=common.COLOURS[1],
        linestyle="-.",
        linewidth=0.9,
        label="border: no other is better in both",
        zorder=1,
    )
    axes.axhline(scheme_plot.FLOOR, color="black", linestyle="--", linewidth=1.2, label=scheme_plot.FLOOR_TEXT)
    scheme_plot.name_points(axes, table.median_ns, height, names)
    ticks = [
        tick
        for tick in (3, 10, 30, 100, 300, 1000, 3000, 10000)
        if axes.get_xlim()[0] <= tick <= axes.get_xlim()[1]
    ]
    axes.set_xticks(ticks, [f"{tick:,}" for tick in ticks])
    axes.minorticks_off()
    axes.set(
        xlabel="time of one look-up at a random direction, ns",
        ylabel=r"memory for equal covering, $N\rho^2$",
        title="Memory and time; lower left is better",
    )
    axes.legend(loc="upper left", bbox_to_anchor=(-0.12, -0.12))
    return figure


common.run(main)
