# SPDX-License-Identifier: GPL-3.0-or-later
# @name      conchoid-surface
# @question  How much of the turned conchoid does each sample point stand for?
# @data      conchoid_surface
"""Area of the turned conchoid that each sample point stands for, by its polar angle."""

import matplotlib.pyplot as plt

import common

LABELS = {
    "equal_angle_rings": "rings at equal angles",
    "thesis_rings": "rings adjusted by Eq. 16",
    "equal_arc_rings": "rings at equal length",
    "equal_area_spiral": "equal-area spiral",
}
SPREAD = 1.6  # degrees between the marks of two samplings in one band


def main(options) -> common.Figure:
    bands = common.load(options.results, "conchoid_surface")
    figure, axes = plt.subplots()
    looks = common.look(list(bands.sampling))
    for place, (name, look) in enumerate(looks.items()):
        rows = bands[bands.sampling == name]
        middle = (rows.phi_from_deg + rows.phi_to_deg) / 2 + SPREAD * (place - (len(looks) - 1) / 2)
        below, above = rows.mean_mm2 - rows.smallest_mm2, rows.largest_mm2 - rows.mean_mm2
        ratio = rows.largest_mm2.max() / rows.smallest_mm2.min()
        label = f"{LABELS.get(name, name.replace('_', ' '))}: largest/smallest {common.digits(ratio)}"
        axes.errorbar(
            middle,
            rows.mean_mm2,
            yerr=[below, above],
            linestyle="none",
            marker=look["marker"],
            color=look["color"],
            markersize=5,
            capsize=2,
            label=label,
        )
    axes.set(
        yscale="log",
        title=f"Area of the turned conchoid a sample point stands for, {bands.points.iloc[0]:,} points",
        xlabel="angle φ from the apex, degrees",
        ylabel="area, mm²",
    )
    axes.set_xticks(range(0, 91, 10))
    axes.set_yticks([0.02, 0.05, 0.1, 0.2, 0.5, 1, 2], ["0.02", "0.05", "0.1", "0.2", "0.5", "1", "2"])
    axes.minorticks_off()
    axes.legend(loc="lower right", title="mean of 10° bands; bars: smallest to largest")
    return figure


common.run(main)
