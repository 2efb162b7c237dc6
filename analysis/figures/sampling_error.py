# SPDX-License-Identifier: GPL-3.0-or-later
# @name      sampling-error
# @question  The thesis' sampling error beside the errors of a table of the head, for every scheme.
# @data      sampling_error sampling_error_surfaces schemes
"""The thesis' sampling error (Eq. 7) beside the errors that a table of the head really makes, a panel a scheme."""

import math

import matplotlib.pyplot as plt
import pandas as pd

import common

HEAD = "head_mesh"
ROUND = "sphere"
COLUMNS = 4
LINES = {
    "tangential": "distance along the surface to the nearest entry, measured on a sphere of 44 mm",
    "nearest": "radius of the nearest entry, largest error on the meshed head",
    "smooth": "interpolated radius, largest error",
    "rms": "interpolated radius, root mean square",
}


def main(options) -> common.Figure:
    errors = common.load(options.results, "sampling_error")
    surfaces = common.load(options.results, "sampling_error_surfaces")
    schemes = list(errors.scheme.unique())
    labels = common.scheme_labels(options.results)
    rows = math.ceil((len(schemes) + 1) / COLUMNS)
    figure, grid = plt.subplots(rows, COLUMNS, figsize=(9.6, 2.15 * rows + 0.5), sharex=True, sharey=True)
    looks = common.look(list(LINES))
    panels = list(grid.flat)
    for axes, scheme in zip(panels, schemes):
        draw(axes, errors[errors.scheme == scheme], surfaces[surfaces.scheme == scheme], looks)
        axes.set_title(labels[scheme], fontsize=9)
    for axes in panels[len(schemes) :]:
        axes.set_visible(False)
    label_axes(grid, len(schemes), sorted(errors.precision_deg.unique()))
    figure.legend(*panels[0].get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(0.02, 0.0), ncols=1)
    figure.suptitle("What Eq. 7 of the thesis gives, and how wrong a radius is", x=0.02, ha="left", fontsize=11)
    figure.tight_layout(rect=(0, 0, 1, 0.99))
    return figure


def draw(axes: plt.Axes, errors: pd.DataFrame, surfaces: pd.DataFrame, looks: dict) -> None:
    """Formula in grey, then the four measured lines, over the precision."""
    smooth = surfaces[surfaces.interpolant == "smooth"]
    lines = {
        "tangential": (smooth[smooth.surface == ROUND], "tangential_max_mm"),
        "nearest": (surfaces[(surfaces.surface == HEAD) & (surfaces.interpolant == "nearest")], "radial_max_mm"),
        "smooth": (errors, "measured_max_mm"),
        "rms": (errors, "measured_rms_mm"),
    }
    axes.plot(
        errors.precision_deg, errors.formula_max_mm, color=common.THESIS_GREY, linewidth=4, alpha=0.6, label="Eq. 7"
    )
    for name, (table, column) in lines.items():
        axes.plot(table.precision_deg, table[column], label=LINES[name], **{**looks[name], "markersize": 4})
    axes.set(xscale="log", yscale="log")


def label_axes(grid, panels: int, precisions: list[float]) -> None:
    """Finer to the right; numbers below the lowest panel of each column, units at the left."""
    for k in range(panels):
        axes = grid[k // COLUMNS, k % COLUMNS]
        axes.set_xticks(precisions, [f"{p:g}°" for p in precisions])
        axes.set_xlim(1.25 * precisions[-1], precisions[0] / 1.25)
        axes.minorticks_off()
        axes.tick_params(labelbottom=k + COLUMNS >= panels)
        if k % COLUMNS == 0:
            axes.set_ylabel("mm")
        if k + COLUMNS >= panels:
            axes.set_xlabel("precision")


common.run(main)
