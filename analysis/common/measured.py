# SPDX-License-Identifier: GPL-3.0-or-later
"""What the loaders of single experiments share: two CSVs as one table, and a readable line for each method and storage."""

from pathlib import Path

import pandas as pd

import common

STORED = {"uint16": "16 bits", "float": "float", "double": "double"}


def joined(results: Path, name: str, detail: str, keys: list[str]) -> pd.DataFrame:
    """data/NAME.csv joined with data/DETAIL.csv, which has the same keys. The first one's sidecar is in attrs."""
    main = common.load(results, name)
    table = main.merge(common.load(results, detail), on=keys, validate="one_to_one")
    if len(table) != len(main):
        raise common.Refused(f"{name}.csv and {detail}.csv are of different runs: remove both and run again")
    table.attrs.update(main.attrs)
    return table


def lines(table: pd.DataFrame, names: dict[str, str], stored: pd.Series | bool = True) -> pd.Series:
    """The name of each row for a reader: its method (from `names`, or else its own name) and how its table is stored, where
    `stored` says that it has one.
    """
    storage = table.storage.map(STORED).radd(", ").fillna("")
    if stored is not True:
        storage = storage.where(stored, "")
    return table.method.map(names).fillna(table.method) + storage
