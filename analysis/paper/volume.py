# SPDX-License-Identifier: GPL-3.0-or-later
# @data      motion_volume motion_volume_methods resection_by_cam
"""Numbers of the paper about all rotations at once and the least cut.

volume:JOINT:low and :high, per cent of all rotations, rounded outwards, :cells and :time (s), at the finest width that most joints have;
volume:grid, how long FCL would take for a grid with the reach of those cells (extrapolated); volume:asked random poses and
:against, how many of them contradict their cell; resection:CAM:low and :high (mm3, rounded outwards), :before and :after
(degrees, down).
"""

from pathlib import Path

import common
from common import volume


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    return shares(results) | resections(results)


def shares(results: Path) -> dict[str, str]:
    """Of every joint."""
    table = volume.load(results)
    shared = table.groupby("width").joint.nunique().loc[lambda joints: joints == joints.max()].index.min()
    best = table[table.width == shared].set_index("joint")  # at the finest width that most joints have
    found = {}
    for joint, row in best.iterrows():
        found |= {
            f"volume:{joint}:low": common.rounded_down(100 * row.low, 1),
            f"volume:{joint}:high": common.rounded_up(100 * row.high, 1),
            f"volume:{joint}:cells": f"{row.cells:,.0f}",
            f"volume:{joint}:time": common.digits(row.time_s, 2),
        }
    beside = volume.beside(results)
    grid = beside[beside.method == "fcl_collide"].sort_values("width").iloc[0]
    methods = common.load(results, "motion_volume_methods")
    return found | {
        "volume:grid": volume.duration(grid.needed_s),
        "volume:asked": f"{methods.poses.sum():,}",
        "volume:against": str(int(methods.touching_in_free.sum() + methods.clear_in_blocked.sum())),
    }


def resections(results: Path) -> dict[str, str]:
    """Of every height of the cam that was not refused."""
    found = {}
    table = common.load(results, "resection_by_cam")
    for row in table[table.refused.isna()].itertuples():
        found |= {
            f"resection:{row.cam_height_mm:g}:low": common.rounded_down(row.volume_low_mm3, 1),
            f"resection:{row.cam_height_mm:g}:high": common.rounded_up(row.volume_high_mm3, 1),
            f"resection:{row.cam_height_mm:g}:before": common.rounded_down(row.before_deg, 1),
            f"resection:{row.cam_height_mm:g}:after": common.rounded_down(row.after_deg, 1),
        }
    return found
