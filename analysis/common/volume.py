# SPDX-License-Identifier: GPL-3.0-or-later
"""What the table, the figure and the findings share about the motion volume: its times, compared with asking pose after pose. A
grid of poses is as fine as the volume's finest cells; its time is extrapolated.
"""

from pathlib import Path

import pandas as pd

import common

OURS = "culled"  # random rotations asked of it find a share without a proof
SLOPE = 6.5  # degrees of internal rotation for 10 of flexion past 70 (PMC7754612)
CAM_LOSS = 15  # degrees of it that hips with a cam have less (PubMed 22472271: groups with 27.9 and 12.3)
SURE = 1.96  # standard deviations on either side hold 95 % of all draws


def load(results: Path) -> pd.DataFrame:
    """data/motion_volume.csv; `proven` is the distance of the ends."""
    table = common.load(results, "motion_volume")
    table["proven"] = table.high - table.low
    return table


def beside(results: Path) -> pd.DataFrame:
    """The rows of load() for each way to ask pose after pose on that joint, with `line`, `poses_needed`, `needed_s`, and
    `times`, the ratio to the time of the volume.
    """
    methods = common.load(results, "motion_volume_methods")
    table = load(results).merge(methods, on="joint")
    drawn = table.method == OURS
    spread = table.clear_share * (1 - table.clear_share)
    table["poses_needed"] = table.grid_poses.where(~drawn, (2 * SURE / table.proven) ** 2 * spread)
    table["needed_s"] = 1e-6 * table.us_pose * table.poses_needed
    table["times"] = table.needed_s / table.time_s
    table["line"] = table.label.str.replace(", touch", "").where(~drawn, "random poses, 95 %, no proof")
    return table


def duration(seconds: float) -> str:
    """A duration for a reader."""
    for unit, length in (("d", 86400), ("h", 3600), ("min", 60)):
        if seconds >= 2 * length:
            return f"{common.digits(seconds / length, 2)} {unit}"
    return f"{common.digits(seconds, 2)} s"
