# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-45
# @question  A head cut by the slices of a CT scan (Figure 45 of the thesis).
# @data      slices
"""Figure 45: a head cut by the slices of a CT scan, a) in space, b) from the side with the angle of a slice."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common


def main(options) -> common.Figure:
    slices = common.load(options.results, "slices")
    radius = slices.attrs["parameters"]["head_diameter_mm"] / 2
    figure = plt.figure(figsize=(9.2, 4.6))
    draw_space(figure.add_subplot(1, 2, 1, projection="3d"), slices, radius)
    draw_side(figure.add_subplot(1, 2, 2), slices, radius)
    figure.subplots_adjust(left=0.01, right=0.99, bottom=0.01, top=0.9, wspace=0.08)
    return figure


def draw_space(axes: plt.Axes, slices: pd.DataFrame, radius: float) -> None:
    """The circles in which the slices cut the sphere, the near half drawn darker."""
    turn = np.linspace(0, 2 * np.pi, 181)
    azimuth = np.radians(-60)
    for height in sorted({*slices.height_mm, *-slices.height_mm}):
        ring = np.sqrt(radius**2 - height**2)
        near = np.cos(turn - azimuth) >= -0.15
        x, y = ring * np.cos(turn), ring * np.sin(turn)
        middle = height == 0
        colour = common.COLOURS[1] if middle else common.COLOURS[0]
        axes.plot(x, y, height, color=common.THESIS_GREY, linewidth=0.4)
        axes.plot(*np.where(near, [x, y], np.nan), height, color=colour, linewidth=1.8 if middle else 1)
    corner = radius * 1.02 * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]])
    axes.plot(corner[:, 0], corner[:, 1], 0, color=common.COLOURS[1], linewidth=0.8, linestyle="--")
    axes.text2D(-0.01, 0.55, "middle\nplane", color=common.COLOURS[1], fontsize=9, transform=axes.transAxes)
    axes.set_box_aspect((1, 1, 1), zoom=1.35)
    axes.set(xlim=(-radius, radius), ylim=(-radius, radius), zlim=(-radius, radius))
    axes.view_init(elev=14, azim=-60)
    axes.set_axis_off()
    thickness = slices.attrs["parameters"]["thickness_mm"]
    title(axes, 0.03, f"a) {2 * len(slices) - 1} slices, {thickness:g} mm apart, cut a head of {2 * radius:g} mm")


def draw_side(axes: plt.Axes, slices: pd.DataFrame, radius: float, shown: int = 8) -> None:
    """The same from the side; one slice with its height and angle."""
    turn = np.linspace(0, 2 * np.pi, 361)
    axes.plot(radius * np.cos(turn), radius * np.sin(turn), color="black", linewidth=1.4)
    for index, height in zip(slices.slice, slices.height_mm):
        half = np.sqrt(radius**2 - height**2)
        for z in {height, -height}:
            style = {"color": common.COLOURS[1], "linewidth": 1.6} if index == 0 else {"color": common.COLOURS[0]}
            axes.plot([-half, half], [z, z], **{"linewidth": 0.9, **style})
    line = slices.set_index("slice").loc[shown]
    phi = np.radians(line.phi_deg)
    point = radius * np.array([np.sin(phi), np.cos(phi)])
    axes.annotate("", (0, 1.22 * radius), (0, 0), arrowprops={"arrowstyle": "->", "linewidth": 1.2})
    axes.plot([0, point[0]], [0, point[1]], color="black", linewidth=1.6, marker="o", markersize=5)
    arc = np.linspace(0, phi, 40)
    axes.plot(0.35 * radius * np.sin(arc), 0.35 * radius * np.cos(arc), color="black", linewidth=1.2)
    boxed = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
    middle = 0.47 * radius * np.array([np.sin(phi / 2), np.cos(phi / 2)])
    axes.text(*middle, "φ", ha="center", va="center", fontsize=12, bbox=boxed)
    axes.text(point[0] * 0.62 + 1.6, point[1] * 0.62 - 1.6, "r", fontsize=11, ha="center", va="center", bbox=boxed)
    axes.annotate(
        "",
        (-0.5 * radius, line.height_mm),
        (-0.5 * radius, 0),
        arrowprops={"arrowstyle": "<->", "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0},
    )
    label = {"ha": "right", "va": "center", "fontsize": 9, "bbox": boxed}
    axes.text(-0.53 * radius, line.height_mm / 2, f"i ΔT (i = {shown})", **label)
    axes.text(1.08 * radius, 0, "middle\nplane", color=common.COLOURS[1], va="center", fontsize=9)
    axes.text(0.03 * radius, 1.22 * radius, "z", va="top")
    axes.set_aspect("equal")
    axes.set(xlim=(-1.1 * radius, 1.4 * radius), ylim=(-1.06 * radius, 1.26 * radius))
    axes.set_axis_off()
    title(axes, 0.55, "b) slice i meets the sphere at φ = arccos(i ΔT / r)")


def title(axes: plt.Axes, left: float, text: str) -> None:
    """At one height for both kinds of axes; left edge as a share of the figure."""
    axes.figure.text(left, 0.98, text, fontsize=11, va="top")


common.run(main)
