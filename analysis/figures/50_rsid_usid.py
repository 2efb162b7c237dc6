# SPDX-License-Identifier: GPL-3.0-or-later
# @question  Do RSID and USID give the same gaps on the socket of JOINT (Figure 50 of the thesis)?
# @depends   scenes/JOINT-{rsid,usid}/{socket.ply,summary.json}
# @options   --joint JOINT --name NAME
# @outputs   png svg pdf
# @seconds   3 3
# @name      figure-50
# @for       JOINT in generated
# @data      sample_points
# @name      figure-50-JOINT
# @for       JOINT in JOINTS
# @data      sample_points_bones
"""Figure 50, the gaps on the socket by the two tables of the thesis, with their sample points."""

import matplotlib.pyplot as plt
import numpy as np

import common
from common import gap_colours, ply, render, sample_points, summaries

DOT = (0.05, 0.3, 0.12)


def main(options) -> common.Figure:
    points = sample_points.load(options.results, options.joint)
    images, titles, gaps = [], [], []
    with render.screen():
        for letter, scheme in zip("ab", points.scheme.unique()):
            folder = options.results / "scenes" / f"{options.joint}-{scheme}"
            socket = ply.read(folder / "socket.ply")
            summary = summaries.read(folder)
            view = sample_points.inside_view(socket, summary)
            surface = gap_colours.coloured(socket, gap_colours.colours_of(summary, "socket"))
            own = sample_points.dots(sample_points.of_scheme(points, scheme), view, 1.6, DOT)
            images.append(render.picture([surface, own], view))
            gaps.append(socket.properties["gap"])
            titles.append(f"{letter}) {common.label(scheme)}: {smallest(gaps[-1])}")
    figure = compose(images, titles, heading(options.joint, summary, gaps))
    handles = gap_colours.legend(summary, ("socket",))
    figure.legend(handles=handles, loc="lower center", ncol=3, columnspacing=0.9, handlelength=1.4, title="radial gap")
    return figure


def smallest(gaps: np.ndarray) -> str:
    """The smallest gap of the socket's vertices, in words."""
    return "no gap" if np.isnan(gaps).all() else f"smallest gap {np.nanmin(gaps):.3f} mm"


def heading(joint: str, summary: dict, gaps: list[np.ndarray]) -> str:
    """Joint and pose, and how far the gaps are apart."""
    name = "generated pair" if joint == sample_points.GENERATED else joint.replace("_", " ")
    pose = summary["pose"].replace("=", " ").replace("_", " ") + ("°" if "=" in summary["pose"] else "")
    apart = np.abs(gaps[0] - gaps[1])
    largest = "" if np.isnan(apart).all() else f"gaps differ by at most {np.nanmax(apart):.3f} mm"
    return f"Socket, {name}, {pose}\n{largest}\npoints: entries of its table at {summary['precision_deg']:.3g}°"


def compose(images: list[np.ndarray], titles: list[str], heading_text: str) -> plt.Figure:
    """The two views side by side, with room for a legend below."""
    figure, grid = plt.subplots(1, len(images), figsize=(4.35, 3.7))
    for axes, image, title in zip(grid, images, titles):
        axes.imshow(image, interpolation="none")
        axes.set_title(title, loc="center", fontsize=common.SMALL)
        axes.axis("off")
    figure.suptitle(heading_text, fontsize=9.5, y=0.985)
    figure.subplots_adjust(left=0.01, right=0.99, top=0.80, bottom=0.15, wspace=0.03)
    return figure


common.run(main, "--joint", "--name")
