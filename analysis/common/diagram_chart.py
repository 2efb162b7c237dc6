# SPDX-License-Identifier: GPL-3.0-or-later
"""The chart of angles on which the thesis draws faces, and the entries of a table on it (Figures 30 to 34)."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.collections import PolyCollection

import common
from common import diagram

PHI, THETA = "polar angle φ, degrees", "azimuth θ, degrees"


def drawn(chart: pd.DataFrame, name: str) -> np.ndarray:
    """The flat triangles (n, 3 corners, theta phi radius) of one mesh; degrees and mm."""
    rows = chart[chart.name == name]
    return rows[["theta_deg", "phi_deg", "radius_mm"]].to_numpy().reshape(-1, 3, 3)


def chart_axes(axes: plt.Axes, title: str = "") -> None:
    """Axes with azimuth to the right and polar angle downwards: the north pole is the upper edge."""
    axes.set(xlabel=THETA, ylabel=PHI)
    axes.set_title(title, fontsize=9.5, loc="center")
    axes.grid(visible=False)


def turns(axes: plt.Axes, low: float = 0, high: float = 360, step: float = 60) -> None:
    """Sets the ticks of an azimuth."""
    axes.set(xlim=(low, high), xticks=np.arange(low, high + 1, step))


def area(axes: plt.Axes, corners: np.ndarray, **look) -> None:
    """Draws a polygon; a part that reaches across the seam also appears on the other side."""
    for turn in (-360, 0, 360):
        moved = corners + [turn, 0]
        if moved[:, 0].max() > 0 and moved[:, 0].min() < 360:
            diagram.polygon(axes, moved, **look)


def true_edges(axes: plt.Axes, face: np.ndarray, **look) -> None:
    """Draws the edges of a triangle in space on the chart: great circles, broken at the seam. No edge may go through a pole."""
    share = np.linspace(0, 1, 400)[:, None]
    for k in range(3):
        points = (1 - share) * face[k] + share * face[(k + 1) % 3]
        if np.hypot(points[:, 0], points[:, 1]).min() < 1e-2:  # mm: a meridian through the pole
            continue
        theta = np.degrees(np.arctan2(points[:, 1], points[:, 0])) % 360
        phi = np.degrees(np.arccos(points[:, 2] / np.linalg.norm(points, axis=1)))
        theta[1:][np.abs(np.diff(theta)) > 180] = np.nan
        axes.plot(theta, phi, **{"color": "black", "linewidth": 1.3, "linestyle": "--", "zorder": 5, **look})


def cells(axes: plt.Axes, entries: pd.DataFrame, **look) -> None:
    """Draws each entry of a table as a square as wide as the precision."""
    step = entries.precision_deg.iloc[0]
    half = step / 2
    corners = np.array([(-half, -half), (half, -half), (half, half), (-half, half)])
    places = step * entries[["column", "row"]].to_numpy(float)
    from_corner = {"linewidth": 0.25, "edgecolors": "white", "zorder": 1, **look}
    axes.add_collection(PolyCollection(places[:, None] + corners, **from_corner))


def of_face(coverage: pd.DataFrame, name: str, precision: float = 1.0) -> pd.DataFrame:
    """The entries that one mesh fills at one precision."""
    return coverage[(coverage.name == name) & (coverage.precision_deg == precision)]


def read_image(path: Path, limits: tuple[float, float]) -> np.ndarray:
    """Reads a binary PGM image of 8 bits: radii in mm by row and column, NaN where there is no surface."""
    data = path.read_bytes()
    kind, size, largest, pixels = data.split(b"\n", 3)
    columns, rows = map(int, size.split())
    if kind != b"P5" or largest != b"255" or len(pixels) != rows * columns:
        raise common.Refused(f"{path} is no whole image of 8 bits: remove it and run experiments/reproduce again")
    grey = np.frombuffer(pixels, np.uint8).reshape(rows, columns).astype(float)
    return np.where(grey == 0, np.nan, limits[0] + (grey - 1) / 254 * (limits[1] - limits[0]))
