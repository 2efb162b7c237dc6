# SPDX-License-Identifier: GPL-3.0-or-later
"""What the diagrams of the thesis' algorithms share (Figures 25 to 35): faces on the chart, points in space seen from
far away, sections, and boxes of a flow chart.
"""

from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.patches import FancyBboxPatch, Polygon

import common
from common.drawing import HALO, INK

HIP = "generated stand-in for patient A"
BALL, SOCKET, POINT, POLE = "#B8860B", "#2B5C9E", "#202020", common.COLOURS[1]
FILL = {"ball": "#F3E3BC", "socket": "#C9DCF2"}
PARTS = [  # of a face, distinct in grey by their hatches
    {"facecolor": "#9CC9E8", "hatch": ""},
    {"facecolor": "#F2C294", "hatch": "////"},
    {"facecolor": "#A9D8C2", "hatch": "...."},
]


@dataclass(frozen=True)
class Eye:
    """A view from far away. The rows are right, up and towards the eye."""

    frame: np.ndarray

    def see(self, points: np.ndarray) -> np.ndarray:
        """Projects points (..., 3) onto the paper (..., 2)."""
        return np.asarray(points, float) @ self.frame[:2].T


def direction(phi_deg, theta_deg) -> np.ndarray:
    """Unit vectors (..., 3) of angles in degrees (Eq. 5 with d = 1)."""
    phi, theta = np.radians(phi_deg), np.radians(theta_deg)
    return np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), np.cos(phi) + 0 * theta], -1)


def faces(corners: pd.DataFrame, name: str) -> np.ndarray:
    """Corners (n, 3, 3) in mm of the faces of one mesh."""
    rows = corners[corners.name == name]
    return rows[["x", "y", "z"]].to_numpy().reshape(-1, 3, 3)


def arrow(axes: plt.Axes, tail, tip, text: str = "", **look) -> None:
    """Draws an arrow from one point of the paper to another, with a word at its tip."""
    look = {"color": INK, "linewidth": 1.1, "arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0, **look}
    axes.annotate("", tip, tail, arrowprops=look, annotation_clip=False)
    if text:
        way = np.subtract(tip, tail)
        way = way / np.hypot(*way)
        note(axes, tip, text, offset=9 * way, color=look["color"], fontsize=11)


def note(axes: plt.Axes, at, text: str, offset=(0, 0), **look) -> None:
    """Writes words beside a point, `offset` in points of the page, readable even on lines."""
    look = {
        "fontsize": 9,
        "color": INK,
        "ha": "center",
        "va": "center",
        "path_effects": HALO,
        "annotation_clip": False,
        **look,
    }
    axes.annotate(text, at, offset, textcoords="offset points", zorder=9, **look)


def title(axes: plt.Axes, text: str) -> None:
    """Writes a title above the middle of a panel."""
    axes.set_title(text, fontsize=9.5, loc="center")


def dots(axes: plt.Axes, points: np.ndarray, **look) -> None:
    """Draws markers at points (n, 2)."""
    look = {"color": POINT, "marker": "o", "markersize": 3, "linestyle": "none", "zorder": 5, **look}
    axes.plot(*np.asarray(points).T, **look)


def polygon(axes: plt.Axes, points: np.ndarray, **look) -> None:
    """Fills a polygon."""
    axes.add_patch(Polygon(points, **{"edgecolor": INK, "linewidth": 1.2, "zorder": 2, **look}))


def frame(axes: plt.Axes, points: np.ndarray, room: float = 0.12) -> None:
    """Sets limits round points (n, 2), with equal scales and no axes."""
    low, high = np.min(points, axis=0), np.max(points, axis=0)
    middle, reach = (low + high) / 2, (0.5 + room) * np.max(high - low)
    axes.set(xlim=middle[0] + reach * np.array([-1, 1]), ylim=middle[1] + reach * np.array([-1, 1]))
    axes.set_aspect("equal")
    axes.axis("off")


def box(axes: plt.Axes, middle, size, text: str, **look) -> None:
    """Draws a rounded box with words, in the units of the axes."""
    words = {key: look.pop(key) for key in ("fontsize", "color", "weight") if key in look}
    corner = np.subtract(middle, np.multiply(size, 0.5))
    look = {"facecolor": "white", "edgecolor": INK, "linewidth": 1.1, "zorder": 3, **look}
    style = "round,pad=0,rounding_size=0.12"
    axes.add_patch(FancyBboxPatch(corner, *size, boxstyle=style, **look))
    axes.text(*middle, text, ha="center", va="center", zorder=5, **{"fontsize": 9, **words})
