# SPDX-License-Identifier: GPL-3.0-or-later
# @name      helix-placement
# @question  By how many entries a look-up by Eq. 10 is off where entries stand at equal arc length.
# @data      helix_mismatch helix_placement
"""By how many entries the index of Eq. 10 is off on a helix whose entries stand at equal true arc length."""

import matplotlib.pyplot as plt

import common

PANELS = [
    ("true_spacing", "mismatch_true_spacing", "Δx = L(π)/(w − 1), the true spacing"),
    ("eq10_spacing", "mismatch_eq10_spacing", "Δx = (4k + 1)/(w − 1), Eq. 10's own"),
]


def main(options) -> common.Figure:
    curves = common.load(options.results, "helix_mismatch")
    largest = common.load(options.results, "helix_placement").set_index("turns")
    figure, panels = plt.subplots(1, 2, figsize=(common.WIDTH, 2.8))
    for axes, (column, maximum, title) in zip(panels, PANELS):
        for k, look in common.look(list(curves.turns)).items():
            line = curves[curves.turns == k]
            axes.plot(
                line.phi_deg,
                line[column],
                color=look["color"],
                linestyle=look["linestyle"],
                label=f"k = {k:,}: at most {common.digits(abs(largest[maximum][k]))}",
            )
        axes.set(title=title, xlabel="polar angle φ on the helix, degrees", xticks=range(0, 181, 30))
        axes.legend()
    panels[0].set_ylabel("index by Eq. 10 minus\ntrue index, entries")
    figure.tight_layout()
    return figure


common.run(main)
