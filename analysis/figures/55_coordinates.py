# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-55
# @question  Spherical coordinates on the turned conchoid (Figure 55).
# @data      conchoid_curve
"""Figure 55: spherical coordinates on the turned conchoid."""

import matplotlib.pyplot as plt
import numpy as np

import common
from common import conchoid_plot as conchoid

PHI_DEG, THETA_DEG = 55, 40  # of the point that is shown
REACH = 29  # mm, of the drawn axes


def draw_cap(axes: plt.Axes, curve, colour: str) -> None:
    """Meridians and rings of the cap."""
    for degrees in range(0, 360, 20):
        axes.plot(*conchoid.turned(curve, degrees), color=colour, linewidth=0.8)
    theta = np.radians(np.arange(0, 361, 3))
    for phi in (15, 30, 45, 60, 75, 90):
        x, up = conchoid.point(curve, phi)
        axes.plot(x * np.cos(theta), x * np.sin(theta), up + 0 * theta, color=colour, linewidth=0.8)


def draw_coordinates(axes: plt.Axes, curve) -> None:
    """Axes, a ray and its two angles. The +z axis of the coordinates points to the apex."""
    ends = {"x": (REACH, 0, 0), "y": (0, -REACH, 0), "z": (0, 0, -43)}
    for name, end in ends.items():
        axes.quiver(0, 0, 0, *end, color="black", linewidth=1.1, arrow_length_ratio=0.06)
        axes.text(*(1.1 * np.array(end)), name, ha="center", va="center", fontsize=12)
    theta = np.radians(THETA_DEG)
    x, up = conchoid.point(curve, PHI_DEG)
    tip = np.array([x * np.cos(theta), -x * np.sin(theta), up])
    axes.plot(*np.array([np.zeros(3), tip]).T, color=conchoid.SECOND, linewidth=2.2)
    axes.plot(*tip[:, None], "o", color=conchoid.SECOND, markersize=7)
    axes.plot(*conchoid.turned(curve, THETA_DEG), color=conchoid.SECOND, linewidth=2.0)
    axes.plot([0, tip[0]], [0, tip[1]], [0, 0], color="#555555", linestyle="--", linewidth=1)
    phi = np.radians(np.linspace(0, PHI_DEG, 40))
    axes.plot(11 * np.sin(phi) * np.cos(theta), -11 * np.sin(phi) * np.sin(theta), -11 * np.cos(phi), color="black")
    middle = 15 * np.array([np.sin(phi[20]) * np.cos(theta), -np.sin(phi[20]) * np.sin(theta), -np.cos(phi[20])])
    axes.text(*middle, "φ", ha="center", va="center", fontsize=14)
    turn = np.linspace(0, theta, 40)
    axes.plot(13 * np.cos(turn), -13 * np.sin(turn), 0 * turn, color="black")
    axes.text(17 * np.cos(turn[20]), -17 * np.sin(turn[20]), 0, "θ", ha="center", va="center", fontsize=14)


def main(options) -> common.Figure:
    curve = conchoid.cap(conchoid.load(options.results))
    figure = plt.figure(figsize=(9.6, 5.0))
    left, right = (conchoid.space(figure, (1, 2, k), 28) for k in (1, 2))
    draw_cap(left, curve, conchoid.CURVE)
    draw_cap(right, curve, common.THESIS_GREY)
    draw_coordinates(right, curve)
    left.set_title("a) the joint as turned conchoids, φ ≤ 90°", loc="center")
    right.set_title("b) φ from the apex, θ about the axis", loc="center")
    figure.subplots_adjust(left=0, right=1, bottom=0, top=0.93, wspace=0)
    return figure


common.run(main)
