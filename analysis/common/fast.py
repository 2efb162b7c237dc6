# SPDX-License-Identifier: GPL-3.0-or-later
"""What the table, the targets and the figure of experiment 13 share."""

from pathlib import Path

import pandas as pd

import common
from common import measured

TRIANGLES = 12000  # of each model of the joint that is shown
DIRECTIONS = {"socket->ball": "socket to ball", "ball->socket": "ball to socket, rim masked"}
RAYS = ["cgal_first_hit", "vtk_first_hit"]  # of others than Embree
CLOSEST = ["cgal_closest", "vtk_closest", "embree_closest"]
PEERS = [
    *RAYS,
    *CLOSEST,
    "vdb_grid",
]  # exact, and asked point by point, but for the voxels; not in every figure


def load(results: Path, state: str = "warm") -> pd.DataFrame:
    """The warm or the cold rows of data/fast.csv with a readable `line` for each method and storage."""
    table = common.load(results, "fast")
    table = table[table.state == state].copy()
    table["line"] = measured.lines(table, table.attrs["labels"], stored=~table.method.isin(["floor", "vdb_grid"]))
    return table


def best_set(table: pd.DataFrame) -> str:
    """The instruction set that the machine prefers: kernels are listed with it first."""
    return table[table.instruction_set != "none"].instruction_set.iloc[0]


def set_name(table: pd.DataFrame) -> str:
    """The same as a reader knows it: Highway calls all of AVX-512 by names that begin with AVX3."""
    best = best_set(table)
    return "AVX-512" if best.startswith("AVX3") else best


def plain_rows(table: pd.DataFrame) -> pd.DataFrame:
    """The joint that is shown, one thread, the best instruction set."""
    sets = table.instruction_set.isin(["none", best_set(table)])
    return table[(table.triangles == TRIANGLES) & (table.threads == 1) & sets]
