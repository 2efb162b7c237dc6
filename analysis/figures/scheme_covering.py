# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scheme-covering
# @question  How much memory does each scheme take so that no direction is farther from an entry than in the others?
# @data      schemes scheme_covering
"""Covering constant of every scheme, with that away from the poles and the least possible."""

import matplotlib.pyplot as plt

import common
from common import scheme_plot


def main(options) -> common.Figure:
    labels = common.scheme_labels(options.results)
    table = common.load(options.results, "scheme_covering").sort_values("constant", kind="stable")
    figure, axes = plt.subplots(figsize=(6.8, 0.9 + 0.3 * len(table)))
    places = scheme_plot.rows(axes, [labels[scheme] for scheme in table.scheme])
    end = 1.12 * scheme_plot.reach(table.constant)
    axes.barh(places, table.constant.clip(upper=end), height=0.62, color=common.COLOURS[5], edgecolor="none")
    for place, constant in zip(places, table.constant):
        beyond = constant > end
        common.note(
            axes,
            f"{constant:,.0f} →" if beyond else f"{constant:.2f}",
            (min(constant, end), place),
            (-6 if beyond else 6, 0),
            ha="right" if beyond else "left",
            va="center",
            fontsize=8.5,
        )
    away = (table.constant_away < 0.995 * table.constant) & (table.constant_away <= end)
    common.marks(
        axes,
        table.constant_away[away],
        places[away],
        marker="D",
        color="white",
        markeredgecolor="black",
        label="away from the poles, $|z|$ ≤ 0.98, where that is less",
    )
    axes.axvline(scheme_plot.FLOOR, color="black", linestyle="--", linewidth=1.2, label=scheme_plot.FLOOR_TEXT)
    axes.set(
        xlim=(0, end),
        xlabel=r"covering constant $N\rho^2$: entries × (farthest distance to one)²",
        title="Memory that each scheme takes for an equal covering",
    )
    axes.legend(loc="upper left", bbox_to_anchor=(-0.02, -0.6 / len(table) - 0.08), ncol=1)
    return figure


common.run(main)
