# SPDX-License-Identifier: GPL-3.0-or-later
# @name      fast-gaps
# @question  How long does a gap take, and how far off is it, beside Embree and the machine's limit?
# @data      all_gaps
"""Time of a vertex against the largest error of its gap, kernels in 16 bits beside Embree and the memory-bound baseline."""

import matplotlib.pyplot as plt
import pandas as pd

import common
from common import fast


def main(options) -> common.Figure:
    table = fast.load(options.results)
    rows = with_one_embree(shown(fast.plain_rows(table)))
    looks = common.scheme_looks(list(rows.line[rows.method != "floor"].unique()))
    figure, axes = plt.subplots(1, 2, figsize=(common.WIDTH, 3.2), sharey=True)
    for panel, (direction, title) in zip(axes, fast.DIRECTIONS.items()):
        draw(panel, rows[rows.direction == direction], looks)
        panel.set_title(title)
    axes[0].set_ylabel(f"time per vertex, ns\n(one thread, {fast.set_name(table)})")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="lower center", ncol=3)
    figure.tight_layout(rect=(0, 0.23, 1, 1))
    return figure


def shown(rows: pd.DataFrame) -> pd.DataFrame:
    """Kernels of tables in 16 bits or with corners, and the grid alone of the scalar ways: the table of times has the
    others, and there are colours for eight."""
    tables = rows.method.isin(["cube_gnomonic_mesh_exact", "rsid", "usid"])
    return rows[
        ~rows.method.isin([*fast.RAYS, *fast.CLOSEST, "usid_scalar"])
        & (~tables | rows.storage.isin(["uint16", "corners"]))
    ]


def with_one_embree(rows: pd.DataFrame) -> pd.DataFrame:
    """The fastest of Embree's ways in each direction stands for all."""
    rays = rows[rows.method.str.startswith("embree")]
    best = rows.loc[rays.groupby("direction").ns_vertex.idxmin()].assign(line="Embree, the fastest")
    return pd.concat([best, rows.drop(rays.index)])


def draw(axes: plt.Axes, rows: pd.DataFrame, looks: dict) -> None:
    """A line a method over its settings, bars of the interquartile range; the memory-bound baseline across."""
    common.medians(axes, rows, "error_um", "ns_vertex", "iqr_ns", looks)
    floor = rows[rows.method == "floor"].ns_vertex.iloc[0]
    axes.axhline(floor, color="black", linewidth=1.0, linestyle=":", label="memory-bound baseline: stream, rotate, one read")
    axes.set(xscale="log", yscale="log", xlabel="largest error of a gap, µm")


common.run(main)
