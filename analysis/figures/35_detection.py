# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-35
# @question  One vertex looked up in three poses (Figure 35).
# @data      diagram_sections diagram_rays diagram_lookups
"""Figure 35: one vertex of the ball looked up in three poses: at rest, turned, and pushed into the socket."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import diagram, diagram_section

WINDOW = np.array([(-34, -30), (34, 38)])  # mm


def main(options) -> common.Figure:
    names = ("sections", "rays", "lookups")
    sections, rays, lookups = (common.load(options.results, f"diagram_{name}") for name in names)
    chosen = lookups.attrs["parameters"]
    titles = {
        "rest": "a) ball at rest",
        "turned": f"b) ball turned: {chosen['abduction_deg']:g}° of abduction",
        "pushed": f"c) ball pushed up by {chosen['push_mm']:g} mm",
    }
    figure, panels = plt.subplots(1, 3, figsize=(8.8, 4.1))
    for axes, pose in zip(panels, titles):
        vertex = lookups.set_index("pose").loc[pose]
        diagram_section.section(axes, sections, "socket", colors=diagram.SOCKET, linewidths=2.2)
        diagram_section.section(axes, sections, pose, fill=diagram.FILL["ball"], colors=diagram.BALL)
        diagram.dots(axes, diagram_section.in_section(rays, "socket"), markersize=3.2)
        diagram.frame(axes, WINDOW, room=0.0)
        draw_query(axes, vertex)
        diagram.title(axes, titles[pose])
    handles = [
        common.key("socket", color=diagram.SOCKET, linewidth=2.2),
        common.key("ball", color=diagram.BALL),
        common.key("sampled points", color=diagram.POINT, marker="o", markersize=4, linestyle="none"),
        common.key("vertex of the ball", color=diagram.POLE, marker="v", linestyle="none"),
        common.key("centre of the table", color=diagram.INK, marker="s", linestyle="none"),
    ]
    figure.legend(handles=handles, loc="lower center", ncol=5, fontsize=8.5, handletextpad=0.4, columnspacing=1.2)
    figure.suptitle(
        f"The same vertex, three poses, one table of the socket ({diagram.HIP}, from the front)", fontsize=10.5
    )
    figure.subplots_adjust(left=0.01, right=0.99, top=0.84, bottom=0.24, wspace=0.04)
    return figure


def draw_query(axes: plt.Axes, vertex: pd.Series) -> None:
    """The ray through the vertex, where the table has the socket, and the numbers below."""
    at = diagram_section.front(np.array([vertex.x, vertex.y, vertex.z]))
    hit = at * vertex.table_mm / vertex.vertex_mm
    far = at if vertex.gap_mm < 0 else hit
    axes.plot(*np.array([(0, 0), far]).T, color=diagram.POLE, linewidth=1.4, linestyle="--", zorder=4)
    diagram.dots(axes, np.zeros((1, 2)), marker="s", markersize=6)
    diagram.dots(axes, at[None], marker="v", markersize=9, color=diagram.POLE, markeredgecolor="white", zorder=7)
    diagram.dots(axes, hit[None], markersize=6, color=diagram.POLE, markeredgecolor="white", zorder=6)
    verdict = "impinged" if vertex.gap_mm <= 0 else "free"
    lines = [
        f"φ = {vertex.phi_deg:.1f}°, θ = {vertex.theta_deg:.1f}°",
        f"table {vertex.table_mm:.2f} − vertex {vertex.vertex_mm:.2f}",
        f"= gap {vertex.gap_mm:+.2f} mm: {verdict}".replace("-", "−"),
    ]
    axes.text(
        0.5, -0.03, "\n".join(lines), transform=axes.transAxes, ha="center", va="top", fontsize=9, linespacing=1.35
    )


common.run(main)
