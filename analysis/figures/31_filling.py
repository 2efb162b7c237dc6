# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-31
# @question  All triangles of a socket on the chart, and the table that they fill (Figure 31).
# @data      diagram_chart
# @depends   data/diagrams/socket_table.pgm
# @outputs   png svg pdf
# @seconds   5 5
"""Figure 31: all triangles of a socket on the chart, and the table that they fill at 0.1 degrees."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

import common
from common import diagram, diagram_chart

MESH = "socket"
DETAIL = (166.0, 178.0, 66.0, 74.0)  # degrees: azimuth from, to; polar angle from, to
EMPTY = "#f7efe3"


def main(options) -> common.Figure:
    chart = common.load(options.results, "diagram_chart")
    triangles = diagram_chart.drawn(chart, MESH)
    limits = tuple(chart.attrs["parameters"][f"image_{end}_mm"] for end in ("smallest", "largest"))
    step = chart.attrs["parameters"]["image_precision_deg"]
    table = diagram_chart.read_image(options.results / "data" / "diagrams" / "socket_table.pgm", limits)
    colours = plt.get_cmap("gray").with_extremes(bad=EMPTY)
    figure = plt.figure(figsize=(8.8, 5.8))
    top, bottom, detail, pixels = (figure.add_subplot(2, 4, where) for where in ((1, 3), (5, 7), 4, 8))
    mapped(top, triangles, colours, limits)
    faces = chart.face[chart.name == MESH].nunique()
    diagram_chart.chart_axes(top, f"a) {faces:,} triangles on the chart, grey by distance")
    rows, columns = table.shape
    image = filled(bottom, table, step, colours, limits)
    diagram_chart.chart_axes(bottom, f"b) the table they fill at {step:g}°: {rows:,} × {columns:,} entries")
    for axes in (top, bottom):
        diagram_chart.turns(axes)
        axes.set(ylim=(180, 0), yticks=np.arange(0, 181, 30), facecolor=EMPTY)
        left, right, upper, lower = DETAIL
        corners = [(left - 2, upper - 2), (right + 2, upper - 2), (right + 2, lower + 2), (left - 2, lower + 2)]
        diagram.polygon(axes, np.array(corners), facecolor="none", edgecolor=diagram.POLE, linewidth=1.5, zorder=6)
    mapped(detail, triangles, colours, limits, edges=True)
    filled(pixels, table, step, colours, limits)
    for axes, title in ((detail, "c) detail of a)"), (pixels, "d) detail of b)")):
        close(axes, title)
    top.set_xlabel("")
    detail.set_xlabel("")
    figure.subplots_adjust(left=0.07, right=0.985, top=0.87, bottom=0.26, hspace=0.36, wspace=0.5)
    bar = figure.colorbar(image, cax=figure.add_axes((0.2, 0.11, 0.6, 0.025)), orientation="horizontal")
    bar.set_label("distance from the centre of rotation, mm; no surface where the chart is tinted")
    figure.suptitle(f"Filling the table of a socket ({diagram.HIP})", fontsize=10.5, y=0.96)
    return figure


def mapped(axes: plt.Axes, triangles: np.ndarray, colours, limits, edges: bool = False) -> None:
    """Each triangle in the grey of its mean distance, on both sides of the seam."""
    corners = np.concatenate([triangles + [turn, 0, 0] for turn in (-360, 0, 360)])
    shades = colours(plt.Normalize(*limits)(corners[:, :, 2].mean(axis=1)))
    edge, width = ("#3b6ea5", 0.8) if edges else (shades, 0.2)
    axes.add_collection(
        PolyCollection(corners[:, :, :2], facecolors=shades, edgecolors=edge, linewidths=width, rasterized=True)
    )


def filled(axes: plt.Axes, table: np.ndarray, step: float, colours, limits):
    """The table as an image: a pixel an entry."""
    rows, columns = table.shape
    extent = ((-0.5) * step, (columns - 0.5) * step, (rows - 0.5) * step, -0.5 * step)
    return axes.imshow(table, cmap=colours, vmin=limits[0], vmax=limits[1], extent=extent, aspect="auto")


def close(axes: plt.Axes, title: str) -> None:
    """The window of the details, framed as it is marked."""
    left, right, upper, lower = DETAIL
    axes.set(xlim=(left, right), ylim=(lower, upper), xlabel="θ, degrees")
    diagram.title(axes, title)
    axes.grid(visible=False)
    for spine in axes.spines.values():
        spine.set(visible=True, color=diagram.POLE, linewidth=1.5)


common.run(main)
