# SPDX-License-Identifier: GPL-3.0-or-later
# @name      sampling-error-surfaces
# @question  How the error of an interpolated radius falls with the precision on four surfaces.
# @data      sampling_error_surfaces schemes
"""Largest error of an interpolated radius on four surfaces, a line a scheme."""

import matplotlib.pyplot as plt
import pandas as pd

import common

PANELS = {
    "sphere_5mm_off": "sphere of 44 mm, its centre 5 mm off",
    "conchoid": "conchoid of the hip, up to 90°",
    "head_mesh": "meshed head, truth: the mesh",
    "head_mesh_against_formula": "meshed head, truth: the smooth head",
}


def main(options) -> common.Figure:
    table = common.load(options.results, "sampling_error_surfaces")
    smooth = table[table.interpolant == "smooth"]
    figure, grid = plt.subplots(2, 2, figsize=(9.2, 7.2), sharex=True)
    looks = common.scheme_looks(list(smooth.scheme.unique()))
    labels = common.scheme_labels(options.results)
    for axes, (surface, title) in zip(grid.flat, PANELS.items()):
        draw(axes, smooth[smooth.surface == surface], looks, labels)
        axes.set_title(title)
    precisions = sorted(table.precision_deg.unique())
    grid[0, 0].set_xticks(precisions, [f"{p:g}°" for p in precisions])
    grid[0, 0].set_xlim(1.2 * precisions[-1], precisions[0] / 1.2)
    for axes in grid[1]:
        axes.set_xlabel("precision, finer to the right")
    for axes in grid[:, 0]:
        axes.set_ylabel("largest error of the radius, mm")
    figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(0.04, 0.0), ncols=4)
    figure.tight_layout()
    return figure


def draw(axes: plt.Axes, table: pd.DataFrame, looks: dict, labels: dict[str, str]) -> None:
    """Lines of all schemes, and two slopes to compare with."""
    for scheme, lines in table.groupby("scheme", sort=False):
        axes.plot(lines.precision_deg, lines.radial_max_mm, label=labels[scheme], **looks[scheme])
    coarse, fine = table.precision_deg.max(), table.precision_deg.min()
    top, low = table.radial_max_mm.max() * 1.6, table[table.precision_deg == coarse].radial_max_mm.min() / 1.6
    if top > 20 * table.radial_max_mm.min():
        axes.plot([coarse, fine], [top, top * fine / coarse], color="#555555", linewidth=0.8, linestyle=":")
        axes.annotate("first order", (coarse, top), ha="left", va="bottom", fontsize=8)
    if low > 100 * table.radial_max_mm.min():
        end = low * (fine / coarse) ** 2
        axes.plot([coarse, fine], [low, end], color="#555555", linewidth=0.8, linestyle=":")
        axes.annotate("second order", (fine, end), ha="right", va="top", fontsize=8)
    axes.set(xscale="log", yscale="log")
    if table.radial_max_mm.max() < 10 * table.radial_max_mm.min():
        axes.set_ylim(table.radial_max_mm.min() / 4, table.radial_max_mm.max() * 4)
        axes.text(0.5, 0.66, "the faces stay what they are", ha="center", transform=axes.transAxes, fontsize=8)
    axes.minorticks_off()


common.run(main)
