# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface of a socket unrolled, seen from medial: the angle from its pole goes outwards, the hours of its clock go round. The
rim, where hips are impinged, is edge-on in every view of the surface itself.
"""

from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.tri import Triangulation

import common
from common import hip, render
from common.drawing import INK

FAINT = "#505050"
LARGEST = 106.0  # degrees from the pole, where the map ends


@dataclass(frozen=True)
class SocketMap:
    """For each pixel the corners (3) and weights (3) of the face that it shows, and whether it shows one."""

    corners: np.ndarray
    weights: np.ndarray
    inside: np.ndarray

    def image(self, gap: np.ndarray, shades: render.Shades) -> np.ndarray:
        """Pixels (n, n, 3) in the colours of the vertices' gaps."""
        found = np.einsum("ijk,ijk->ij", gap[self.corners], self.weights)
        low, high = shades.limits
        place = (np.nan_to_num(found, nan=low) - low) / (high - low) * len(shades.rgb)
        colour = shades.rgb[np.clip(place.astype(int), 0, len(shades.rgb) - 1)]
        colour = np.where(np.isnan(found)[..., None], shades.nothing, colour)
        return np.where(self.inside[..., None], colour, 1.0)


def place(hours: np.ndarray, polar_deg: np.ndarray, joint: hip.Hip) -> np.ndarray:
    """Points (..., 2) of the map, right and up, 1 at its end. In the medial view of a right hip 3 o'clock is on the left."""
    angle = np.asarray(hours) * np.pi / 6
    radius = np.asarray(polar_deg) / LARGEST
    return np.stack([-joint.outwards * radius * np.sin(angle), radius * np.cos(angle)], axis=-1)


def unroll(joint: hip.Hip, pixels: int) -> SocketMap:
    """The map of a socket, `pixels` wide and high."""
    dial = hip.dial(joint)
    pole = np.cross(dial.twelve, dial.three)
    pole *= np.sign((joint.socket.vertices @ pole).mean())
    unit = joint.socket.vertices / np.linalg.norm(joint.socket.vertices, axis=1)[:, None]
    hours = np.arctan2(unit @ dial.three, unit @ dial.twelve) * 6 / np.pi
    points = place(hours, np.degrees(np.arccos(np.clip(unit @ pole, -1, 1))), joint)
    across = Triangulation(*points.T, joint.socket.triangles)
    at = (np.arange(pixels) + 0.5) / pixels * 2 - 1
    x, y = np.meshgrid(at, -at)
    face = across.get_trifinder()(x, y)
    corners = joint.socket.triangles[np.maximum(face, 0)]
    a, b, c = (points[corners[..., k]] for k in range(3))
    span = np.stack([b - a, c - a], axis=-1)
    share = np.linalg.solve(span, (np.stack([x, y], axis=-1) - a)[..., None])[..., 0]
    weights = np.stack([1 - share.sum(axis=-1), share[..., 0], share[..., 1]], axis=-1)
    return SocketMap(corners, weights, face >= 0)


def draw(axes: plt.Axes, image: np.ndarray, joint: hip.Hip, title: str = "") -> None:
    """Draws the image with its hours, and circles at 30, 60 and 90 degrees from the pole."""
    axes.imshow(image, extent=(-1, 1, -1, 1), interpolation="none")
    for polar in (30.0, 60.0, 90.0):
        axes.plot(*place(np.linspace(0, 12, 121), np.full(121, polar), joint).T, color=FAINT, linewidth=0.5)
    for hour in range(1, 13):
        axes.text(
            *place(hour, 1.02 * LARGEST, joint), str(hour), ha="center", va="center", fontsize=common.SMALL, color=INK
        )
    axes.text(*place(6, 90, joint), "90°", ha="center", va="bottom", fontsize=common.SMALL, color=INK)
    axes.set(xlim=(-1.12, 1.12), ylim=(-1.12, 1.12), aspect="equal")
    axes.set_title(title, loc="center", fontsize=common.SMALL)
    axes.axis("off")
