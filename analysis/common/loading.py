# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading results: a CSV with its sidecar, or a refusal."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pandas as pd


class Refused(Exception):
    """A result that cannot be trusted, or is not there; the message says which file and what to do."""


def sidecar(csv: Path) -> dict:
    """The record beside a CSV; refused unless it carries the SHA-256 of these bytes."""
    path = csv.with_suffix(".json")
    remedy = f"remove {csv.name} and run experiments/reproduce again"
    if not csv.is_file():
        raise Refused(f"{csv} is not there: run experiments/reproduce")
    if not path.is_file():
        raise Refused(f"{csv} has no sidecar {path.name}: {remedy}")
    try:
        record = json.loads(path.read_text())
        expected = record["csv_sha256"]
    except (ValueError, KeyError, TypeError):
        raise Refused(f"{path} is no sidecar with a csv_sha256: {remedy}") from None
    if hashlib.sha256(csv.read_bytes()).hexdigest() != expected:
        raise Refused(f"{csv} does not have the bytes that {path.name} vouches for: {remedy}")
    return record


def load(results: Path, name: str) -> pd.DataFrame:
    """data/NAME.csv with its sidecar in attrs; yes and no become booleans."""
    csv = results / "data" / f"{name}.csv"
    record = sidecar(csv)
    table = pd.read_csv(csv, float_precision="round_trip")
    for column in table.columns:
        if table[column].isin(["yes", "no"]).all() and len(table):
            table[column] = table[column] == "yes"
    table.attrs.update(record)
    return table
