# SPDX-License-Identifier: GPL-3.0-or-later
# @name      certified-motion
# @question  How are one turn, and all rotations, decided without sampled poses?
# @seconds   1 1
"""A drawing: a ball with a bump that turns under a rim, the sinusoids whose first root is the limit, and cells of rotations."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Polygon, Rectangle

import common

RIM, INNER, OUTER = 75, 1.2, 1.45  # degrees, and radii of the socket
BUMP, HEIGHT, WIDE = 122, 0.24, 11  # degrees, of the head's radius, degrees
STEP = 5  # degrees, of those that test poses
GRAZE, LASTS = 27.5, 3.2  # where one vertex grazes a face, and for how long
OPEN, FREE, BLOCKED = "#f2c14e", "#cfe6f5", "#9a9a9a"


def main(options) -> common.Figure:
    figure, (turn, events, cells) = plt.subplots(1, 3, figsize=(common.WIDTH, 3.1), width_ratios=(1, 1.35, 1))
    limit = draw_turn(turn)
    draw_events(events, limit)
    draw_cells(cells)
    figure.tight_layout(w_pad=1.5)
    return figure


def at(degrees, radius):
    """Points of the plane."""
    return np.column_stack([radius * np.cos(np.radians(degrees)), radius * np.sin(np.radians(degrees))])


def draw_turn(axes: plt.Axes) -> float:
    """Section: at the start, and at the first contact; how far it is to that."""
    angles = np.arange(-180, 180, 5.5)
    radii = 1 + HEIGHT * np.exp(-(((angles - BUMP) / WIDE) ** 2))
    tip = np.argmax(radii)
    arc = np.linspace(-15, RIM, 12)
    socket = np.concatenate([at(arc, INNER), at(arc[::-1], OUTER)])
    limit = angles[tip] - RIM
    axes.add_patch(Polygon(socket, facecolor="#d8d8d8", edgecolor="black", linewidth=1))
    axes.add_patch(Polygon(at(angles, radii), facecolor="#fbe3d3", edgecolor=common.COLOURS[1], linewidth=1.2))
    axes.add_patch(Polygon(at(angles - limit, radii), fill=False, edgecolor=common.COLOURS[0], linewidth=1.2, linestyle="--"))
    way = at(np.linspace(angles[tip], RIM + 4, 20), radii[tip] + 0.12)
    axes.annotate("", way[-1], way[-3], arrowprops={"arrowstyle": "->", "color": "black"})
    axes.plot(*way.T, color="black", linewidth=1)
    common.note(axes, "t", way[8], (-4, 5))
    axes.plot(0, 0, marker="+", color="black", markersize=8)
    axes.plot(*at(RIM, radii[tip]).T, marker="o", color=common.COLOURS[0])
    axes.set(xlim=(-1.35, 1.55), ylim=(-1.1, 1.75), aspect="equal", title="a) One turn")
    axes.set_axis_off()
    return limit


def draw_events(axes: plt.Axes, section: float) -> None:
    """How far pairs of features are apart: those of the section, and a graze beside it."""

    def graze(t):
        return 1 - np.cos(np.radians(t - GRAZE)) - (1 - np.cos(np.radians(LASTS / 2)))

    t = np.linspace(0, 60, 400)
    for colour, shift, size in ((common.COLOURS[0], section, 0.8), (common.COLOURS[1], section + 9, 0.66)):
        axes.plot(t, size * np.sin(np.radians(shift - t)), color=colour, linewidth=1.2)
    axes.plot(t, graze(t), color=common.COLOURS[3], linewidth=1.2)
    axes.axhline(0, color="black", linewidth=0.8)
    first = GRAZE - LASTS / 2
    for x, words, offset in ((first, "limit: first root", (-62, -32)), (section, "poses in steps\nstop here", (-20, -42))):
        common.note(axes, words, (x, 0), offset, arrowprops={"arrowstyle": "->"})
    axes.set(xlabel="t, degrees", ylim=(-0.38, 0.95), xlim=(0, 60), yticks=[0], title="b) Its events: a cos t + b sin t + c")
    zoom = axes.inset_axes((0.44, 0.55, 0.54, 0.36))
    near = np.linspace(GRAZE - 6, GRAZE + 6, 100)
    zoom.plot(near, graze(near), color=common.COLOURS[3], linewidth=1.2)
    steps = np.array([GRAZE - STEP / 2, GRAZE + STEP / 2])
    common.marks(zoom, steps, graze(steps), marker="o", color="black", markersize=4)
    zoom.axhline(0, color="black", linewidth=0.8)
    zoom.axvspan(first - 0.15, first + 0.15, color=common.COLOURS[0], alpha=0.4, linewidth=0)
    deep = -graze(GRAZE)
    zoom.set(xlim=(GRAZE - 5, GRAZE + 5), ylim=(-1.4 * deep, 4 * deep), xticks=[], yticks=[])
    zoom.set_title("a graze between two steps", fontsize=common.SMALL)
    axes.indicate_inset_zoom(zoom, edgecolor="black")


def draw_cells(axes: plt.Axes) -> None:
    """A section through the rotations, halved where it is open."""

    def free(x, y):
        return 0.78 - 0.30 * x - 0.28 * x * np.sin(5 * x) - y

    def split(x: float, y: float, size: float, depth: int) -> None:
        corners = [free(x + i * size, y + j * size) for i in np.linspace(0, 1, 9) for j in np.linspace(0, 1, 9)]
        colour = FREE if min(corners) > 0.004 else BLOCKED if max(corners) < -0.004 else OPEN
        if colour == OPEN and depth:
            for i, j in ((0, 0), (1, 0), (0, 1), (1, 1)):
                split(x + i * size / 2, y + j * size / 2, size / 2, depth - 1)
        else:
            axes.add_patch(Rectangle((x, y), size, size, facecolor=colour, edgecolor="white", linewidth=0.5))

    split(0, 0, 1, 5)
    for text, place in (("free", (0.28, 0.25)), ("blocked", (0.66, 0.85))):
        axes.text(*place, text, ha="center", va="center")
    axes.annotate("open", (0.12, 0.74), (0.2, 0.94), va="center", arrowprops={"arrowstyle": "->"})
    axes.set(xlim=(0, 1), ylim=(0, 1), aspect="equal", xticks=[], yticks=[], xlabel="flexion", ylabel="internal rotation", title="c) All rotations")


common.run(main)
