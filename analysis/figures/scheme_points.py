# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scheme-points
# @question  Where does each scheme sample?
# @data      schemes scheme_points
"""The entries of every scheme on the sphere, side by side."""

import matplotlib.pyplot as plt
import numpy as np

import common
from common import scheme_plot, sphere_view

VIEW = sphere_view.view(elevation_deg=38, azimuth_deg=20)


def main(options) -> common.Figure:
    table = common.load(options.results, "scheme_points")
    groups = dict(list(table.groupby("scheme")))

    def draw(axes: plt.Axes, scheme: str) -> None:
        x, y, towards = VIEW @ groups[scheme][["x", "y", "z"]].to_numpy().T
        axes.add_patch(plt.Circle((0, 0), 1, facecolor="#f1f1f1", edgecolor=common.THESIS_GREY, linewidth=0.6))
        draw_line(axes, np.radians(90))
        draw_pole(axes)
        front = towards > 0
        axes.scatter(x[front], y[front], s=0.9, color=common.COLOURS[0], linewidths=0, zorder=3)
        axes.text(0, -1.1, f"{len(x):,}", ha="center", va="top", fontsize=common.SMALL, color="#555555")
        axes.set(xlim=(-1.03, 1.03), ylim=(-1.25, 1.03), aspect="equal")

    title = "Where each scheme samples, and its entries\n(ring: the north pole; line: the equator)"
    return scheme_plot.panels(title, common.scheme_labels(options.results), draw, (1.05, 1.6))


def draw_line(axes: plt.Axes, phi: float) -> None:
    """The part of a parallel in front."""
    theta = np.linspace(0, 2 * np.pi, 721)
    circle = np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), np.full_like(theta, np.cos(phi))])
    x, y, towards = VIEW @ circle
    axes.plot(np.where(towards > 0, x, np.nan), np.where(towards > 0, y, np.nan), color="#888888", linewidth=0.7)


def draw_pole(axes: plt.Axes) -> None:
    """A ring round the north pole."""
    x, y, _ = VIEW @ np.array([0.0, 0.0, 1.0])
    axes.plot(x, y, marker="o", markersize=11, markerfacecolor="none", markeredgecolor=common.COLOURS[1], zorder=4)


common.run(main)
