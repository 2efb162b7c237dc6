# SPDX-License-Identifier: GPL-3.0-or-later
"""What the main figure and the paper share of touch and smallest gaps, in experiment 10_error_against_time."""

from pathlib import Path

import pandas as pd

import common


def load(results: Path, scenes: str = "generated_") -> pd.DataFrame:
    """The rows of data/contact.csv of the scenes that begin so, with a readable `line` for each method."""
    table = common.load(results, "contact")
    table = table[table.scene.str.startswith(scenes)].copy()
    table["line"] = table.method.map(table.attrs["labels"])
    return table
