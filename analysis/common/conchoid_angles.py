# SPDX-License-Identifier: GPL-3.0-or-later
"""The finest fan of rays of data/conchoid_angles.csv and how its three adjustments are drawn."""

from pathlib import Path

import pandas as pd

import common

ADJUSTED = {
    "thesis_deg": "Eq. 16 with 3.03 and 4.29",
    "closed_form_deg": "Eq. 16 unrounded",
    "exact_deg": "exact length",
}
LOOKS = dict(zip(ADJUSTED, list(common.look(["original", *ADJUSTED]).values())[1:]))


def finest(results: Path) -> pd.DataFrame:
    """The rows of most rays."""
    angles = common.load(results, "conchoid_angles")
    return angles[angles.rays == angles.rays.max()].set_index("i")


def line(column: str) -> dict:
    """Colour and dash."""
    return {key: LOOKS[column][key] for key in ("color", "linestyle")}
