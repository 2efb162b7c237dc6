# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tables, the figures and the paper share about all gaps of a pose, touch and smallest gaps, from experiment
10_error_against_time.
"""

from pathlib import Path

import pandas as pd

import common
from common import measured

TRIANGLES = 12000  # of each model of the joint that is shown
HIPS = "hip_"  # scenes of presets begin so
KEYS = ["scene", "direction"]
DIRECTIONS = ["socket->ball", "ball->socket"]


def load(results: Path, state: str = "warm", scenes: str = "generated_") -> pd.DataFrame:
    """The warm or the cold rows of data/all_gaps.csv for scenes whose names begin with `scenes`. It adds a readable `line` for
    each method and storage; error_um, the largest error of either sign; and times_embree, the time of the fastest of Embree's
    rays divided by the method's (nan where Embree is not asked, since the first face along a ray is not the one that counts).
    """
    table = common.load(results, "all_gaps")
    table = table[(table.state == state) & table.scene.str.startswith(scenes)].copy()
    table["error_um"] = table[["max_over_um", "max_under_um"]].max(axis=1)
    rays = table[table.method.str.startswith("embree_ray")].groupby(KEYS).ns_vertex.min()
    table["times_embree"] = rays.reindex(pd.MultiIndex.from_frame(table[KEYS])).to_numpy() / table.ns_vertex
    table["line"] = measured.lines(table, table.attrs["labels"], stored=table.method != "floor")
    return table


def best_set(table: pd.DataFrame) -> str:
    """The instruction set that the machine prefers: kernels are listed with it first."""
    return table[table.instruction_set != "none"].instruction_set.iloc[0]


def set_name(table: pd.DataFrame) -> str:
    """The name of best_set() for a reader. Highway's names for AVX-512 begin with AVX3."""
    best = best_set(table)
    return "AVX-512" if best.startswith("AVX3") else best


def one_thread(table: pd.DataFrame) -> pd.DataFrame:
    """The rows with one thread and the best instruction set."""
    return table[(table.threads == 1) & table.instruction_set.isin(["none", best_set(table)])]


def plain_rows(table: pd.DataFrame) -> pd.DataFrame:
    """The rows of one_thread() for the joint that is shown."""
    return one_thread(table[table.triangles == TRIANGLES])


def contacts(results: Path, scenes: str = "generated_") -> pd.DataFrame:
    """The rows of data/contact.csv for scenes whose names begin with `scenes`, with a readable `line` for each method."""
    table = common.load(results, "contact")
    table = table[table.scene.str.startswith(scenes)].copy()
    table["line"] = table.method.map(table.attrs["labels"])
    return table
