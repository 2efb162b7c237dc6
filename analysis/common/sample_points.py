# SPDX-License-Identifier: GPL-3.0-or-later
"""The points of a socket that the two tables of the thesis sample, and the view that Figures 49 and 50 show.
"""

from pathlib import Path

import numpy as np
import pandas as pd

import common
from common import ply, render

GENERATED = "generated"  # the joint that no --bones brings
TILT = np.radians(22)  # so that the depth of the socket is seen
PIXELS = 560  # a side of one view: three stand side by side
GREEN = (0.0, 0.45, 0.33)
LIFT = 0.15  # mm by which points stand before the surface, so that they are not drawn inside it


def load(results: Path, joint: str) -> pd.DataFrame:
    """Columns scheme, entry, x, y, z for one joint."""
    if joint == GENERATED:
        return common.load(results, "sample_points")
    points = common.load(results, "sample_points_bones")
    return points[points.subject == joint]


def of_scheme(points: pd.DataFrame, scheme: str) -> np.ndarray:
    """The points (n, 3) of one scheme, mm."""
    return points.loc[points.scheme == scheme, ["x", "y", "z"]].to_numpy()


def pole(points: pd.DataFrame) -> np.ndarray | None:
    """The point at phi = 0, the first entry of either table; none if there is no surface."""
    first = points.loc[points.entry == 0, ["x", "y", "z"]]
    return first.iloc[0].to_numpy() if len(first) else None


def inside_view(socket: ply.Mesh, summary: dict) -> render.View:
    """The view into the socket, as the ball sees it, tilted towards its upper part, where a hip is impinged."""
    centre = np.array([summary["centre"][axis] for axis in "xyz"])
    axis = socket.vertices.mean(axis=0) - centre
    axis /= np.linalg.norm(axis)
    side = np.cross(axis, render.upwards(summary["axes"], axis))
    side /= np.linalg.norm(side)
    towards = np.cos(TILT) * axis + np.sin(TILT) * np.cross(side, axis)
    return render.framed(socket.vertices, towards, np.cross(side, towards), 0.525, PIXELS)


def dots(points: np.ndarray, view: render.View, size: float, colour=GREEN):
    """The points, just in front of the surface on which they lie."""
    return render.dots(points - LIFT * view.towards, colour, size)
