# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the clock of a socket round it, as the camera sees it."""

import matplotlib.pyplot as plt
import numpy as np

from common import hip, panels, render
from common.drawing import HALO, INK


def radius(joint: hip.Hip) -> float:
    """Radius of a dial that surrounds the socket, mm."""
    dial = hip.dial(joint)
    axis = np.cross(dial.twelve, dial.three)
    across = joint.socket.vertices - np.outer(joint.socket.vertices @ axis, axis)
    return 1.08 * float(np.linalg.norm(across, axis=1).max())


def camera(joint: hip.Hip, pixels: int = hip.PIXELS) -> render.View:
    """The camera of the medial view, with room for the dial."""
    seen = hip.view("medial", joint, [joint.socket], pixels)
    return render.View(hip.dial(joint).middle, seen.towards, seen.up, 1.52 * radius(joint), pixels)


def draw(axes: plt.Axes, panel: panels.Panel, joint: hip.Hip, fontsize: float = 9) -> None:
    """Draws the ring, ticks and hours."""
    dial, size = hip.dial(joint), radius(joint)

    def seen(hours: np.ndarray, share: float) -> np.ndarray:
        return np.array([panel.view.place(point) for point in dial.at(hours, share * size)])

    axes.plot(*seen(np.linspace(0, 12, 121), 1.0).T, color=INK, linewidth=0.9)
    for hour in range(1, 13):
        inner, outer, text = (seen(np.array([hour]), share)[0] for share in (0.97, 1.04, 1.14))
        axes.plot(*np.array([inner, outer]).T, color=INK, linewidth=0.9)
        axes.text(*text, str(hour), ha="center", va="center", fontsize=fontsize, color=INK, path_effects=HALO)
