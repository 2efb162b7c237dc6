# SPDX-License-Identifier: GPL-3.0-or-later
# @data      lut_memory
"""Verdicts on entries, turns and memory (Tables 2, 6 and 7): what our tables really take."""

from pathlib import Path

import common
from common import memory
from verdicts.verdict import printed_row, rounds_to, value_row

COLUMNS = {
    "lut_entries": ("entries", 1),
    "memory": ("bytes", memory.MIB),
    "helix_turns": ("helix_turns", 1),
}  # of lut_memory.csv, and what to divide by


def rows(results: Path) -> list[dict]:
    """One for each value."""
    lines = []
    for artefact in memory.SCHEMES:
        table = memory.ours(results, artefact)
        values = common.thesis(artefact)
        for value in values.itertuples():
            line = table.loc[common.number(value.row)]
            if value.column == "equator_points":
                lines.append(equator_row(value, line))
                continue
            name, divisor = COLUMNS[value.column]
            extra = contradiction(value, values)
            if value.column == "memory":
                mask = f"{line.filled_bytes / memory.MIB:.4g} MiB with the rim mask of a filled table"
                extra["note"] = "; ".join(filter(None, [extra.get("note"), mask]))
            lines.append(printed_row(value, line[name] / divisor, **extra))
    return lines


def equator_row(value, line) -> dict:
    """Entries that were counted on the turns of the helix that cross the equator: they are not whole turns, so that there
    is one more or less by where a turn begins.
    """
    least, most = int(line.equator_least), int(line.equator_most)
    return value_row(
        value,
        measured=f"{least}" if least == most else f"{least} to {most}",
        rule="one of the numbers that are counted on turns across the equator",
        tolerance="none",
        verdict="reproduced" if least <= int(value.value) <= most else "differs",
        note=f"{line.equator_points:g} by the helix' own formula, which counts nothing",
    )


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
