# SPDX-License-Identifier: GPL-3.0-or-later
# @name      cohort-rotation
# @question  How does internal rotation at 90 degrees of flexion spread over hips whose shape spreads as published?
# @data      cohort
"""Left: internal rotation at 90 degrees of flexion until the bones touch, of every hip of the cohort, with what is published
of three groups of ten. Then the same by the alpha angle at 1:30 and by femoral torsion; bars are where the limit is for every
centre within half a millimetre.
"""

import matplotlib.pyplot as plt
import numpy as np

import common
from common import cohort


def main(options) -> common.Figure:
    hips = cohort.limits(common.load(options.results, "cohort"))
    figure, panels = plt.subplots(1, 3, figsize=(common.WIDTH, 4.3), sharey=True)
    rotation = hips[cohort.ROTATION]
    bins = np.arange(5 * np.floor(rotation.min() / 5), rotation.max() + 5, 5)
    panels[0].hist(
        rotation, bins=bins, orientation="horizontal", color=common.COLOURS[5], label=f"{rotation.count():,} generated hips"
    )
    for name, style in zip(cohort.GROUPS, ("-", "--", ":")):
        label = f"published mean of {name} ({cohort.AUDENAERT})"
        panels[0].axhline(cohort.GROUPS[name], color="black", linestyle=style, linewidth=1.2, label=label)
    panels[0].set(xlabel="number of hips", ylabel="internal rotation, degrees", title="a) all hips")
    reach = np.abs(
        [
            rotation - hips.internal_rotation_at_90_low_deg,
            hips.internal_rotation_at_90_high_deg.fillna(np.inf).clip(upper=rotation.max() + 5) - rotation,
        ]
    )
    look = {"fmt": "o", "markersize": 2.5, "linewidth": 0.4, "color": common.COLOURS[0], "ecolor": common.THESIS_GREY}
    for axes, column, words in zip(
        panels[1:], ("alpha_1_30", "femoral_torsion"), ("alpha angle at 1:30", "femoral torsion")
    ):
        axes.errorbar(hips[column], rotation, yerr=reach, **look)
        axes.set(xlabel=f"{words}, degrees")
    panels[1].set_title("b) by the cam")
    panels[2].set_title("c) by the femoral torsion")
    figure.suptitle("Internal rotation until the bones touch, at 90° of flexion (bars: for any centre within half a millimetre)", x=0.01, ha="left", fontsize=12)
    figure.legend(loc="lower center", ncol=1, fontsize=common.SMALL)
    figure.tight_layout(rect=(0, 0.2, 1, 1))
    return figure


common.run(main)
