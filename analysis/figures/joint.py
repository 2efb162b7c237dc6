# SPDX-License-Identifier: GPL-3.0-or-later
# @name      joint-SCENE
# @for       SCENE in SCENES
# @question  How wide is the gap between ball and socket of SCENE, and where, in the thesis' five colours?
# @depends   scenes/SCENE/{ball.ply,socket.ply,summary.json}
# @options   --scene SCENE
# @outputs   png
# @seconds   3 3
"""A joint coloured by its gap, from four sides."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import common
from common import gap_colours, hip, ply, render, sample_points, summaries

MARGIN = 1.03  # of a view


def views(ball: ply.Mesh, socket: ply.Mesh, summary: dict) -> dict[str, np.ndarray]:
    """Four images by title. The socket's axis points from the centre to the middle of the socket."""
    centre = np.array([summary["centre"][axis] for axis in "xyz"])
    axis = socket.vertices.mean(axis=0) - centre
    axis /= np.linalg.norm(axis)
    up = render.upwards(summary["axes"], axis)
    side = np.cross(axis, up)
    side /= np.linalg.norm(side)
    points = np.vstack([ball.vertices, socket.vertices])
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    both = float(np.linalg.norm(points - middle, axis=1).max())
    alone = {
        part: float(np.linalg.norm(mesh.vertices - centre, axis=1).max())
        for part, mesh in (("ball", ball), ("socket", socket))
    }
    ball_actor = gap_colours.coloured(ball, gap_colours.colours_of(summary, "ball"))
    socket_actor = gap_colours.coloured(socket, gap_colours.colours_of(summary, "socket"))
    glass = gap_colours.coloured(socket, gap_colours.colours_of(summary, "socket"), opacity=0.45)

    def seen(actors: list, focus: np.ndarray, towards: np.ndarray, size: float) -> np.ndarray:
        return render.picture(actors, render.View(focus, towards, up, MARGIN * size))

    return {
        "together, socket as glass": seen([ball_actor, glass], middle, side, both),
        "socket, from outside": seen([socket_actor], centre, -axis, alone["socket"]),
        "socket, from inside": seen([socket_actor], centre, axis, alone["socket"]),
        "ball, from the socket": seen([ball_actor], centre, -axis, alone["ball"]),
    }


def compose(images: dict[str, np.ndarray], name: str, summary: dict) -> plt.Figure:
    """The views two by two, a title and the legend."""
    figure, grid = plt.subplots(2, 2, figsize=(6.8, 7.6))
    for axes, (title, image) in zip(grid.flat, images.items()):
        axes.imshow(image)
        axes.set_title(title, loc="center", fontsize=10)
        axes.axis("off")
    smallest = summary["smallest_gap"]
    gap = f": smallest gap {smallest['gap_mm']:.2f} mm" if smallest else ""
    pose = f", {summary['pose'].replace('=', ' ')}°" if "=" in summary["pose"] else ""
    title = "Generated ball and socket" if name == sample_points.GENERATED else hip.title(name)
    figure.suptitle(f"{title}{pose}{gap}", fontsize=12, y=0.97)
    figure.legend(handles=gap_colours.legend(summary), loc="lower center", ncol=3, title="radial gap", fontsize=9)
    figure.subplots_adjust(left=0.02, right=0.98, top=0.90, bottom=0.14, wspace=0.02, hspace=0.10)
    return figure


def main(options) -> None:
    """Writes figures/joint-NAME.png."""
    folder: Path = options.results / "scenes" / options.scene
    summary = summaries.read(folder)
    ball, socket = ply.read(folder / "ball.ply"), ply.read(folder / "socket.ply")
    with render.screen():
        images = views(ball, socket, summary)
    figure = compose(images, options.scene, summary)
    path = options.out / "figures" / f"joint-{options.scene}.png"
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Software": None})


common.run(main, "--scene")
