# SPDX-License-Identifier: GPL-3.0-or-later
"""Verdicts on entries, turns and memory (Tables 2, 6 and 7): what our tables really take."""

from __future__ import annotations

from pathlib import Path

import common
import memory
from verdict import printed_row, rounds_to

COLUMNS = {
    "lut_entries": ("entries", 1),
    "memory": ("bytes", memory.MIB),
    "helix_turns": ("helix_turns", 1),
    "equator_points": ("equator_points", 1),
}  # of lut_memory.csv, and what to divide by


def rows(results: Path) -> list[dict]:
    """One for each value."""
    lines = []
    for artefact in memory.SCHEMES:
        table = memory.ours(results, artefact)
        values = common.thesis(artefact)
        for value in values.itertuples():
            name, divisor = COLUMNS[value.column]
            measured = table[name][common.number(value.row)] / divisor
            lines.append(printed_row(value, measured, **contradiction(value, values)))
    return lines


def contradiction(value, values) -> dict[str, str]:
    """Does the memory that is printed round from the entries that the same row prints? If not, the number is a
    slip of the thesis.
    """
    entries = values[(values.row == value.row) & (values.column == "lut_entries")]
    if value.column != "memory" or entries.empty:
        return {}
    own = float(entries.value.iloc[0]) * 8 / memory.MIB
    if rounds_to(own, value.value):
        return {}
    note = f"its own {int(entries.value.iloc[0]):,} entries of 8 bytes are {own:.4f} MiB"
    digits = len(value.value.partition(".")[2])
    if f"{int(own * 10**digits) / 10**digits:.{digits}f}" == value.value:
        note += ": digits were cut off, not rounded"
    return {"note": note, "otherwise": "thesis-misprint"}
