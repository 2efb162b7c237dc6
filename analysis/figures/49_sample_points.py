# SPDX-License-Identifier: GPL-3.0-or-later
# @question  Which points of the socket of JOINT do RSID and USID sample at 1 degree (Figure 49 of the thesis)?
# @data      lut_memory
# @depends   scenes/JOINT-{rsid,usid}/{socket.ply,summary.json}
# @options   --joint JOINT --name NAME
# @outputs   png svg pdf
# @seconds   4 4
# @name      figure-49
# @for       JOINT in generated
# @data      sample_points
# @name      figure-49-JOINT
# @for       JOINT in JOINTS
# @data      sample_points_bones
"""Figure 49, the points of a socket that the tables of the thesis sample at 1 degree, and close to the pole."""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle

import common
from common import ply, render, sample_points, summaries

BONE = (0.93, 0.89, 0.80)
CLOSE = 5.0  # mm from the pole to the border of the lower row
RING = "#b2182b"


def main(options) -> common.Figure:
    points = sample_points.load(options.results, options.joint)
    schemes = list(points.scheme.unique())
    folder = options.results / "scenes" / f"{options.joint}-{schemes[0]}"
    socket = ply.read(folder / "socket.ply")
    summary = summaries.read(folder)
    view = sample_points.inside_view(socket, summary)
    pole = sample_points.pole(points)
    with render.screen():
        rows = [pictures(socket, points, schemes, view, dot=2.6)]
        if pole is not None:
            close = replace(view, focus=pole, size=CLOSE)
            rows.append(pictures(socket, points, schemes, close, dot=7))
    memory = common.load(options.results, "lut_memory")
    memory = memory[memory.precision_deg == points.attrs["parameters"]["precision_deg"]]
    entries = memory.set_index("scheme").entries
    titles = [f"a) socket, {len(socket.triangles):,} triangles"]
    for letter, scheme in zip("bc", schemes):
        on_surface = len(sample_points.of_scheme(points, scheme))
        titles.append(f"{letter}) {common.label(scheme)}: {entries[scheme]:,} entries,\n{on_surface:,} on the socket (dots)")
    return compose(rows, titles, view, pole)


def pictures(socket: ply.Mesh, points, schemes: list[str], view: render.View, dot: float) -> list[np.ndarray]:
    """The socket alone, then with the points of each scheme."""
    plain = render.plain_surface(socket, BONE)
    images = [render.picture([render.plain_surface(socket, BONE, edges=True)], view)]
    for scheme in schemes:
        own = sample_points.dots(sample_points.of_scheme(points, scheme), view, dot)
        images.append(render.picture([plain, own], view))
    return images


def compose(
    rows: list[list[np.ndarray]], titles: list[str], view: render.View, pole: np.ndarray | None
) -> plt.Figure:
    """The views in a row; below, what the circle holds."""
    figure, grid = plt.subplots(len(rows), len(titles), figsize=(8.4, 2.8 * len(rows) + 0.75), squeeze=False)
    for line, images in zip(grid, rows):
        for axes, image in zip(line, images):
            axes.imshow(image, interpolation="none")
            axes.axis("off")
    for axes, title in zip(grid[0], titles):
        axes.set_title(title, loc="center", fontsize=9.5)
    if pole is not None:
        pixels = CLOSE / view.size * view.pixels / 2
        for axes in grid[0]:
            axes.add_patch(Circle(view.place(pole), pixels, fill=False, edgecolor=RING, linewidth=1.6))
        for axes in grid[1]:
            middle = (view.pixels - 1) / 2
            circle = Circle((middle, middle), view.pixels / 2 - 3, transform=axes.transData)
            axes.images[0].set_clip_path(circle)
            axes.add_patch(Circle(circle.center, circle.radius, fill=False, edgecolor=RING, linewidth=1.6))
        grid[1][0].set_title(f"the circle: {CLOSE:g} mm round the pole, $\\varphi = 0$", loc="center", fontsize=9.5)
    figure.suptitle("Points of a socket that the two tables of the thesis sample, at 1°", fontsize=10.5)
    figure.subplots_adjust(left=0.01, right=0.99, top=0.885, bottom=0.01, wspace=0.03, hspace=0.08)
    return figure


common.run(main, "--joint", "--name")
