# SPDX-License-Identifier: GPL-3.0-or-later
"""Error against cost: the settings that no other setting beats in both.

Everything is read from data/error_against_time.csv and error_against_time_spread.csv; no method, scheme or
scene is named here.
"""

from pathlib import Path

import numpy as np
import pandas as pd

import common
from common import measured

KEYS = ["scene", "method", "setting"]
# What a reader is shown first; all scenes are in the tables.
MAIN_SCENE = "generated_12000"
# The three costs: column, title, unit.
COSTS = {
    "query_ns": "one query, ns",
    "build_ms": "filling or building, ms",
    "bytes": "memory, bytes",
}


def load(results: Path) -> pd.DataFrame:
    """Both CSVs as one table, with the largest measured error, error_um, of either sign."""
    table = measured.joined(results, "error_against_time", "error_against_time_spread", KEYS)
    table["setting"] = table.setting.fillna("").astype(str)
    table["error_um"] = table[["max_over_um", "max_under_um"]].abs().max(axis=1)
    table["line"] = [line_of(row) for row in table.itertuples()]
    return table


def main_scene(scenes) -> str:
    """The scene to show where there is room for one; the first scene if the main one is missing."""
    return MAIN_SCENE if MAIN_SCENE in set(scenes) else next(iter(scenes))


def line_of(row) -> str:
    """What the settings of one line of a plot have in common: the method, and how its table is stored or its library is set.
    """
    if row.storage not in ("none", "double"):
        return f"{row.method}, {row.storage}"
    return f"{row.method}, {row.setting}" if row.kind == "library" and row.setting else row.method


def label(line: str) -> str:
    """The name of a line for a reader."""
    method, *storage = line.split(", ")
    return ", ".join([common.label(method), *storage])


def step_of(row) -> str:
    """What distinguishes a setting of a line from the next."""
    return f"{row.precision_deg:g}°" if np.isfinite(row.precision_deg) else row.setting


def competes(table: pd.DataFrame) -> pd.Series:
    """May a row be on a front? It may if it answers the common question, the radius along a direction."""
    return (table.measure == "radial") & np.isfinite(table.error_um)


def front(error: np.ndarray, cost: np.ndarray) -> np.ndarray:
    """The points that are not dominated: no other point is at least as good in both and better in one. Equal points are kept
    or dropped together.
    """
    least = pd.Series(error).groupby(cost).min()  # in the order of the cost
    better = least[least < least.cummin().shift(fill_value=np.inf)]
    return better.reindex(cost).to_numpy() == error
