# SPDX-License-Identifier: GPL-3.0-or-later
# @name      fast-speed-up
# @question  How many times as fast as Embree's rays is each of our methods and each other library?
# @data      all_gaps
"""How many times as fast as Embree's rays every way to find gaps is, and every peer."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import fast

SETTINGS = ["n=291", "0.5deg", "0.5mm"]  # of tables and voxels, where there are several
HEIGHT = 0.38  # of a bar


def main(options) -> common.Figure:
    table = fast.load(options.results)
    rows = shown(fast.plain_rows(table))
    order = rows.groupby("line").times_embree.max().sort_values().index
    figure, axes = plt.subplots(figsize=(8.2, 0.34 * len(order) + 1.2))
    for k, (direction, title) in enumerate(fast.DIRECTIONS.items()):
        own = rows[rows.direction == direction].set_index("line").reindex(order)
        draw(axes, own, np.arange(len(order)) + (0.5 - k) * HEIGHT, {"color": common.COLOURS[k], "label": title})
    axes.axvline(1.0, color="black", linewidth=1.0)
    axes.set_yticks(range(len(order)), order)
    ends = (rows.times_embree.min() / 4, rows.times_embree.max() * 3)  # room for numbers
    axes.set(xscale="log", xlim=ends, ylim=(-0.6, len(order) - 0.4))
    axes.set_xlabel("times as fast as the fastest of Embree's rays")
    what = f"{fast.TRIANGLES:,} triangles a model, one thread, {fast.set_name(table)}"
    axes.set_title(f"{what}; cube of 291 cells, grids of 0.5°, voxels of 0.5 mm")
    axes.grid(axis="y", visible=False)
    axes.legend(loc="lower right")
    figure.tight_layout()
    return figure


def shown(rows: pd.DataFrame) -> pd.DataFrame:
    """Of each method and storage one setting; exact cells the faster of their two; of double what is scalar."""
    rows = rows[rows.setting.isin(SETTINGS) | ~rows.setting.str.contains("n=|deg|mm")]
    rows = rows[(rows.storage != "double") | rows.method.str.endswith("_scalar")]
    return rows.loc[rows.groupby(["line", "direction"]).times_embree.idxmax()]


def draw(axes: plt.Axes, rows: pd.DataFrame, places: np.ndarray, look: dict) -> None:
    """A bar a method from 1, with half the interquartile range of its time on either side, and its length in words."""
    ratio = rows.times_embree.to_numpy()
    spread = 0.5 * (rows.iqr_ns / rows.ns_vertex).to_numpy()
    ends = np.vstack([ratio - ratio / (1 + spread), ratio / np.maximum(1 - spread, 0.05) - ratio])
    axes.barh(
        places, ratio - 1.0, height=HEIGHT, left=1.0, xerr=ends, error_kw={"elinewidth": 1.0, "capsize": 2}, **look
    )
    for place, value, low, high in zip(places, ratio, *ends):
        end, side = (value + high, "left") if value >= 1 else (value - low, "right")
        common.note(
            axes,
            common.digits(value, 2),
            (end, place),
            (4 if side == "left" else -4, 0),
            ha=side,
            va="center",
            fontsize=7,
        )


common.run(main)
