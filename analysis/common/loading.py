# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads results: a CSV with its sidecar, or a refusal."""

from pathlib import Path

import pandas as pd

from common.sidecars import sidecar

LABELS_READ: dict[str, str] = {}  # of methods, from the sidecars read so far; the first one says


def as_text(csv: Path) -> pd.DataFrame:
    """A CSV of ours as text, digit for digit."""
    return pd.read_csv(csv, dtype=str, keep_default_na=False)


def load(results: Path, name: str) -> pd.DataFrame:
    """data/NAME.csv, with its sidecar in attrs; yes and no become booleans."""
    csv = results / "data" / f"{name}.csv"
    record = sidecar(csv)
    table = pd.read_csv(csv, float_precision="round_trip")
    for column in table.columns:
        if table[column].isin(["yes", "no"]).all() and len(table):
            table[column] = table[column] == "yes"
    table.attrs.update(record)
    for name, text in record.get("labels", {}).items():
        LABELS_READ.setdefault(name, text)
    return table
