# SPDX-License-Identifier: GPL-3.0-or-later
# @data      sampling_time detection_time
"""Verdicts on times (Tables 3, 4, 8 and 9). A time on another machine says nothing by itself; what can be compared is
which method is faster, by how much, and how its time grows, and those have rows of their own.

Table 3 stands in Table 8 again and Table 4 in Table 9: their numbers are counted there.
"""

import math
from pathlib import Path

import pandas as pd

import common
from common import log_plot, timing
from verdicts.verdict import NOT_COUNTED, not_counted, row, value_row

RATIO_FACTOR = math.sqrt(10)  # half an order of magnitude: other machine, compiler, implementation of the rival
RATIO_RULE = "ratio within half an order of magnitude of the thesis' ratio"
TRIANGLES = 3000  # of each model in Table 8
MOST_OFF = 0.25  # of an exponent: n against n^1.25
AGAIN = {"table-3": timing.TABLE_8, "table-4": timing.TABLE_9}  # where the thesis prints a table again


def rows(results: Path) -> list[dict]:
    """Those of every timing table."""
    found = {table.artefact: timing_rows(results, table) for table in timing.TABLES}
    for artefact, again in AGAIN.items():
        found[artefact] = [once(line, again, found[again.artefact]) for line in found[artefact]]
    return [line for lines in found.values() for line in lines]


def doubts(*lines: pd.Series) -> list[str]:
    """What a reader must know of the times of ours that a row rests on."""
    hips = {line.joint for line in lines if line.get("joint", "generated") != "generated"}
    notes = [f"in the place of the thesis' patient: {hip}" for hip in sorted(hips)]
    if any(line.extrapolated for line in lines):
        notes.append("ours is extrapolated from a smaller run")
    if any(line.inconclusive for line in lines):
        notes.append("our timing is inconclusive: one round, or the machine was busy")
    return notes


def judged(good: bool, *lines: pd.Series) -> str:
    """The verdict of a row that rests on these times."""
    return "inconclusive" if any(line.inconclusive for line in lines) else "reproduced" if good else "differs"


def tests(table: timing.TimingTable, line: pd.Series) -> float:
    """What the pairwise way tests: each ray of two RSID tables against each triangle of its model, or each pair of
    triangles.
    """
    if table.key == "triangles":
        return line.triangles**2
    return 2 * TRIANGLES * (180 / line.precision_deg + 1) * (360 / line.precision_deg)


def against_the_thesis(table: timing.TimingTable, line: pd.Series) -> str:
    """How our time of a method compares with the thesis', and of the pairwise way that of one test."""
    gain = line.thesis_ms / line.measured_ms
    times = f"1/{gain:.3g} of" if gain >= 1 else f"{1 / gain:.3g} times"
    text = f"{common.label(line.method)} takes {times} the thesis' time"
    if line.thesis_column == "pairwise":
        ours, theirs = (1e6 * time / tests(table, line) for time in (line.measured_ms, line.thesis_ms))
        text += f" ({ours:.3g} ns a test, there {theirs:.3g})"
    return text


def ticks(table: timing.TimingTable, *lines: pd.Series) -> list[str]:
    """That a time of Table 8 is hardly longer than a tick of the thesis' clock."""
    if table.data != timing.TABLE_8.data:
        return []
    short = sorted({line.thesis_ms for line in lines if round(line.thesis_ms / timing.TICK_MS) < 3})
    counts = [f"{time:g} ms are {round(time / timing.TICK_MS)}" for time in short]
    return [f"in ticks of the thesis' clock {' and '.join(counts)}"] if short else []


def time_row(table: timing.TimingTable, value, line: pd.Series | None) -> dict:
    """A time: given for the reader, not judged."""
    notes = []
    if line is None:
        notes.append("not measured in this run")
    else:
        known = value.value != "N/A"
        notes = [against_the_thesis(table, line) if known else f"measured with {common.label(line.method)}"]
        notes += doubts(line)
    found = value_row(
        value,
        measured="" if line is None else common.plain(line.measured_ms),
        rule="times of different machines are not compared; see the ratios, the order and the growth",
        verdict="not-comparable",
        note="; ".join(notes),
    )
    return not_counted(found, "the thesis gives no time") if value.value == "N/A" else found


def ratio_row(table: timing.TimingTable, name: str, line: pd.Series, reference: pd.Series) -> dict:
    """How many times the thesis' own method is faster than another, there and here."""
    off = max(line.thesis_ratio, line.measured_ratio) / min(line.thesis_ratio, line.measured_ratio)
    good = off <= RATIO_FACTOR
    both = (line, reference)
    why = [] if good else [*(against_the_thesis(table, one) for one in both), *ticks(table, *both)]
    return row(
        table.artefact,
        name,
        f"{line.thesis_column}/{timing.REFERENCE}",
        thesis=common.plain(line.thesis_ratio),
        measured=common.plain(line.measured_ratio),
        unit="ratio",
        rule=RATIO_RULE,
        tolerance=f"factor {RATIO_FACTOR:.3g}",
        verdict=judged(good, line, reference),
        note="; ".join([f"off by a factor of {off:.3g}", *why, *doubts(line, reference)]),
    )


def order_row(table: timing.TimingTable, name: str, lines: pd.DataFrame) -> dict:
    """Which method is faster: fastest first, under the thesis' names."""
    theirs = list(lines.sort_values("thesis_ms").thesis_column)
    ours = list(lines.sort_values("measured_ms").thesis_column)
    every = [line for _, line in lines.iterrows()]
    moved = [line for line in every if theirs.index(line.thesis_column) != ours.index(line.thesis_column)]
    return row(
        table.artefact,
        name,
        "order",
        thesis=" < ".join(theirs),
        measured=" < ".join(ours),
        unit="order",
        rule="same methods, fastest first, in the same order",
        tolerance="none",
        verdict=judged(not moved, *every),
        note="; ".join([*(against_the_thesis(table, line) for line in moved), *doubts(*every)]),
    )


def growth(table: timing.TimingTable, lines: pd.DataFrame, times: str) -> float:
    """The power of the size (triangles, or 1 / precision) that these times of a method grow with."""
    size = 1 / lines[table.key] if table.key == "precision_deg" else lines[table.key]
    return log_plot.slope(size, lines[times])


def growth_row(table: timing.TimingTable, column: str, lines: pd.DataFrame) -> dict:
    """How the times of a method grow, where both have one; beside it in the note, our other ways to do the same."""
    by_precision = table.key == "precision_deg"
    beside = lines[(lines.thesis_column == "") & lines.method.str.startswith(column) & ~lines.extrapolated]
    printed = lines[(lines.thesis_column == column) & lines.thesis_ms.notna()]
    lines = printed[~printed.extrapolated]
    every = [line for _, line in lines.iterrows()]
    ours = growth(table, lines, "measured_ms")
    theirs = growth(table, printed if math.isnan(ours) else lines, "thesis_ms")
    if math.isnan(ours):
        verdict = "not-comparable"
        notes = ["ours are scaled by the number of tests, of which the power follows by itself"]
    else:
        verdict, notes = judged(abs(ours - theirs) <= MOST_OFF, *every), doubts(*every)
    if verdict == "differs":
        unit = "deg" if by_precision else "triangles"
        ends = (f"at {line[table.key]:,g} {unit} {against_the_thesis(table, line)}" for line in (every[0], every[-1]))
        notes = [f"off by {ours - theirs:+.2f}", *ends, *ticks(table, *every), *notes]
    notes += [
        f"{common.label(method)}: {growth(table, own, 'measured_ms'):.2f}"
        for method, own in beside.groupby("method")
        if len(own) > 1
    ]
    return row(
        table.artefact,
        "growth",
        column,
        thesis=f"{theirs:.2f}",
        measured="" if math.isnan(ours) else f"{ours:.2f}",
        unit="exponent",
        rule=f"power of {'1 / precision' if by_precision else 'triangles'} that fits the times, as near as n to n^1.25",
        tolerance=f"{MOST_OFF}",
        verdict=verdict,
        note="; ".join(notes),
    )


def timing_rows(results: Path, table: timing.TimingTable) -> list[dict]:
    """Every time of the table, then for each of its rows the ratios and the order, then the growth."""
    ours = timing.compare(results, table)
    lines = ours[ours.thesis_column != ""]
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
    if table.artefact in AGAIN:
        return rows
    return rows + [growth_row(table, column, ours) for column in values.column.unique()]


def once(line: dict, again: timing.TimingTable, theirs: list[dict]) -> dict:
    """The line, not counted where the other table has the same number, or an order that holds this one."""
    name = (line["row"], line["column"])
    twin = next((other for other in theirs if (other["row"], other["column"]) == name), None)
    if twin is None or line["rule"].startswith(NOT_COUNTED):
        return line
    there = f"{again.artefact}, {line['row']}, {line['column']}"
    if twin["thesis"] == line["thesis"]:
        return not_counted(line, f"the same number as {there}")
    longer = iter(twin["thesis"].split(" < "))
    held = line["column"] == "order" and all(method in longer for method in line["thesis"].split(" < "))
    return not_counted(line, f"part of {there}") if held else line
