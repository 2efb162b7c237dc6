# SPDX-License-Identifier: GPL-3.0-or-later
"""Verdicts on entries and memory (Table 2): what our tables really take."""

from __future__ import annotations

from pathlib import Path

import common
from verdict import printed_row

COLUMNS = {
    "lut_entries": ("entries", 1),
    "memory": ("bytes", 2**20),
    "helix_turns": ("helix_turns", 1),
    "equator_points": ("equator_points", 1),
}  # of lut_memory.csv, and what to divide by
SCHEMES = {"table-2": "rsid"}  # the scheme that each table of the thesis is about


def rows(results: Path) -> list[dict]:
    """One for each value."""
    ours = common.load(results, "lut_memory")
    lines = []
    for artefact, scheme in SCHEMES.items():
        table = ours[ours.scheme == scheme].set_index("precision_deg")
        for value in common.thesis(artefact).itertuples():
            name, divisor = COLUMNS[value.column]
            lines.append(printed_row(value, table[name][common.number(value.row)] / divisor))
    return lines
