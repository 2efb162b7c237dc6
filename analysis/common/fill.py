# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tables and the figures share of filling, in experiment 10_error_against_time."""

from pathlib import Path

import numpy as np
import pandas as pd

import common
from common import measured

TRIANGLES = 12000  # of each model of the joint that is shown
WAY = ["method", "storage", "memory", "threads"]
SCENE = ["triangles", "cells", "memory"]


def load(results: Path) -> pd.DataFrame:
    """data/fill.csv with a readable `line` for each way and `times_embree`, Embree's time in the same memory over it."""
    table = common.load(results, "fill")
    rays = table[table.method == "embree_fill"].set_index(SCENE).median_ms
    table["times_embree"] = rays.loc[pd.MultiIndex.from_frame(table[SCENE])].to_numpy() / table.median_ms
    own = table.method == "cube_at_once"
    table["line"] = measured.lines(table, table.attrs["labels"], stored=own)
    table.loc[own, "line"] += table.threads.map({1: ", 1 thread", 2: ", 2 threads"})
    return table


def growth(table: pd.DataFrame) -> pd.DataFrame:
    """a + b triangles + c entries of every way (both models and tables), by least squares of the relative residuals:
    start_us, triangle_ns, entry_ns and the largest residual, as a share of the time.
    """
    fits = []
    for way, rows in table.groupby([*WAY, "line"], sort=False):
        terms = np.column_stack([np.ones(len(rows)), 2 * rows.triangles, rows.entries])
        scaled = terms / rows.median_ms.to_numpy()[:, None]
        found = np.linalg.lstsq(scaled, np.ones(len(rows)), rcond=None)[0]
        residual = np.abs(scaled @ found - 1).max()
        fits.append([*way, 1e3 * found[0], 1e6 * found[1], 1e6 * found[2], residual, len(rows)])
    return pd.DataFrame(
        fits, columns=[*WAY, "line", "start_us", "triangle_ns", "entry_ns", "largest_residual", "points"]
    )
