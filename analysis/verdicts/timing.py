# SPDX-License-Identifier: GPL-3.0-or-later
# @data      sampling_time detection_time
"""Verdicts on times (Tables 3, 4, 8 and 9). A time on another machine says nothing by itself. What can be compared is
which method is faster, by how much, and how its time grows; these have rows of their own.

Each is a range: over the rounds of both times, the joints of a row, the readings of the thesis (counterparts.csv), and what
another machine may change. Nothing differs from the thesis' times of Tables 3 and 8 that does not do so from all within a
tick of the clock that gave them. Table 8 repeats Table 3, and Table 9 repeats Table 4; their numbers are counted once.
"""

import math
from pathlib import Path

import pandas as pd

import common
from common import timing
from common.ranges import MACHINE, Range, all_of, both, slope_limits, slope_range, union
from common.tally import NOT_COUNTED
from verdicts.verdict import judged, not_counted, ranged, row, value_row

RATIO_FACTOR = math.sqrt(10)  # half an order of magnitude: other machine, compiler, implementation of the rival
RATIO_RULE = "ratio within half an order of magnitude of the thesis' ratio, and not the opposite trend; all of its range"
TICK_RULE = "; it differs only if it does so for all times within a tick of the thesis' clock"
ORDER_RULE = "same methods, fastest first, in the same order; all of the range, from low to high, of the nearest ratio"
TRIANGLES = 3000  # of each model in Table 8
MOST_OFF = 0.25  # of an exponent: n against n^1.25
AGAIN = {"table-3": timing.TABLE_8, "table-4": timing.TABLE_9}  # where the thesis prints a table again


class Times:
    """Our times and the thesis' times of a table."""

    def __init__(self, results: Path, table: timing.TimingTable):
        self.table = table
        self.lines = timing.compare(results, table)
        self.thesis = timing.thesis_times(table)
        self.ticks = table.data == timing.TABLE_8.data
        self.readings = common.readings(table.artefact)
        self.by_name = {(line[table.key], line.joint, line.method): line for _, line in self.lines.iterrows()}

    def printed(self, key: float, column: str) -> Range:
        """A time of the thesis, of Tables 3 and 8 within a tick of its clock: one that is a tick may have been any shorter one."""
        time = self.thesis[key, column]
        return Range(max(time - timing.TICK_MS, 0), time + timing.TICK_MS) if self.ticks else Range(time, time)

    def joints(self, key: float) -> list[str]:
        """The joints of a row, which stand in for the thesis' single one."""
        return list(self.lines[self.lines[self.table.key] == key].joint.unique())

    def ways(self, key: float, columns: list[str]) -> dict[str, dict[str, pd.Series]]:
        """Every way to choose our times for these columns in a row, by joint and reading; equal ones only once."""
        found: dict[str, dict[str, pd.Series]] = {}
        seen = set()
        named = common.reading_names(self.table.artefact)
        for joint in self.joints(key):
            for methods in self.readings:
                chosen = (joint, *(methods[column] for column in columns))
                if chosen in seen or any((key, joint, methods[column]) not in self.by_name for column in columns):
                    continue
                seen.add(chosen)
                words = [word for column in columns if (word := named.get((column, methods[column])))]
                name = ", ".join(dict.fromkeys([*([joint.replace("_", " ")] if len(self.joints(key)) > 1 else []), *words]))
                found[name] = {column: self.by_name[key, joint, methods[column]] for column in columns}
        return found

    def trend(self, column: str) -> tuple[float, Range]:
        """The power of the size with which the ratio to the reference grows, in the thesis and here."""
        keys = [key for key, name in self.thesis if name == column and math.isfinite(self.thesis[key, column])]
        keys = [key for key in keys if self.ways(key, [column, timing.REFERENCE])]
        sizes = pd.Series([1 / key if self.table.key == "precision_deg" else key for key in keys])
        theirs = timing.slope(sizes, pd.Series([self.thesis[key, column] / self.thesis[key, timing.REFERENCE] for key in keys]))
        found = []
        for choice in self.choices(keys, [column, timing.REFERENCE]):
            ratios = [timing.spread(way[column]) / timing.spread(way[timing.REFERENCE]) for way in choice]
            found.append(slope_range([way[column]["size"] for way in choice], ratios))
        return theirs, union(found)

    def choices(self, keys: list[float], columns: list[str]) -> list[list[dict[str, pd.Series]]]:
        """Lists of ways: one for each row, by one reading, with each joint of the last rows."""
        found = []
        for methods in self.readings:
            for joint in {joint: 0 for key in keys for joint in self.joints(key)}:
                rows = [[self.by_name.get((key, name, methods[column])) for column in columns]
                        for key in keys for name in [joint if joint in self.joints(key) else timing.GENERATED]]
                if all(line is not None for lines in rows for line in lines):
                    found.append([dict(zip(columns, lines)) for lines in rows])
        return found


def rows(results: Path) -> list[dict]:
    """The rows of every timing table."""
    found = {table.artefact: timing_rows(Times(results, table)) for table in timing.TABLES}
    for artefact, again in AGAIN.items():
        found[artefact] = [once(line, again, found[again.artefact]) for line in found[artefact]]
    return [line for lines in found.values() for line in lines]


def doubts(*lines: pd.Series) -> list[str]:
    """What a reader must know about our times behind a row."""
    notes = []
    if any(line.extrapolated for line in lines):
        notes.append("ours is extrapolated from a smaller run")
    if any(line.inconclusive for line in lines):
        notes.append("the run doubts our timing: one round, or a busy machine")
    return notes


def sides(judgements: dict[str, bool | None], found: dict[str, Range]) -> list[str]:
    """The result of each way, if there are several or the result is open."""
    if len(found) == 1 and all_of(judgements.values()) is not None:
        return []
    words = {True: "meets the rule", False: "does not", None: "may or may not"}
    return [f"{name or 'over rounds and machines'}, {common.plain(found[name].low, 3)} to {common.plain(found[name].high, 3)}: {words[good]}"
            for name, good in judgements.items()]


def tests(table: timing.TimingTable, line: pd.Series) -> float:
    """Number of tests of the pairwise way: each ray of two RSID tables against each triangle of its model, or each pair of
    triangles.
    """
    if table.key == "triangles":
        return line.triangles**2
    return 2 * TRIANGLES * (180 / line.precision_deg + 1) * (360 / line.precision_deg)


def against_the_thesis(table: timing.TimingTable, line: pd.Series) -> str:
    """How our time of a method compares with the thesis', and for the pairwise way how the time of one test does."""
    gain = line.thesis_ms / line.measured_ms
    times = f"1/{gain:.3g} of" if gain >= 1 else f"{1 / gain:.3g} times"
    text = f"{common.label(line.method)} takes {times} the thesis' time"
    if line.thesis_column == "pairwise":
        ours, theirs = (1e6 * time / tests(table, line) for time in (line.measured_ms, line.thesis_ms))
        text += f" ({ours:.3g} ns a test, there {theirs:.3g})"
    return text


def ticks(times: Times, *lines: pd.Series) -> list[str]:
    """Notes that a time of Table 8 is hardly longer than a tick of the thesis' clock."""
    if not times.ticks:
        return []
    short = sorted({line.thesis_ms for line in lines if round(line.thesis_ms / timing.TICK_MS) < 3})
    counts = [f"{time:g} ms are {round(time / timing.TICK_MS)}" for time in short]
    return [f"in ticks of the thesis' clock {' and '.join(counts)}"] if short else []


def meets(found: Range, best: Range, allowed: Range) -> bool | None:
    """Does all of it meet the limits by the thesis' printed times, or none of it even those that its clock allows?"""
    good = found.within(best.low, best.high)
    return good if good is not False or found.within(allowed.low, allowed.high) is False else None


def time_row(times: Times, value) -> dict:
    """A time, for the reader; it is not judged."""
    key = common.number(value.row)
    ways = [way[value.column] for way in times.ways(key, [value.column]).values()]
    notes = ["not measured in this run"]
    if ways:
        line = ways[0]
        known = value.value != "N/A"
        notes = [against_the_thesis(times.table, line) if known else f"measured with {common.label(line.method)}", *doubts(*ways)]
    found = value_row(
        value,
        measured=common.plain(ways[0].measured_ms) if ways else "",
        **(ranged(union(timing.spread(line) for line in ways)) if ways else {}),
        rule="times of different machines are not compared; see the ratios, the order and the growth",
        verdict="not-comparable",
        note="; ".join(notes),
    )
    return not_counted(found, "the thesis gives no time") if value.value == "N/A" else found


def ratio_row(times: Times, name: str, column: str) -> dict:
    """How many times faster the thesis' own method is than another, in the thesis and here."""
    key = common.number(name)
    ways = times.ways(key, [column, timing.REFERENCE])
    theirs = times.thesis[key, column] / times.thesis[key, timing.REFERENCE]
    found = {way: timing.spread(lines[column]) / timing.spread(lines[timing.REFERENCE]) for way, lines in ways.items()}
    found = {way: one.widened(MACHINE) for way, one in found.items()}
    there, here = times.trend(column)
    same_trend = here.within(0, math.inf) if there > 0 else here.within(-math.inf, 0)
    allowed = (times.printed(key, column) / times.printed(key, timing.REFERENCE)).widened(RATIO_FACTOR)
    good = {way: both(meets(one, Range(theirs, theirs).widened(RATIO_FACTOR), allowed), same_trend) for way, one in found.items()}
    first = next(iter(ways.values()))
    ours = first[column].measured_ms / first[timing.REFERENCE].measured_ms
    verdict = judged(all_of(good.values()))
    notes = [f"off by a factor of {max(ours, theirs) / min(ours, theirs):.3g}"]
    if same_trend is not True:
        notes.append(
            f"the ratio grows with the power {here.low:.2f} to {here.high:.2f} of {what_grows(times.table)}, in the thesis with {there:.2f}"
        )
    if verdict == "differs":
        notes += [against_the_thesis(times.table, one) for one in first.values()]
    if verdict != "reproduced":
        notes += ticks(times, *first.values())
    return row(
        times.table.artefact,
        name,
        f"{column}/{timing.REFERENCE}",
        thesis=common.plain(theirs),
        measured=common.plain(ours),
        **ranged(union(found.values())),
        unit="ratio",
        rule=RATIO_RULE + (TICK_RULE if times.ticks else ""),
        tolerance=f"factor {RATIO_FACTOR:.3g}",
        verdict=verdict,
        note="; ".join([*notes, *sides(good, found), *doubts(*(line for way in ways.values() for line in way.values()))]),
    )


def what_grows(table: timing.TimingTable) -> str:
    """What the size of a row of the table is."""
    return "1 / precision" if table.key == "precision_deg" else "the triangles"


def order_row(times: Times, name: str, columns: list[str]) -> dict:
    """Which method is faster: the fastest first, by the thesis' names. Every ratio of one to the next is above 1, or not."""
    key = common.number(name)
    theirs = sorted(columns, key=lambda column: times.thesis[key, column])
    ways = times.ways(key, columns)
    nearest, good = {}, {}
    for way, lines in ways.items():
        steps = [timing.spread(lines[slow]) / timing.spread(lines[fast]) for fast, slow in zip(theirs, theirs[1:])]
        steps = [step.widened(MACHINE) for step in steps]
        nearest[way] = min(steps, key=lambda step: step.low)
        judgements = [step.within(1, math.inf) for step in steps]
        good[way] = False if False in judgements else None if None in judgements else True
    first = next(iter(ways.values()))
    ours = sorted(columns, key=lambda column: first[column].measured_ms)
    moved = [first[column] for column in columns if theirs.index(column) != ours.index(column)]
    return row(
        times.table.artefact,
        name,
        "order",
        thesis=" < ".join(theirs),
        measured=" < ".join(ours),
        **ranged(union(nearest.values())),
        unit="order",
        rule=ORDER_RULE,
        tolerance="none",
        verdict=judged(all_of(good.values())),
        note="; ".join([*(against_the_thesis(times.table, line) for line in moved), *sides(good, nearest),
                        *doubts(*(line for way in ways.values() for line in way.values()))]),
    )


def growth_row(times: Times, column: str) -> dict:
    """How the times of a method grow, if both have one; the note has our other ways to do the same."""
    known = [key for key, name in times.thesis if name == column and math.isfinite(times.thesis[key, column])]
    choices = times.choices(known, [column])
    scaled = any(way[column].extrapolated for way in choices[0])
    choices = [choice for choice in choices if not any(way[column].extrapolated for way in choice)]
    sizes = pd.Series([1 / key if times.table.key == "precision_deg" else key for key in known])
    theirs = timing.slope(sizes, pd.Series([times.thesis[key, column] for key in known]))
    clock = slope_limits(sizes, [times.printed(key, column) for key in known])
    shared = {"thesis": f"{theirs:.2f}", "unit": "exponent", "tolerance": f"{MOST_OFF}",
              "rule": f"power of {what_grows(times.table)} that fits the times, as near as n to n^1.25; all of its range, of times that settled"
              + (TICK_RULE if times.ticks else "")}
    if scaled:
        return row(times.table.artefact, "growth", column, **shared, verdict="not-comparable",
                   note="ours are scaled by the number of tests, of which the power follows by itself")
    found = {}
    for choice in choices:
        name = ", ".join(dict.fromkeys(f"{way[column].joint.replace('_', ' ')}, {common.label(way[column].method)}" for way in choice[-1:]))
        found[name] = slope_range([way[column]["size"] for way in choice], [timing.spread(way[column]) for way in choice])
    first = [way[column] for way in choices[0]]
    ours = timing.slope(pd.Series([line["size"] for line in first]), pd.Series([line.measured_ms for line in first]))
    best, allowed = (Range(ends.low - MOST_OFF, ends.high + MOST_OFF) for ends in (Range(theirs, theirs), clock))
    good = {name: meets(one, best, allowed) for name, one in found.items()}
    settled = not any(way[column].inconclusive for choice in choices for way in choice)
    verdict = judged(all_of(good.values()) if settled else None)
    notes = sides(good, found)
    if verdict == "differs":
        unit = "deg" if times.table.key == "precision_deg" else "triangles"
        ends = (f"at {line[times.table.key]:,g} {unit} {against_the_thesis(times.table, line)}" for line in (first[0], first[-1]))
        notes += [f"off by {ours - theirs:+.2f}", *ends]
    if verdict != "reproduced":
        notes += ticks(times, *first)
    return row(
        times.table.artefact,
        "growth",
        column,
        measured=f"{ours:.2f}",
        **ranged(union(found.values())),
        **shared,
        verdict=verdict,
        note="; ".join([*notes, *doubts(*(way[column] for choice in choices for way in choice))]),
    )


def timing_rows(times: Times) -> list[dict]:
    """Every time of the table; then for each of its rows the ratios and the order; then the growth."""
    values = common.thesis(times.table.artefact)
    rows = [time_row(times, value) for value in values.itertuples()]
    for name in values.row.unique():
        key = common.number(name)
        known = [column for column in values.column.unique() if math.isfinite(times.thesis[key, column])]
        if timing.REFERENCE not in known or len(known) < 2 or not times.ways(key, known):
            continue
        rows += [ratio_row(times, name, column) for column in known if column != timing.REFERENCE]
        rows.append(order_row(times, name, known))
    if times.table.artefact in AGAIN:
        return rows
    return rows + [growth_row(times, column) for column in values.column.unique()]


def repeated(line: dict, again: str) -> bool:
    """Does the other table print the times of this row too, be it with other digits?"""
    printed = {(value.artefact, value.row, value.column): value.value for value in common.thesis().itertuples()}
    pairs = [[printed.get((artefact, line["row"], column), "") for artefact in (line["artefact"], again)] for column in line["column"].split("/")]
    return all(all(pair) and common.same_number(*pair) for pair in pairs)


def once(line: dict, again: timing.TimingTable, theirs: list[dict]) -> dict:
    """The row, not counted if the other table has the same number, or an order that contains this one."""
    name = (line["row"], line["column"])
    twin = next((other for other in theirs if (other["row"], other["column"]) == name), None)
    if twin is None or line["rule"].startswith(NOT_COUNTED):
        return line
    there = f"{again.artefact}, {line['row']}, {line['column']}"
    if twin["thesis"] == line["thesis"] or repeated(line, again.artefact):
        return not_counted(line, f"the same number as {there}")
    longer = iter(twin["thesis"].split(" < "))
    held = line["column"] == "order" and all(method in longer for method in line["thesis"].split(" < "))
    return not_counted(line, f"part of {there}") if held else line
