# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-54
# @question  The conchoid turned about its axis: surface, curves, slices (Figure 54).
# @data      conchoid_curve
"""Figure 54: the conchoid turned about its axis: the surface, the turned curves, slices."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LightSource
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import common
from common import conchoid_plot as conchoid

STEP_DEG = 30  # between turned curves


def main(options) -> common.Figure:
    curve = conchoid.load(options.results)
    figure = plt.figure(figsize=(12.6, 4.6))
    panels = [conchoid.space(figure, (1, 3, k), 25) for k in (1, 2, 3)]
    theta = np.radians(np.arange(0, 361, 4))
    x, up = curve.x_mm.to_numpy()[::4, None], curve.up_mm.to_numpy()[::4, None]
    panels[0].plot_surface(
        x * np.cos(theta),
        x * np.sin(theta),
        up + 0 * theta,
        color="#cfe6f7",
        lightsource=LightSource(250, 60),
        rstride=1,
        cstride=1,
        linewidth=0,
        antialiased=False,
        rasterized=True,
    )
    for axes in panels[1:]:
        axes.plot([0, 0], [0, 0], [-44, 14], color="#555555", linestyle="-.", linewidth=0.9)
    for degrees in range(0, 360, STEP_DEG):
        strong = degrees == 0
        panels[1].plot(
            *conchoid.turned(curve, degrees),
            color=conchoid.SECOND if strong else conchoid.CURVE,
            linewidth=2.6 if strong else 0.9,
        )
    for degrees in (0, 45, 90, 135):
        whole = np.concatenate(
            [np.array(conchoid.turned(curve, degrees)).T, np.array(conchoid.turned(curve, degrees + 180)).T[::-1]]
        )
        panels[2].add_collection3d(
            Poly3DCollection([whole], facecolor=conchoid.CURVE, alpha=0.16, edgecolor=conchoid.CURVE, linewidth=1.4)
        )
    panels[0].set_title("a) the conchoid turned about its axis", loc="center")
    panels[1].set_title("b) one curve (thick), and turned", loc="center")
    panels[2].set_title("c) every slice through the axis is a conchoid", loc="center")
    figure.subplots_adjust(left=0, right=1, bottom=0, top=0.93, wspace=0)
    return figure


common.run(main)
