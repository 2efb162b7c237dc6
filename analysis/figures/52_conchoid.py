# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-52
# @question  The conchoid of the hip, and beside the sphere that fits it best (Figure 52).
# @data      conchoid_curve conchoid_shape
"""Figure 52: the conchoid of the hip, and beside the sphere that fits it best."""

import matplotlib.pyplot as plt
import numpy as np

import common
from common import conchoid_plot as conchoid


def main(options) -> common.Figure:
    curve = conchoid.load(options.results)
    shape = common.load(options.results, "conchoid_shape").iloc[0]
    figure, panels = plt.subplots(1, 2, figsize=(10.4, 5.2), sharey=True)
    for axes in panels:
        conchoid.draw_axis(axes, -42, 13)
        conchoid.draw_both_sides(axes, curve, color=conchoid.CURVE, linewidth=0.9)
        conchoid.draw_both_sides(
            axes, conchoid.cap(curve), color=conchoid.CURVE, linewidth=3.0, label="conchoid; thick: φ ≤ 90°"
        )
        axes.plot(0, 0, "o", color="black", markersize=5, label="origin of the conchoid")
        conchoid.plane(axes)
    start = conchoid.point(curve, 50)
    panels[0].plot(*np.array([[0, 0], start]).T, color="black", linewidth=1)
    panels[0].annotate("r = a + b cos φ", (-22, -22))
    arc = np.radians(np.linspace(0, 50, 60))
    panels[0].plot(9 * np.sin(arc), -9 * np.cos(arc), color="black", linewidth=0.8)
    common.note(panels[0], "φ", (9 * np.sin(0.4), -9 * np.cos(0.4)), (1, -13), fontsize=10)
    turn = np.linspace(0, 2 * np.pi, 400)
    panels[1].plot(
        shape.sphere_radius_mm * np.cos(turn),
        -shape.sphere_height_mm + shape.sphere_radius_mm * np.sin(turn),
        color=conchoid.SECOND,
        linestyle="--",
        label=f"best sphere of the cap, radius {shape.sphere_radius_mm:.1f} mm",
    )
    panels[1].plot(0, -shape.sphere_height_mm, "x", color=conchoid.SECOND, markersize=7, label="centre of the sphere")
    panels[0].set_title(f"a) the conchoid: a = {shape.a_mm:.2f} mm, b = {shape.b_mm:.2f} mm")
    panels[1].set_title(
        f"b) its cap is {shape.sphere_lowest_mm:+.2f} to {shape.sphere_highest_mm:+.2f} mm off the sphere".replace("-", "−")
    )
    for axes in panels:
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14))
    figure.tight_layout()
    return figure


common.run(main)
