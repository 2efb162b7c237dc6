# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-57
# @question  Four rays on the conchoid, original and adjusted (Figure 57).
# @data      conchoid_curve conchoid_angles
"""Figure 57: four rays at equal angles and adjusted, Eq. 16 of the thesis."""

import matplotlib.pyplot as plt

import common
from common import conchoid_plot as conchoid

RAYS = 4


def main(options) -> common.Figure:
    curve = conchoid.load(options.results)
    angles = common.load(options.results, "conchoid_angles")
    four = angles[angles.rays == RAYS]
    figure, axes = plt.subplots(figsize=(6.4, 6.0))
    conchoid.draw_axis(axes, -42, 3)
    cap = conchoid.cap(curve)
    axes.plot(cap.x_mm, cap.up_mm, color=conchoid.CURVE, linewidth=2)
    conchoid.rays(axes, curve, four.original_deg, color="black", linestyle="--", linewidth=1, label="original")
    conchoid.rays(axes, curve, four.thesis_deg, color=conchoid.SECOND, linewidth=1.6, label="adjusted, Eq. 16")
    for row in four.itertuples():
        at = conchoid.point(curve, row.thesis_deg)
        text = f"{row.original_deg:.0f}° → {row.thesis_deg:.2f}°\n(exact {row.exact_deg:.2f}°)"
        common.note(axes, text, at, (12, -16 + 8 * row.i), fontsize=9, va="center")
    conchoid.plane(axes)
    axes.set(title="Rays that cut the conchoid into equal lengths", xlim=(-3, 40), ylim=(-43, 3))
    axes.legend(loc="lower right")
    figure.tight_layout()
    return figure


common.run(main)
