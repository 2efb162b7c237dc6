# SPDX-License-Identifier: GPL-3.0-or-later
# @name      motion-volume-times
# @question  Which share of all rotations is free of contact, how soon is it proven, and how long does a grid of poses take?
# @data      motion_volume motion_volume_methods
"""The share of all rotations that is free, between proven ends, by their distance; the time for this, for a grid of poses as
fine as the finest cells (extrapolated), and for random poses that give the share as surely.
"""

import pandas as pd

import common
from common import motion_limits, volume

EXTRAPOLATED = ", extrapolated, s"  # ends the columns of other ways


def main(options) -> common.Table:
    beside = volume.beside(options.results)
    rows = []
    for row in volume.load(options.results).itertuples():
        own = beside[(beside.joint == row.joint) & (beside.width == row.width)]
        rows.append(
            {
                "joint": motion_limits.label(row.joint),
                "width": row.width,
                "free_share_low": row.low,
                "free_share_high": row.high,
                "reachable_share_low": row.reachable_low,
                "reachable_share_high": row.reachable_high,
                "cells": row.cells,
                "time_s": row.time_s,
                "reach_deg": row.covering_deg,
                "grid_poses": row.grid_poses,
            }
            | {f"{line}{EXTRAPOLATED}": s for line, s in zip(own.line, own.needed_s)}
        )
    table = pd.DataFrame(rows)
    return table, latex(table)


def between(low: float, high: float) -> str:
    """An interval rounded outward."""
    return f"{common.rounded_down(low, 3)} to {common.rounded_up(high, 3)}"


def latex(table: pd.DataFrame) -> str:
    """A line per joint and width."""
    others = [name for name in table if name.endswith(EXTRAPOLATED)]
    head = ["joint", "width", "free share", "reachable share", "cells", "time, s", "grid poses"]
    words = [*head, *(name.removesuffix(EXTRAPOLATED) + "*" for name in others)]
    lines = []
    for row in table.to_dict("records"):
        shares = [between(row[f"{name}_low"], row[f"{name}_high"]) for name in ("free_share", "reachable_share")]
        times = ["" if pd.isna(row[name]) else volume.duration(row[name]) for name in others]
        cells = [row["joint"], f"{row['width']:g}", *shares, f"{row['cells']:,}", common.digits(row["time_s"], 2),
                 common.digits(row["grid_poses"], 2), *times]
        lines.append([common.tex(cell) for cell in cells])
    return common.tabular("l" + "r" * (len(words) - 1), [[common.tex(word) for word in words]], lines)


common.run(main)
