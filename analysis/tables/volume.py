# SPDX-License-Identifier: GPL-3.0-or-later
# @name      motion-volume-times
# @question  Which share of all rotations is free of contact, how soon is it proven, and how long does a grid of poses take?
# @data      motion_volume motion_volume_methods
"""The share of all rotations that is free, between proven ends, by how near these are to be; the time that takes, and the
time of a grid of poses with the reach of the finest cells (extrapolated) and of random poses as sure as that.
"""

import pandas as pd

import common
from common import motion_limits, volume


def main(options) -> common.Table:
    beside = volume.beside(options.results)
    rows = []
    for row in volume.load(options.results).itertuples():
        own = beside[(beside.joint == row.joint) & (beside.width == row.width)]
        rows.append(
            {
                "joint": motion_limits.label(row.joint),
                "width": f"{row.width:g}",
                "free_share": between(row.low, row.high),
                "reachable_share": between(row.reachable_low, row.reachable_high),
                "cells": f"{row.cells:,}",
                "time_s": common.digits(row.time_s, 2),
                "reach_deg": common.digits_up(row.covering_deg, 2),
                "grid_poses": common.digits(row.grid_poses, 2),
            }
            | {f"{line}, extrapolated": volume.duration(s) for line, s in zip(own.line, own.needed_s)}
        )
    table = pd.DataFrame(rows).fillna("")
    return table, latex(table)


def between(low: float, high: float) -> str:
    """Rounded outward."""
    return f"{common.rounded_down(low, 3)} to {common.rounded_up(high, 3)}"


def latex(table: pd.DataFrame) -> str:
    """A line a joint and width."""
    shown = table.drop(columns=["reach_deg"])
    words = [name.replace("_s", ", s").replace("_", " ").replace(", extrapolated", "*") for name in shown]
    head = [" & ".join(common.tex(word) for word in words) + r" \\"]
    lines = [[common.tex(str(cell)) for cell in row] for row in shown.itertuples(index=False)]
    return common.tabular("l" + "r" * (len(words) - 1), head, lines)


common.run(main)
