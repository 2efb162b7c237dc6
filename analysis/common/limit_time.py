# SPDX-License-Identifier: GPL-3.0-or-later
"""What the table and the figure on the time of limits share."""

from pathlib import Path

import pandas as pd

import common

OURS = ["turn_limit", "turn_limit_ranges"]
RIGHT = 0.02  # degrees: twice what steps are halved to; what errs by no more has missed nothing


def load(results: Path) -> pd.DataFrame:
    """A row per joint, method and step, with the time from meshes to limits."""
    table = common.load(results, "limit_time")
    table["line"] = table.method.map(common.label)
    table["total_ms"] = table.building_ms + table.cpu_ms
    return table


def title(rows: pd.DataFrame) -> str:
    """A joint with its number of faces."""
    joint, faces = rows.joint.iloc[0], int(rows.faces.iloc[0])
    whole = "" if joint.startswith(("implant", "needle", "normal hip")) else ", whole"
    return f"{joint}{whole}: {faces:,} faces"
