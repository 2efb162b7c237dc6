#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What changed between two runs, made by another commit, compiler or machine: experiments/compare.py RUN RUN, two result folders.

Prints on what each was made; the verdicts and findings that differ, of those that both runs give by the same rule; the errors
above their proven bounds, in either run; how many numbers of each CSV differ, of one with times those that count answers
(ANSWERS) alone; and the ratios of the times, second over first. The spread of a ratio is that of both medians: their
interquartile ranges, as shares, in quadrature. A ratio that differs from 1 by less than its spread means nothing.
Rows are compared if both runs have as many and their words agree. Exit code 0 if only times changed, 1 if anything else did, 2
for a folder that is no run. Standard library only.
"""

from __future__ import annotations

import argparse
import csv
import json
import math
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(SOURCE / "analysis" / "common"))

from sidecars import Refused, sidecar  # noqa: E402

MADE_ON = ("commit", "dirty", "profile", "compiler", "flags", "cpu", "cores", "system")
UNITS_OF_TIME = ("ns", "us", "ms", "s")
# Errors and the bounds that are proven of them, by the name of the CSV.
BOUNDS = {
    "all_gaps": (("max_over_um", "bound_um"), ("max_under_um", "bound_um")),
    "error_against_time": (("max_over_um", "bound_um"), ("max_under_um", "bound_um")),
    "phantoms": (("error", "bound"),),
    "sampling_error_proven": (("measured_max_mm", "bound_mm"), ("attained_mm", "bound_mm")),
    "stability_detail": (("error_um", "bound_um"),),
}
# Columns of CSVs with times that say what was answered, not how fast or in how many rounds.
ANSWERS = {"wrong", "missed", "misses", "false_hits", "touching", "impinged", "otherwise", "asked", "largest_error_deg", "scan_um", "error_um"}
SHOWN = 10  # lines of a kind, all of them with --all
KEYS = ("artefact", "row", "column")
RULE = ("thesis", "unit", "rule", "tolerance")
STATEMENT = ("where", "claim")


class Run:
    """A result folder: its verdicts and findings, its CSVs, and what their sidecars say."""

    def __init__(self, folder: Path):
        self.folder = folder
        if not (folder / "verdicts.csv").is_file() and not list(folder.glob("data/*.csv")):
            raise Refused(f"{folder} is no result folder: it has no verdicts.csv and no data/*.csv")
        self.verdicts = {}
        if (folder / "verdicts.csv").is_file():
            self.verdicts = {tuple(row[key] for key in KEYS): row for row in read(folder / "verdicts.csv")}
        self.findings = {}
        for kept in (folder / "findings.csv", folder / "tables" / "findings.csv"):  # the first of a run kept as the earlier one
            if kept.is_file():
                self.findings = {tuple(row[key] for key in STATEMENT): row for row in read(kept)}
        tables = sorted(folder.glob("data/*.csv"))
        self.records = {table.stem: sidecar(table) for table in tables}

    def rows(self, name: str) -> list[dict[str, str]]:
        """The rows of a CSV, with the columns of NAME_spread.csv, which has the spread of some times."""
        rows = read(self.folder / "data" / f"{name}.csv")
        if f"{name}_spread" in self.records:
            spread = read(self.folder / "data" / f"{name}_spread.csv")
            rows = [{**more, **row} for row, more in zip(rows, spread)] if len(spread) == len(rows) else rows
        return rows

    def made_on(self) -> dict[str, str]:
        """What all CSVs say about where the run was made; different answers are joined by "and"."""
        records = list(self.records.values())
        if not records and (self.folder / "run.json").is_file():  # of results/reference
            records = [json.loads((self.folder / "run.json").read_text())]
        return {key: " and ".join(sorted({str(record.get(key)) for record in records})) for key in MADE_ON}


def read(table: Path) -> list[dict[str, str]]:
    with table.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def number(text: str | None) -> float:
    """The number in a cell; NaN for an empty cell and for a word."""
    try:
        return float(text or "nan")
    except ValueError:
        return math.nan


class Report:
    """The lines of the report, with a heading above each kind."""

    def __init__(self, everything: bool):
        self.everything = everything
        self.changed = False

    def lines(self, heading: str, lines: list[str], changed: bool = True) -> None:
        self.changed |= changed and bool(lines)
        print(f"{heading}: {len(lines) if lines else 'none'}")
        for line in lines if self.everything else lines[:SHOWN]:
            print(f"  {line}")
        if not self.everything and len(lines) > SHOWN:
            print(f"  and {len(lines) - SHOWN} more; --all has them")


def changed_verdicts(one: Run, two: Run) -> list[str]:
    """Of what both judge by the same rule; and what one judges alone."""
    lines = []
    for key in {**one.verdicts, **two.verdicts}:
        before, after = (run.verdicts.get(key, {"verdict": "not there", "measured": ""}) for run in (one, two))
        same_rule = all(before.get(part, "") == after.get(part, "") for part in RULE) or "not there" in (before["verdict"], after["verdict"])
        if same_rule and before["verdict"] != after["verdict"]:
            measured = f" ({before['measured']} -> {after['measured']})" if before["measured"] != after["measured"] else ""
            lines.append(f"{', '.join(key)}: {before['verdict']} -> {after['verdict']}{measured}")
    return lines


def changed_findings(one: Run, two: Run) -> list[str]:
    """Of the statements of the thesis that both have in the same words."""
    shared = [key for key in one.findings if key in two.findings]
    pairs = ((key, one.findings[key]["verdict"], two.findings[key]["verdict"]) for key in shared)
    return [f"{where}, {claim}: {before} -> {after}" for (where, claim), before, after in pairs if before != after]


def beyond_bounds(run: Run, label: str) -> list[str]:
    lines = []
    for name in sorted(BOUNDS.keys() & run.records.keys()):
        for place, row in enumerate(run.rows(name), start=2):
            for error, bound in BOUNDS[name]:
                if abs(number(row.get(error))) > number(row.get(bound)):
                    lines.append(f"{label}, {name}.csv, line {place}: {error} {row[error]} > {bound} {row[bound]}")
    return lines


def columns(run: Run, name: str) -> dict[str, str]:
    return {column["name"]: column["unit"] for column in run.records[name].get("columns", [])}


def is_time(unit: str) -> bool:
    return unit.split(" ")[0].split("/")[0] in UNITS_OF_TIME


def paired(one: Run, two: Run, name: str) -> list[tuple[dict, dict]] | None:
    """Pairs of rows of both runs; None if the rows do not correspond."""
    first, second = one.rows(name), two.rows(name)
    if len(first) != len(second):
        return None
    for a, b in zip(first, second):
        words = [column for column, unit in columns(one, name).items() if unit == "" and column != "inconclusive"]
        if any(a.get(word) != b.get(word) and math.isnan(number(a.get(word))) for word in words):
            return None
    return list(zip(first, second))


def spread_name(column: str) -> str:
    """The column of the interquartile range of a time: median_ms has iqr_ms, build_ms has build_iqr_ms."""
    if column.startswith("median_"):
        return "iqr_" + column.removeprefix("median_")
    stem, _, unit = column.rpartition("_")
    return f"{stem}_iqr_{unit}"


def ratios(pairs: list[tuple[dict, dict]], column: str) -> list[tuple[float, float]]:
    """Each time's ratio, second over first, and the ratio's spread."""
    spread = spread_name(column)
    found = []
    for first, second in pairs:
        a, b, da, db = (number(row.get(name)) for name in (column, spread) for row in (first, second))
        if a > 0 and b > 0 and not math.isnan(da + db):
            found.append((b / a, math.hypot(da / a, db / b)))
    return found


def told_ratios(name: str, column: str, found: list[tuple[float, float]]) -> str:
    logs = sorted(math.log(ratio) for ratio, _ in found)
    beyond = sum(abs(math.log(ratio)) > spread for ratio, spread in found)
    spreads = sorted(spread for _, spread in found)
    return (
        f"{name}.csv {column}: {math.exp(sum(logs) / len(logs)):.3g} in the geometric mean of {len(found)}, from "
        f"{math.exp(logs[0]):.3g} to {math.exp(logs[-1]):.3g}, spread {spreads[len(spreads) // 2]:.2g} in the median; "
        f"{beyond} beyond their spread"
    )


def compare_data(one: Run, two: Run, report: Report) -> None:
    other, numbers, times = [], [], []
    for name in sorted(one.records.keys() | two.records.keys()):
        if name not in one.records or name not in two.records:
            other.append(f"{name}.csv is in the {'second' if name in two.records else 'first'} alone")
            continue
        if name.endswith("_samples"):
            continue
        pairs = paired(one, two, name)
        if pairs is None:
            other.append(f"{name}.csv has other rows")
            continue
        timed = {column for column, unit in columns(one, name).items() if is_time(unit)}
        for column in columns(one, name):
            if column in timed:
                found = ratios(pairs, column)
                times += [told_ratios(name, column, found)] if found else []
            elif column in ANSWERS or not one.records[name].get("timing"):
                numbers += told_numbers(name, column, pairs)
    report.lines("CSVs that cannot be compared", other)
    report.lines("columns whose numbers differ", numbers)
    report.lines("ratios of times, second over first", times, changed=False)


def told_numbers(name: str, column: str, pairs: list[tuple[dict, dict]]) -> list[str]:
    differing = [(first.get(column), second.get(column)) for first, second in pairs if first.get(column) != second.get(column)]
    if not differing:
        return []
    off = [abs(number(b) - number(a)) / max(abs(number(a)), abs(number(b)), 1e-300) for a, b in differing]
    known = [share for share in off if not math.isnan(share)]
    most = f", by {100 * max(known):.3g} % at most" if known else ""
    return [f"{name}.csv {column}: {len(differing)} of {len(pairs)}{most}"]


def main() -> int:
    parser = argparse.ArgumentParser(prog="compare", description="What changed between two runs.")
    parser.add_argument("first", type=Path, help="result folder")
    parser.add_argument("second", type=Path, help="result folder of another commit, compiler or machine")
    parser.add_argument("--all", action="store_true", help="every line, not the first ten of a kind")
    options = parser.parse_args()
    try:
        one, two = Run(options.first), Run(options.second)
        report = Report(options.all)
        sides = [run.made_on() for run in (one, two)]
        for key in MADE_ON:
            before, after = (side[key] for side in sides)
            print(f"{key}: {before}" if before == after else f"{key}: {before} -> {after}")
        report.lines("verdicts that changed", changed_verdicts(one, two))
        report.lines("findings that changed", changed_findings(one, two))
        report.lines(
            "errors above their proven bounds", beyond_bounds(one, "first") + beyond_bounds(two, "second")
        )
        compare_data(one, two, report)
    except Refused as error:
        print(f"compare: error: {error}", file=sys.stderr)
        return 2
    return 1 if report.changed else 0


if __name__ == "__main__":
    sys.exit(main())
