# SPDX-License-Identifier: GPL-3.0-or-later
"""What the table and the paper share of experiment 13_counts: instructions beside the times of all gaps."""

from pathlib import Path

import pandas as pd

import common
from common import fast

KEYS = ["method", "setting", "storage", "direction", "instruction_set"]


def load(results: Path) -> pd.DataFrame:
    """data/counts.csv with the label of each method as `name`, and of the rows of all_gaps that were timed with the same instructions their `ns_vertex`; the ratios of
    both to the memory-bound baseline with the same instructions. What has no instruction set of its own may have run on others when
    it was timed: no time stands beside it."""
    table = common.load(results, "counts")
    table["name"] = table.method.map(table.attrs["labels"])
    timed = fast.load(results)
    timed = timed[(timed.triangles == fast.TRIANGLES) & (timed.threads == 1) & (timed.instruction_set != "none")]
    table = table.merge(timed[[*KEYS, "ns_vertex"]], on=KEYS, how="left")
    floor = table[table.method == "floor"].set_index(["direction", "instruction_set"])
    floor = table[["direction", "instruction_set"]].merge(
        floor[["instructions", "ns_vertex"]], left_on=["direction", "instruction_set"], right_index=True, how="left"
    )
    table["over_floor"] = table.instructions / floor.instructions
    table["time_over_floor"] = table.ns_vertex / floor.ns_vertex
    return table


def first_set(table: pd.DataFrame) -> pd.DataFrame:
    """The best instruction set that was counted, listed first, and what has none."""
    best = table[table.instruction_set != "none"].instruction_set.iloc[0]
    return table[table.instruction_set.isin(["none", best])]
