# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-26
# @question  Sampling and simulation in a section of a hip, and the entries that a look-up reads (Figure 26).
# @data      diagram_sections diagram_rays diagram_lookups diagram_excerpt
"""Figure 26: a section of a hip, the samples of its socket, a vertex of the ball looked up, and the entries that this
reads.
"""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import diagram, diagram_section

POSE = "rest"


def main(options) -> common.Figure:
    names = ("sections", "rays", "lookups", "excerpt")
    sections, rays, lookups, excerpt = (common.load(options.results, f"diagram_{name}") for name in names)
    vertex = lookups.set_index("pose").loc[POSE]
    figure, panels = plt.subplots(2, 2, figsize=(7.4, 7.6))
    joint, sampling, simulation, table = panels.flat
    for axes in (joint, sampling, simulation):
        diagram_section.section(axes, sections, "socket", colors=diagram.SOCKET, linewidths=2.2)
        window = np.array([(-45, -38), (36, 42)])
        diagram.frame(axes, window, room=0.0)
    for axes in (joint, simulation):
        diagram_section.section(axes, sections, POSE, fill=diagram.FILL["ball"], colors=diagram.BALL)
    name_parts(joint)
    sample(sampling, diagram_section.in_section(rays, "socket"))
    look_up(simulation, diagram_section.in_section(rays, "socket"), vertex)
    precision = lookups.attrs["parameters"]["precision_deg"]
    write_excerpt(table, excerpt[excerpt.pose == POSE], vertex, precision)
    diagram.title(joint, "a) hip, cut by the frontal plane,\nfrom the front")
    diagram.title(sampling, "b) sampling: the distance of the socket,\nhere every 5° of the plane")
    diagram.title(simulation, "c) simulation: a vertex of the ball\nagainst the distance in its direction")
    figure.suptitle(f"Sampling and simulation in two dimensions ({diagram.HIP})", fontsize=10.5)
    figure.subplots_adjust(left=0.01, right=0.985, top=0.885, bottom=0.02, wspace=0.03, hspace=0.16)
    return figure


def name_parts(axes: plt.Axes) -> None:
    """Words on both bones, and which way the picture is turned."""
    diagram.note(axes, (2, 2), "ball\n(femoral head)", fontsize=10)
    diagram.note(axes, (26, 33), "socket", fontsize=10, color=diagram.SOCKET)
    diagram.note(axes, (-27, -17), "neck", fontsize=10)
    diagram.note(axes, (-43, 3), "R", weight="bold")
    diagram.note(axes, (34, 3), "L", weight="bold")
    axes.plot([8, 28], [-35, -35], color=diagram.INK, linewidth=2.2, solid_capstyle="butt")
    diagram.note(axes, (18, -35), "20 mm", (0, 8), fontsize=8)


def sample(axes: plt.Axes, points: np.ndarray) -> None:
    """The rays that meet the socket, and where."""
    for point in points:
        axes.plot(*np.array([(0, 0), point]).T, color="#707070", linewidth=0.7, linestyle="--", zorder=2)
    diagram.dots(axes, points, markersize=4)
    diagram.dots(axes, np.zeros((1, 2)), marker="s", markersize=7)
    diagram.note(axes, (0, 0), "centre of rotation", (0, -14))
    diagram.note(axes, (-28, -6), "no surface:\nthe entries\nstay empty", fontsize=8.5)


def look_up(axes: plt.Axes, points: np.ndarray, vertex: pd.Series) -> None:
    """The ray through the vertex to the socket; the gap is what is left."""
    at = diagram_section.front(np.array([vertex.x, vertex.y, vertex.z]))
    hit = at * vertex.table_mm / vertex.vertex_mm
    diagram.dots(axes, points, markersize=3)
    axes.plot(*np.array([(0, 0), hit]).T, color=diagram.POLE, linewidth=1.6, zorder=4)
    diagram.dots(axes, np.zeros((1, 2)), marker="s", markersize=7)
    diagram.dots(axes, at[None], marker="v", markersize=8, color=diagram.POLE, markeredgecolor="white")
    diagram.dots(axes, hit[None], markersize=6.5, color=diagram.POLE, markeredgecolor="white", zorder=6)
    diagram.note(axes, at, f"vertex: $d_i$ = {vertex.vertex_mm:.2f} mm", (-54, -11), fontsize=8.5)
    diagram.note(axes, hit, f"table: $d$ = {vertex.table_mm:.2f} mm", (-10, 14), fontsize=8.5)
    diagram.note(axes, (-2, -9), f"gap = $d - d_i$ = {vertex.gap_mm:.2f} mm\n> 0: no impingement", fontsize=9.5)


def write_excerpt(axes: plt.Axes, excerpt: pd.DataFrame, vertex: pd.Series, precision: float) -> None:
    """Radii by row and column; shaded by their weight."""
    rows, columns = sorted(excerpt.row.unique()), list(dict.fromkeys(excerpt.column))
    for entry in excerpt.itertuples():
        x, y = columns.index(entry.column), rows.index(entry.row)
        shade = 1 - 0.55 * entry.weight
        colour = (1, shade, 0.55 * shade + 0.2) if entry.weight > 0 else "white"
        axes.add_patch(plt.Rectangle((x - 0.5, y - 0.5), 1, 1, facecolor=colour, edgecolor="#909090"))
        axes.text(
            x,
            y - (0.14 if entry.weight > 0 else 0),
            f"{entry.radius_mm:.2f}",
            ha="center",
            va="center",
            fontsize=8,
            weight="bold" if entry.weight > 0 else "normal",
        )
        if entry.weight > 0:
            axes.text(x, y + 0.24, f"× {entry.weight:.2f}", ha="center", va="center", fontsize=7)
    axes.set(
        xlim=(-0.5, len(columns) - 0.5),
        ylim=(len(rows) - 0.5, -0.5),
        xticks=range(len(columns)),
        yticks=range(len(rows)),
        xlabel="θ, degrees (the table closes at 360)",
        ylabel="φ, degrees",
    )
    axes.set_xticklabels([f"{column * precision:g}" for column in columns], fontsize=8.5)
    axes.set_yticklabels([f"{row * precision:g}" for row in rows], fontsize=8.5)
    axes.tick_params(length=0)
    axes.grid(visible=False)
    axes.set_box_aspect(0.78)
    diagram.title(
        axes,
        f"d) the table there, mm; shaded, with weights:\n"
        f"what φ = {vertex.phi_deg:.2f}°, θ = {vertex.theta_deg:.2f}° reads",
    )
    axes.set_anchor("N")


common.run(main)
