# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies in the patient's frontal plane, seen from the front (Figures 26, 29 and 35)."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.collections import LineCollection
from matplotlib.patches import Polygon

from common import diagram


def front(points: np.ndarray) -> np.ndarray:
    """Points (..., 3) of the joint frame seen from the patient's front: the patient's right is on the left, superior above."""
    return np.asarray(points, float)[..., [0, 2]] * [-1, 1]


def segments(sections: pd.DataFrame, name: str) -> np.ndarray:
    """Segments (n, 2, 2) of one mesh, from the front."""
    rows = sections[sections.name == name]
    return rows[["x0", "z0", "x1", "z1"]].to_numpy().reshape(-1, 2, 2) * [-1, 1]


def section(axes: plt.Axes, sections: pd.DataFrame, name: str, fill: str | None = None, **look) -> None:
    """The section of a mesh by the frontal plane y = 0, seen from the front."""
    ends = segments(sections, name)
    look = {"linewidths": 1.6, "capstyle": "round", "zorder": 3, **look}
    axes.add_collection(LineCollection(ends, **look))
    if fill:
        for loop in loops(ends):
            axes.add_patch(Polygon(loop, facecolor=fill, edgecolor="none", zorder=1))


def loops(ends: np.ndarray) -> list[np.ndarray]:
    """Closed loops: the points of segments (n, 2, 2) whose ends meet, in order."""
    keys = [[tuple(end) for end in segment] for segment in ends.round(4).tolist()]
    keys = [segment for segment in keys if segment[0] != segment[1]]
    near: dict[tuple, list] = {}
    for segment in keys:
        for k in (0, 1):
            near.setdefault(segment[k], []).append(segment[1 - k])
    found = []
    while near:
        at = next(iter(near))
        loop = []
        while near.get(at):
            loop.append(at)
            following = near[at].pop()
            near[following].remove(at)
            if not near[at]:
                del near[at]
            at = following
        near.pop(at, None)
        found.append(np.array(loop))
    return found


def in_section(rays: pd.DataFrame, name: str, column: str = "nearest_mm") -> np.ndarray:
    """Where the rays of that plane meet the mesh, seen from the front; nothing for a ray that meets none."""
    rows = rays[(rays.name == name) & rays[column].notna()]
    return front(rows[column].to_numpy()[:, None] * diagram.direction(rows.phi_deg, rows.theta_deg))
