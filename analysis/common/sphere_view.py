# SPDX-License-Identifier: GPL-3.0-or-later
"""The unit sphere seen from far away, shaded, with lines and points on it; what is behind it is drawn faintly."""

import math

import matplotlib.pyplot as plt
import numpy as np

SHADES = 400  # pixels across the shaded sphere
LIGHT = np.array([-0.45, 0.55, 0.70])  # from the left, above and in front, in the frame of the view


def view(elevation_deg: float, azimuth_deg: float) -> np.ndarray:
    """Rows right, up and towards the eye, for an eye above this azimuth; +z is up."""
    elevation, azimuth = math.radians(elevation_deg), math.radians(azimuth_deg)
    towards = np.array(
        [math.cos(elevation) * math.cos(azimuth), math.cos(elevation) * math.sin(azimuth), math.sin(elevation)]
    )
    right = np.array([-math.sin(azimuth), math.cos(azimuth), 0.0])
    return np.array([right, np.cross(towards, right), towards])


def draw_sphere(axes: plt.Axes) -> None:
    """Draws a pale ball on which lines stay readable."""
    at = np.linspace(-1, 1, SHADES)
    x, y = np.meshgrid(at, at)
    inside = x**2 + y**2 <= 1
    z = np.sqrt(np.where(inside, 1 - x**2 - y**2, 0))
    light = np.clip((np.stack([x, y, z], axis=-1) @ (LIGHT / np.linalg.norm(LIGHT))), 0, 1)
    grey = np.where(inside, 0.80 + 0.19 * light, 1.0)
    axes.imshow(grey, cmap="gray", vmin=0, vmax=1, extent=(-1, 1, -1, 1), origin="lower", zorder=0)
    axes.add_patch(plt.Circle((0, 0), 1, fill=False, color="#777777", linewidth=0.8, zorder=1))
    axes.set(xlim=(-1.06, 1.06), ylim=(-1.06, 1.06), aspect="equal")
    axes.axis("off")


def draw_line(axes: plt.Axes, points: np.ndarray, eye: np.ndarray, **look) -> None:
    """Draws a polyline of points (n, 3) on the sphere; `look` is for the part in front."""
    seen = points @ eye.T
    front = seen[:, 2] >= 0
    reached = front.copy()  # and the first point behind on either side, so that no gap is left
    reached[1:] |= front[:-1]
    reached[:-1] |= front[1:]
    for part, extra in ((reached, {"zorder": 3}), (~front, {"zorder": 2, "alpha": 0.22, "label": None})):
        x, y = (np.where(part, seen[:, k], np.nan) for k in (0, 1))
        axes.plot(x, y, **{**look, **extra})


def draw_points(axes: plt.Axes, points: np.ndarray, eye: np.ndarray, **look) -> None:
    """Draws markers at points (n, 3) of the sphere; `look` is for those in front."""
    seen = points @ eye.T
    front = seen[:, 2] >= 0
    look = {"linestyle": "none", **look}
    axes.plot(*seen[front, :2].T, **{"zorder": 4, **look})
    axes.plot(*seen[~front, :2].T, **{**look, "zorder": 2, "alpha": 0.22, "label": None})
