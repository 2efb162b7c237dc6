# SPDX-License-Identifier: GPL-3.0-or-later
"""Verdicts on times (Tables 3, 4, 8 and 9). A time on another machine says nothing by itself; what can be
compared is which method is faster and by how much, and those have rows of their own.
"""

from __future__ import annotations

import math
from pathlib import Path

import pandas as pd

import common
import timing
from verdict import row

RATIO_FACTOR = math.sqrt(
    10
)  # half an order of magnitude: other machine, compiler, implementation of the rival
RATIO_RULE = "ratio within half an order of magnitude of the thesis' ratio"


def rows(results: Path) -> list[dict]:
    """Those of every timing table."""
    return [line for table in timing.TABLES for line in timing_rows(results, table)]


def doubts(*lines: pd.Series) -> list[str]:
    """What a reader must know of times of ours that a row rests on."""
    notes = []
    if any(line.extrapolated for line in lines):
        notes.append("ours is extrapolated from a smaller run")
    if any(line.inconclusive for line in lines):
        notes.append("our timing is inconclusive: the machine was busy")
    return notes


def time_row(table: timing.TimingTable, value, line: pd.Series | None) -> dict:
    """A time: given for the reader, not judged."""
    notes = []
    if value.value == "N/A":
        notes.append("the thesis gives no time")
    if line is None:
        notes.append("not measured in this run")
    else:
        notes += doubts(line)
    if line is not None and line.method != value.column:
        notes.append(f"measured with {common.label(line.method)}")
    return row(
        table.artefact,
        value.row,
        value.column,
        thesis=value.value,
        measured="" if line is None else common.plain(line.measured_ms),
        unit=value.unit,
        rule="times of different machines are not compared; see the ratios and the order",
        verdict="not-comparable",
        note="; ".join(notes),
    )


def ratio_row(table: timing.TimingTable, name: str, line: pd.Series, reference: pd.Series) -> dict:
    """How many times the thesis' own method is faster than another, there and here."""
    off = max(line.thesis_ratio, line.measured_ratio) / min(line.thesis_ratio, line.measured_ratio)
    return row(
        table.artefact,
        name,
        f"{line.thesis_column}/{timing.REFERENCE}",
        thesis=common.plain(line.thesis_ratio),
        measured=common.plain(line.measured_ratio),
        unit="ratio",
        rule=RATIO_RULE,
        tolerance=f"factor {RATIO_FACTOR:.3g}",
        verdict="reproduced" if off <= RATIO_FACTOR else "differs",
        note="; ".join([f"off by a factor of {off:.3g}", *doubts(line, reference)]),
    )


def order_row(table: timing.TimingTable, name: str, lines: pd.DataFrame) -> dict:
    """Which method is faster: fastest first, under the thesis' names."""
    theirs = " < ".join(lines.sort_values("thesis_ms").thesis_column)
    ours = " < ".join(lines.sort_values("measured_ms").thesis_column)
    note = "; ".join(doubts(*(line for _, line in lines.iterrows())))
    return row(
        table.artefact,
        name,
        "order",
        thesis=theirs,
        measured=ours,
        unit="order",
        rule="same methods, fastest first, in the same order",
        tolerance="none",
        verdict="reproduced" if theirs == ours else "differs",
        note=note,
    )


def timing_rows(results: Path, table: timing.TimingTable) -> list[dict]:
    """Every time of the table, then for each of its rows the ratios and the order."""
    lines = timing.compare(results, table)
    lines = lines[lines.thesis_column != ""]
    values = common.thesis(table.artefact)
    rows = []
    for value in values.itertuples():
        match = lines[(lines[table.key] == common.number(value.row)) & (lines.thesis_column == value.column)]
        rows.append(time_row(table, value, match.iloc[0] if len(match) else None))
    for name in values.row.unique():
        known = lines[(lines[table.key] == common.number(name)) & lines.thesis_ms.notna()]
        reference = known[known.thesis_column == timing.REFERENCE]
        if reference.empty or len(known) < 2:
            continue
        rows += [
            ratio_row(table, name, line, reference.iloc[0])
            for _, line in known.iterrows()
            if line.thesis_column != timing.REFERENCE
        ]
        rows.append(order_row(table, name, known))
    return rows
