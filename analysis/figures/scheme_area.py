# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scheme-area
# @question  How evenly does each scheme share the sphere among its entries?
# @data      schemes scheme_points
"""The area that each entry of every scheme stands for, on a map of the whole sphere that keeps areas."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import TwoSlopeNorm

import common
from common import scheme_plot

MOST = 4.0  # largest factor that colours tell apart
PIXELS = 420  # of a map's width


def main(options) -> common.Figure:
    table = common.load(options.results, "scheme_points")
    groups = dict(list(table.groupby("scheme")))
    directions, inside = mollweide(PIXELS)
    norm = TwoSlopeNorm(0, -np.log2(MOST), np.log2(MOST))
    images = []

    def draw(axes: plt.Axes, scheme: str) -> None:
        points = groups[scheme]
        ratio = np.full(inside.shape, np.nan)
        nearest = nearest_entries(points[["x", "y", "z"]].to_numpy(), directions)
        ratio[inside] = points.area_sr.to_numpy()[nearest] * len(points) / (4 * np.pi)
        images.append(
            axes.imshow(np.log2(ratio), cmap="PuOr", norm=norm, extent=(-2, 2, -1, 1), interpolation="nearest")
        )
        theta = np.linspace(0, 2 * np.pi, 361)
        axes.plot(2 * np.cos(theta), np.sin(theta), color="#777777", linewidth=0.6)
        least, most = np.nanmin(points.area_sr), np.nanmax(points.area_sr)
        axes.text(
            0,
            -1.08,
            f"largest / smallest {common.digits(most / least)}",
            ha="center",
            va="top",
            fontsize=7.5,
            color="#555555",
        )
        axes.set(xlim=(-2.05, 2.05), ylim=(-1.35, 1.05), aspect="equal")

    title = "Area that an entry stands for, on a map of the whole sphere (tables of about 1,600 entries)"
    figure = scheme_plot.panels(title, common.scheme_labels(options.results), draw, (2.15, 1.55))
    ticks = np.log2([1 / MOST, 1 / 2, 1, 2, MOST])
    bar = figure.colorbar(
        images[0],
        ax=figure.axes,
        orientation="horizontal",
        fraction=0.035,
        pad=0.03,
        aspect=50,
        ticks=ticks,
        extend="both",
    )
    bar.ax.set_xticklabels(["1/4 or less", "1/2", "mean area", "2", "4 or more"])
    return figure


def mollweide(width: int) -> tuple[np.ndarray, np.ndarray]:
    """Directions of the pixels of an equal-area map, x in [-2, 2], y in [-1, 1], and which are on it."""
    x, y = np.meshgrid((np.arange(width) + 0.5) / width * 4 - 2, 1 - (np.arange(width // 2) + 0.5) / (width // 2) * 2)
    inside = (x / 2) ** 2 + y**2 < 1
    angle = np.arcsin(y[inside])
    z = (2 * angle + np.sin(2 * angle)) / np.pi
    longitude = np.pi * x[inside] / (2 * np.cos(angle))
    across = np.sqrt(1 - z**2)
    return np.column_stack([across * np.cos(longitude), across * np.sin(longitude), z]), inside


def nearest_entries(entries: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """Number of the entry nearest to each direction, a few thousand directions at a time."""
    parts = np.array_split(directions, max(len(directions) // 4096, 1))
    return np.concatenate([np.argmax(part @ entries.T, axis=1) for part in parts])


common.run(main)
