# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-56
# @question  Four rays cut the conchoid into three equal lengths (Figure 56).
# @data      conchoid_curve conchoid_angles
"""Figure 56: four rays cut the conchoid into three equal lengths."""

import matplotlib.pyplot as plt
import numpy as np

import common
from common import conchoid_plot as conchoid

RAYS = 4


def main(options) -> common.Figure:
    curve = conchoid.load(options.results)
    angles = common.load(options.results, "conchoid_angles")
    exact = angles[angles.rays == RAYS].exact_deg.to_numpy()
    part = conchoid.at(curve, exact[1], "length_mm")
    figure, panels = plt.subplots(1, 3, figsize=(11.6, 4.6), sharey=True)
    for axes in panels:
        conchoid.draw_axis(axes, -42, 3)
        cap = conchoid.cap(curve)
        axes.plot(cap.x_mm, cap.up_mm, color=conchoid.CURVE, linewidth=1.6)
        conchoid.plane(axes)
        axes.set(xlim=(-4, 35))
    conchoid.rays(panels[0], curve, exact, color="black", linewidth=1)
    for i, phi in enumerate(exact):
        at = conchoid.point(curve, phi)
        common.note(panels[0], f"i = {i}\nφ = {phi:.1f}°", at, (8, -26 + 10 * i), fontsize=9)
    for i, axes in ((1, panels[1]), (2, panels[2])):
        conchoid.rays(axes, curve, exact[[0, i]], color="black", linewidth=1)
        phi = np.linspace(0, exact[i], 100)
        axes.plot(
            conchoid.at(curve, phi, "x_mm"), conchoid.at(curve, phi, "up_mm"), color=conchoid.SECOND, linewidth=5
        )
        length = conchoid.at(curve, exact[i], "length_mm")
        middle = conchoid.point(curve, exact[i] / 2)
        times = "" if i == 1 else f"{i} "
        common.note(axes, f"{times}ΔL = {length:.2f} mm", middle, (9, -9), fontsize=10)
    panels[0].set_title(f"a) four rays, ΔL = {part:.2f} mm")
    panels[1].set_title("b) length up to ray 1")
    panels[2].set_title("c) length up to ray 2")
    figure.suptitle("Rays that cut the conchoid into equal lengths ΔL", x=0.01, ha="left")
    figure.tight_layout()
    return figure


common.run(main)
