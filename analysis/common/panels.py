# SPDX-License-Identifier: GPL-3.0-or-later
"""Sheets of pictures of a joint, each with a title, letters of the body's directions and a scale bar, above one legend."""

from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np

import common
from common import hip, render
from common.drawing import HALO, INK

LETTERS = {
    "left": (0.015, 0.5, "left", "center"),
    "right": (0.985, 0.5, "right", "center"),
    "top": (0.5, 0.985, "center", "top"),
    "bottom": (0.5, 0.015, "center", "bottom"),
}


@dataclass(frozen=True)
class Panel:
    """An image and the camera that took it; by default with scale bar and letters."""

    title: str
    image: np.ndarray
    view: render.View
    letters: bool = True


def take(title: str, actors: list, view: render.View) -> Panel:
    """Renders a picture of the actors."""
    return Panel(title, render.picture(actors, view), view)


def draw(axes: plt.Axes, panel: Panel) -> None:
    """Draws one panel; a point of the view's frame is at view.place() of its axes."""
    axes.imshow(panel.image, interpolation="none")
    axes.set_title(panel.title, loc="center", fontsize=common.SMALL)
    axes.axis("off")
    axes.autoscale(False)  # what is drawn later may leave the picture
    if not panel.letters:
        return
    for where, letter in hip.letters(panel.view).items():
        x, y, across, along = LETTERS[where]
        axes.text(
            x,
            y,
            letter,
            transform=axes.transAxes,
            ha=across,
            va=along,
            fontsize=common.SMALL,
            color=INK,
            weight="bold",
            path_effects=HALO,
        )
    scale_bar(axes, panel.view)


def scale_bar(axes: plt.Axes, view: render.View) -> None:
    """Draws a scale bar in the lower left corner: 5, 10, 20 or 50 mm, about a fifth of the picture."""
    length = min((5, 10, 20, 50), key=lambda mm: abs(mm - 0.4 * view.size))
    pixels = length / view.size * view.pixels / 2
    x, y = 0.03 * view.pixels, 0.965 * view.pixels
    axes.plot([x, x + pixels], [y, y], color=INK, linewidth=2.2, solid_capstyle="butt", path_effects=HALO)
    common.note(axes, f"{length} mm", (x + pixels / 2, y), (0, 3), ha="center", color=INK, path_effects=HALO)


def sheet(
    rows: list[list[Panel]], heading: str, legend: float = 0.55, titles: int = 1, width: float | None = None
) -> tuple[plt.Figure, np.ndarray]:
    """Panels in rows below a heading. `legend` inches are kept free below them, and room for `titles` lines above each. The
    axes have the shape of the rows. The default width, in inches, is what the paper has room for.
    """
    columns = max(len(row) for row in rows)
    width = width or {1: 3.6, 2: 4.6}.get(columns, 7.0)
    side = width / columns
    head = 0.30 + 0.17 * heading.count("\n")
    above = 0.12 + 0.15 * titles
    height = (side + above) * len(rows) + head + legend
    figure, grid = plt.subplots(len(rows), columns, figsize=(width, height), squeeze=False)
    for line, row in zip(grid, rows):
        for axes, panel in zip(line, row):
            draw(axes, panel)
        for axes in line[len(row) :]:
            axes.axis("off")
    figure.suptitle(heading, fontsize=9.5, y=1 - 0.08 / height, va="top")
    top = 1 - (head + above - 0.05) / height
    figure.subplots_adjust(left=0.01, right=0.99, top=top, bottom=legend / height, wspace=0.03, hspace=above / side)
    return figure, grid


def wrapped(figure: plt.Figure, text: str) -> str:
    """Small text that ends in hip.WAYS; in three lines if the figure is too narrow for one."""
    if len(text) < 16 * figure.get_figwidth():
        return text
    return text.replace("      ", "\n").replace(", R and", ",\nR and")
