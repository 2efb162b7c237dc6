# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-58
# @question  Adjusted angle of each of 901 rays: thesis, unrounded, exact (Figure 58).
# @data      conchoid_angles
"""Figure 58: adjusted against original angle of each of 901 rays."""

import matplotlib.pyplot as plt

import common
from common import conchoid_plot as conchoid


def main(options) -> common.Figure:
    rays = conchoid.finest_rays(options.results)
    figure, axes = plt.subplots()
    axes.plot(rays.index, rays.original_deg, color=common.COLOURS[0], label="original: equal angles")
    for column, name in conchoid.ADJUSTED.items():
        axes.plot(rays.index, rays[column], label=f"adjusted: {name}", **conchoid.adjusted(column))
    axes.set(
        title=f"Angles of {len(rays)} rays, {rays.original_deg.iloc[1]:.1f}° apart before they are adjusted",
        xlabel="index i of the ray",
        ylabel="angle φ, degrees",
        xlim=(0, len(rays) - 1),
        ylim=(0, 91),
    )
    axes.set_yticks(range(0, 91, 15))
    axes.legend(loc="upper left")
    inset(axes.inset_axes((0.60, 0.10, 0.36, 0.40)), rays)
    return figure


def inset(axes: plt.Axes, rays) -> None:
    """Where the adjusted angles differ most from each other: at the rim."""
    last = rays[rays.index >= len(rays) - 8]
    axes.plot(last.index, last.original_deg, color=common.COLOURS[0])
    for column in conchoid.ADJUSTED:
        axes.plot(last.index, last[column], **conchoid.adjusted(column))
    axes.set_title("at the rim", fontsize=9)
    axes.tick_params(labelsize=8)


common.run(main)
