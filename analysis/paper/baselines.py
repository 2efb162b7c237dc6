# SPDX-License-Identifier: GPL-3.0-or-later
# @data      baselines slices_to_surface
"""Numbers of the paper about the comparison of Section 3.6 and slices of a scan.

baseline:METHOD:SIZE:COLUMN for the generated pair (shares in per cent, rms in micrometres); slices:SLICE:STAGE:rms
and :added in micrometres.
"""

from pathlib import Path

import pandas as pd

import common


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    return baselines(results) | slices(results)


def baselines(results: Path) -> dict[str, str]:
    """Every method at every size."""
    table = common.load(results, "baselines")
    table = table[table.joint == table.joint.iloc[0]]
    found = {}
    for row in table.itertuples():
        key = f"baseline:{row.method}:{row.size:g}"
        values = {
            "kB": row.bytes / 1e3,
            "triangles_missed": 100 * row.faces_missed / row.faces,
            "vertices_missed": 100 * row.points_missed / row.points,
            "rms_um": 1e3 * row.rms_error_mm,
            "false": 100 * row.false_touches / row.poses,
        }
        found |= {f"{key}:{name}": common.digits(value, 2) for name, value in values.items() if not pd.isna(value)}
    return found


def slices(results: Path) -> dict[str, str]:
    """Every stage at every distance of the slices."""
    table = common.load(results, "slices_to_surface")
    found = {}
    for row in table.itertuples():
        key = f"slices:{row.slice_mm:g}:{row.stage}"
        found |= {
            f"{key}:rms": common.digits(1e3 * row.rms_mm, 2),
            f"{key}:added": common.digits(1e3 * row.added_rms_mm, 2),
        }
    return found
