# SPDX-License-Identifier: GPL-3.0-or-later
# @depends   analysis/common/{thesis_values,counterparts}.csv
"""What the thesis prints, and which method of ours represents which column of its tables."""

import itertools
from decimal import Decimal, InvalidOperation
from pathlib import Path

import pandas as pd

HERE = Path(__file__).resolve().parent


def thesis(artefact: str | None = None) -> pd.DataFrame:
    """The values that the thesis prints, as text, since digits count. Columns artefact,row,column,value ..."""
    values = pd.read_csv(HERE / "thesis_values.csv", dtype=str, keep_default_na=False)
    return values if artefact is None else values[values.artefact == artefact]


def same_number(one: str, other: str) -> bool:
    """Are two printed texts the same, or the same number, one printed with fewer digits?"""
    try:
        numbers = [Decimal(text) for text in (one, other)]
    except InvalidOperation:
        return one == other
    last = max(number.as_tuple().exponent for number in numbers)
    return abs(numbers[0] - numbers[1]) <= Decimal(5).scaleb(last - 1)


def _counterparts(artefact: str) -> pd.DataFrame:
    table = pd.read_csv(HERE / "counterparts.csv", keep_default_na=False)
    return table[table.artefact == artefact]


def counterparts(artefact: str) -> dict[str, str]:
    """The method of ours for each column of a timing table of the thesis; the first one if there are several."""
    table = _counterparts(artefact)
    return dict(reversed([(column, method) for column, method in zip(table.thesis_column, table.method) if column]))


def readings(artefact: str) -> list[dict[str, str]]:
    """Every way to read such a table: which method represents each column. The first is counterparts(). Readings of the same
    columns exclude each other.
    """
    table = _counterparts(artefact)
    table = table[table.thesis_column != ""]
    groups: dict[tuple, list[dict[str, str]]] = {}
    for _, rows in table.groupby("reading", sort=False):
        methods = dict(zip(rows.thesis_column, rows.method))
        groups.setdefault(tuple(methods), []).append(methods)
    return [{column: method for methods in choice for column, method in methods.items()} for choice in itertools.product(*groups.values())]


def reading_names(artefact: str) -> dict[tuple[str, str], str]:
    """The meaning of each choice of a method for a column that another method could also represent."""
    table = _counterparts(artefact)
    return {(row.thesis_column, row.method): row.reading for row in table[::-1].itertuples() if row.reading}


def methods_of(artefact: str) -> list[str]:
    """Our methods that a timing table of the thesis shows: those that may represent its columns, and additional ones."""
    return list(_counterparts(artefact).method.unique())
