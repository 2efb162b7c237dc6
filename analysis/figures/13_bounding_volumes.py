# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-13
# @question  Bounding volumes of a head and neck, and how much room each leaves empty (Figure 13).
# @data      diagram_sections
"""Figure 13: volumes that hold a bone, in a section of a generated head and neck, and how much room each leaves empty.
"""

import matplotlib.pyplot as plt
import numpy as np

import common
from common import diagram, diagram_section

BODY = "star_shape"  # of the sections: head and neck of a hip
ROUND = np.linspace(0, 2 * np.pi, 181)


def main(options) -> common.Figure:
    sections = common.load(options.results, "diagram_sections")
    segments = diagram_section.segments(sections, BODY)
    points = segments.reshape(-1, 2)
    own = area(max(diagram_section.loops(segments), key=len))
    volumes = {
        "a) sphere": sphere(points),
        "b) box along the axes": slabs(points, [0, 90]),
        "c) box along the bone": box(points),
        "d) eight fixed directions": slabs(points, [0, 45, 90, 135]),
    }
    figure, panels = plt.subplots(1, 4, figsize=(9.2, 2.9))
    for axes, (title, volume) in zip(panels, volumes.items()):
        diagram_section.section(axes, sections, BODY, fill=diagram.FILL["ball"], colors=diagram.BALL)
        diagram.polygon(axes, volume, facecolor="none", edgecolor=diagram.SOCKET)
        diagram.frame(axes, np.vstack(list(volumes.values())), room=0.02)
        diagram.title(axes, title)
        empty = 100 * (1 - own / area(volume))
        axes.text(0.5, -0.02, f"{empty:.0f} % empty", transform=axes.transAxes, ha="center", va="top", fontsize=8.5)
    figure.suptitle("Bounding volumes of a head and neck (section of a mesh)", fontsize=10.5)
    figure.subplots_adjust(left=0.005, right=0.995, top=0.80, bottom=0.08, wspace=0.04)
    return figure


def area(polygon: np.ndarray) -> float:
    """Of a closed line (n, 2)."""
    x, y = polygon.T
    return 0.5 * abs(x @ np.roll(y, 1) - y @ np.roll(x, 1))


def sphere(points: np.ndarray) -> np.ndarray:
    """The smallest about them, nearly: its centre moves by ever less towards the farthest point (Badoiu and Clarkson)."""
    centre = points.mean(axis=0)
    for step in range(1, 2000):
        farthest = points[np.argmax(np.linalg.norm(points - centre, axis=1))]
        centre = centre + (farthest - centre) / (step + 1)
    radius = np.linalg.norm(points - centre, axis=1).max()
    return centre + radius * np.stack([np.cos(ROUND), np.sin(ROUND)], axis=1)


def slabs(points: np.ndarray, degrees: list[float]) -> np.ndarray:
    """Corners of what the slabs across these directions have in common."""
    angles = np.radians([*degrees, *(180 + angle for angle in degrees)])
    normals = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    reach = (points @ normals.T).max(axis=0)
    following = np.roll(np.arange(len(angles)), -1)
    return np.array([np.linalg.solve(normals[[i, j]], reach[[i, j]]) for i, j in enumerate(following)])


def box(points: np.ndarray) -> np.ndarray:
    """The smallest box of any direction, to a degree."""
    return min((slabs(points, [angle, angle + 90]) for angle in range(90)), key=area)


common.run(main)
