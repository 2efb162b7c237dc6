# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-47
# @question  The helix of the thesis with 10, 20 and 40 turns (Figure 47).
# @data      helix_curve
"""Figure 47: the helix of the thesis with more and more turns."""

import matplotlib.pyplot as plt

import common
from common import sphere_view

EYE = sphere_view.view(20, -60)
AXES = ["x", "y", "z"]


def main(options) -> common.Figure:
    helix = common.load(options.results, "helix_curve")
    turns = sorted(helix.turns.unique())
    figure, panels = plt.subplots(1, len(turns), figsize=(4.0 * len(turns), 4.5))
    for letter, k, axes in zip("abcdef", turns, panels):
        lines = helix[helix.turns == k]
        entries = lines[lines.kind == "entry"]
        sphere_view.draw_sphere(axes)
        sphere_view.draw_line(
            axes, lines[lines.kind == "curve"][AXES].to_numpy(), EYE, color=common.COLOURS[0], linewidth=12 / (k + 8)
        )
        sphere_view.draw_points(
            axes,
            entries[AXES].to_numpy(),
            EYE,
            color=common.COLOURS[1],
            marker="o",
            markersize=max(60 / (k + 8), 1.4),
            markeredgewidth=0,
        )
        axes.set_title(f"{letter}) k = {k} turns, w = {len(entries):,} entries", loc="center", fontsize=13)
    figure.suptitle("The helix θ = 2kφ on the sphere; orange: sampled directions, faint: behind", fontsize=13, y=1.0)
    figure.tight_layout()
    return figure


common.run(main)
