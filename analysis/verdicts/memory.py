# SPDX-License-Identifier: GPL-3.0-or-later
# @data      lut_memory fill_memory
"""Verdicts on entries, turns and memory (Tables 2, 6 and 7, Figure 47, and the text about them), by what our tables really
take."""

import math
from pathlib import Path

import common
from common import memory
from common.ranges import Range
from verdicts.verdict import input_row, not_counted, printed_row, ranged, rounds_to, value_row

COLUMNS = {
    "lut_entries": ("entries", 1),
    "memory": ("bytes", memory.MIB),
    "helix_turns": ("helix_turns", 1),
    "grid_equator_points": ("equator_points", 1),
    "grid_memory": ("bytes", memory.MIB),
}  # of lut_memory.csv, and what to divide by
ARCS = "usid_arc"  # USID with its entries at equal arcs, as the text can be read; else at equal steps of Eq. 10
FINEST = "0.05deg"
GRID = "grid_"  # how columns on RSID begin in tables on USID


def rows(results: Path) -> list[dict]:
    """A row for each value in the tables, then for each in the text."""
    table = common.load(results, "lut_memory").set_index(["scheme", "precision_deg"])
    peaks = common.load(results, "fill_memory").set_index(["method", "precision_deg"]).peak_bytes
    lines = [line for artefact, scheme in memory.SCHEMES.items() for line in table_rows(table, peaks, artefact, scheme)]
    return lines + text_rows(table) + helix_rows()


def table_rows(table, peaks, artefact: str, scheme: str) -> list[dict]:
    """A row for each value in the tables; for USID, by both readings."""
    lines = []
    values = common.thesis(artefact)
    for value in values.itertuples():
        of = memory.SCHEMES["table-2"] if value.column.startswith(GRID) else scheme
        line = table.loc[of, common.number(value.row)]
        arcs = table.loc[ARCS, common.number(value.row)] if of == "usid" else line
        if value.column == "equator_points":
            lines.append(equator_row(value, line, arcs))
            continue
        name, divisor = COLUMNS[value.column]
        extra = contradiction(value, values)
        if value.column == "memory":
            peak = peaks[f"{of}_thesis", common.number(value.row)] / memory.MIB
            mask = f"{line.filled_bytes / memory.MIB:.4g} MiB with the rim mask of a filled table, {peak:.4g} at the peak of filling it as in the thesis"
            extra["note"] = "; ".join(filter(None, [extra.get("note"), mask]))
        found = printed_row(value, line[name] / divisor, also=[arcs[name] / divisor] if of == "usid" else [], **extra)
        lines.append(not_counted(found, f"the same number as table-2, {value.row}, memory") if value.column == "grid_memory" else found)
    return lines


def text_rows(table) -> list[dict]:
    """What Sections 3.4 and 3.5.1 say about these numbers, and Section 3.6.3 about the finest grid."""
    points = table.xs(memory.SCHEMES["table-2"])
    finest = points.loc[common.number(FINEST)]
    at = {(value.artefact, value.row, value.column): value for value in common.thesis().itertuples()}
    few, most = (at["section-3.5.1", "equator_points", end] for end in ("from", "to"))
    radius = float(at["section-3.5.2", "slices", "head_diameter"].value) / 2
    by_eq7 = [math.sqrt(2) * math.pi * radius / count for count in (finest.equator_points, int(most.value))]
    many = at["section-3.4", "sample_points", "more_than"]
    columns, lines = finest.equator_points, finest.entries // finest.equator_points
    return [
        input_row(at["section-3.4", "scan", "slices"]),
        value_row(
            many,
            measured=str(int(finest.entries)),
            rule="equal when rounded to millions, as printed",
            tolerance="half a million",
            verdict="reproduced" if round(finest.entries / 1e6) == int(many.value) / 1e6 else "differs",
            note=f"more than that are of both surfaces together, {2 * finest.entries:,.0f}; one has "
            f"{100 * (1 - finest.entries / int(many.value)):.2f} % fewer",
        ),
        printed_row(few, points.equator_points.min()),
        printed_row(
            most,
            points.equator_points.max(),
            f"the last row of Table 5, whose error is printed as {at['table-5', FINEST, 'max_error'].value} mm, has as many: by Eq. 7 "
            f"{by_eq7[0]:.4f} mm, and with {int(most.value):,} points {by_eq7[1]:.4f}",
            "thesis-misprint",
        ),
        printed_row(
            at["section-3.6.3", "finest_grid", "columns"],
            columns,
            f"{float(FINEST.removesuffix('deg')):g} degrees are 360 / {columns:.0f}; {table.loc['usid', common.number(FINEST)].equator_points:,.0f} "
            "would count 0 and 360 degrees both, and is the helix's number of points on the equator",
            "thesis-misprint",
        ),
        printed_row(at["section-3.6.3", "finest_grid", "rows"], lines),
    ]


def helix_rows() -> list[dict]:
    """Figure 47: w = k^2."""
    return [printed_row(value, int(value.row.removeprefix("k=")) ** 2) for value in common.thesis("figure-47").itertuples()]


def equator_row(value, line, arcs) -> dict:
    """The entries that were counted on the helix's turns across the equator. Entries do not divide a turn exactly, so a turn
    has one more or less, depending on where it begins and on how entries are placed along the curve.
    """
    good = {one.equator_least <= int(value.value) <= one.equator_most for one in (line, arcs)}
    least, most = (int(line[name]) for name in ("equator_least", "equator_most"))
    return value_row(
        value,
        measured=f"{least}" if least == most else f"{least} to {most}",
        **ranged(Range(min(least, arcs.equator_least), max(most, arcs.equator_most)), 10),
        rule="one of the numbers that are counted on turns across the equator",
        tolerance="none",
        verdict="inconclusive" if len(good) > 1 else "reproduced" if good == {True} else "differs",
        note=f"{line.equator_points:g} by the helix' own formula, which counts nothing; {arcs.equator_least:.0f} to {arcs.equator_most:.0f} with "
        "entries at equal arcs",
    )


def contradiction(value, values) -> dict[str, str]:
    """Does the printed memory contradict the entries in the same row? It does if it cannot be rounded from them; then the
    number is a slip of the thesis.
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
