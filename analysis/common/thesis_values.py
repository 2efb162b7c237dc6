# SPDX-License-Identifier: GPL-3.0-or-later
# @depends   analysis/common/{thesis_values,counterparts}.csv
"""What the thesis prints, and which method of ours stands for which column of its tables."""

import itertools
from pathlib import Path

import pandas as pd

HERE = Path(__file__).resolve().parent


def thesis(artefact: str | None = None) -> pd.DataFrame:
    """The values that the thesis prints, as text: digits count. Columns artefact,row,column,value ..."""
    values = pd.read_csv(HERE / "thesis_values.csv", dtype=str, keep_default_na=False)
    return values if artefact is None else values[values.artefact == artefact]


def _counterparts(artefact: str) -> pd.DataFrame:
    table = pd.read_csv(HERE / "counterparts.csv", keep_default_na=False)
    return table[table.artefact == artefact]


def counterparts(artefact: str) -> dict[str, str]:
    """The method of ours that stands for each column of a timing table of the thesis: of several, the first."""
    table = _counterparts(artefact)
    return dict(reversed([(column, method) for column, method in zip(table.thesis_column, table.method) if column]))


def readings(artefact: str) -> dict[str, dict[str, str]]:
    """Every way to read such a table, by its name: the method that then stands for each column. The first is counterparts().
    Readings of the same columns exclude each other.
    """
    table = _counterparts(artefact)
    table = table[table.thesis_column != ""]
    fixed = dict(zip(*(table[table.reading == ""][name] for name in ("thesis_column", "method"))))
    groups: dict[tuple, list[tuple[str, dict[str, str]]]] = {}
    for name, rows in table[table.reading != ""].groupby("reading", sort=False):
        methods = dict(zip(rows.thesis_column, rows.method))
        groups.setdefault(tuple(methods), []).append((str(name), methods))
    found = {}
    for choice in itertools.product(*groups.values()):
        name = ", ".join(name for name, _ in choice)
        found[name] = fixed | {column: method for _, methods in choice for column, method in methods.items()}
    return found


def methods_of(artefact: str) -> list[str]:
    """The methods of ours that a timing table of the thesis shows: those that may stand for its columns, and those beside them."""
    return list(_counterparts(artefact).method)
