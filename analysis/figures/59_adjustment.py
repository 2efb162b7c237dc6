# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-59
# @question  By how much each of 901 rays is turned (Figure 59).
# @data      conchoid_angles
"""Figure 59: by how much each of 901 rays is turned."""

import matplotlib.pyplot as plt

import common
from common import conchoid_plot as conchoid


def main(options) -> common.Figure:
    rays = conchoid.finest_rays(options.results)
    figure, axes = plt.subplots()
    for column, name in conchoid.ADJUSTED.items():
        turned = rays[column] - rays.original_deg
        at = turned.idxmin()
        look = conchoid.LOOKS[column]
        label = f"{name}: −{-turned[at]:.2f}° at φ = {rays.original_deg[at]:.1f}°"
        axes.plot(rays.original_deg, turned, label=label, **conchoid.adjusted(column))
        axes.plot(rays.original_deg[at], turned[at], marker=look["marker"], color=look["color"])
    axes.axhline(0, color="#555555", linewidth=0.8)
    axes.set(
        title="How far each ray is turned; markers: where most",
        xlabel="original angle φ, degrees",
        ylabel="adjusted minus original angle, degrees",
        xlim=(0, 90),
    )
    axes.set_xticks(range(0, 91, 15))
    axes.legend(loc="center", bbox_to_anchor=(0.53, 0.65))
    return figure


common.run(main)
