# SPDX-License-Identifier: GPL-3.0-or-later
# @depends   analysis/common/{thesis_values,counterparts}.csv
"""What the thesis prints, and which method of ours stands for which column of its tables."""

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
    """The method of ours that stands for each column of a timing table of the thesis."""
    table = _counterparts(artefact)
    return {column: method for column, method in zip(table.thesis_column, table.method) if column}


def methods_of(artefact: str) -> list[str]:
    """The methods of ours that a timing table of the thesis shows: the counterparts of its columns, and those
    that stand beside them.
    """
    return list(_counterparts(artefact).method)
