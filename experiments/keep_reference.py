#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps verdicts and tables of a finished full run in results/reference/, where the report finds what it shows beside those
of any other run. Verdicts and findings of the run that was kept before go to results/reference/earlier/DAY/, if it was of another
day; experiments/compare.py compares the two.

It refuses, with one line that says why, unless the run has the full profile and is complete, every CSV has the bytes that its
sidecar vouches for, and all of them come from one commit without changes. Standard library only.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import shutil
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(SOURCE / "analysis" / "common"))

import jobs  # noqa: E402
import tally  # noqa: E402
from sidecars import Refused, sidecar  # noqa: E402

MACHINE = ("profile", "commit", "cpu", "cores", "memory_mib", "system", "compiler", "flags")
KEYS = ("artefact", "row", "column")
EARLIER = ("verdicts.csv", "tables/findings.csv", "run.json")  # what stays of the run before


def outputs_of(build: Path, results: Path) -> list[str]:
    """Every file that the full run makes, from the graph in its build folder."""
    try:
        graph = build / "graph" / "jobs.json"
        folder, profile = (json.loads(graph.read_text())[key] for key in ("results", "profile"))
        made = jobs.load(graph)
    except (OSError, ValueError, KeyError, TypeError):
        raise Refused(f"{build} has made no results: --build names the build folder of the run") from None
    if Path(folder).resolve() != results:
        raise Refused(f"{build} makes {folder}, not {results}: give --results and --build of one run")
    if profile != "full":
        raise Refused(f"{results} is of the {profile} profile: run experiments/reproduce --full")
    return [output for job in made for output in job.outputs]


def record_of(table: Path) -> dict:
    """The sidecar of a CSV. It must say where the CSV was measured."""
    record = sidecar(table)
    missing = [key for key in (*MACHINE, "dirty", "started_utc") if key not in record]
    if missing:
        raise Refused(f"{table.with_suffix('.json')} lacks {missing[0]}: remove {table.name} and run again")
    return record


def run_of(tables: list[Path]) -> dict:
    """What all CSVs of the run have in common, and when the run began."""
    records = {table: record_of(table) for table in tables}
    first = next(iter(records.values()))
    for table, record in records.items():
        if record["profile"] != "full":
            raise Refused(f"{table} is of the {record['profile']} profile: remove it and run again")
        if record["dirty"] is not False:
            raise Refused(
                f"{table} comes from uncommitted changes, or does not know: commit them, remove the data and run again"
            )
        for key in MACHINE:
            if record[key] != first[key]:
                raise Refused(f"{table} has the {key} {record[key]}, others {first[key]}: remove the data and run again")
    begun = min(record["started_utc"] for record in records.values())
    return {**{key: first[key] for key in MACHINE}, "started_utc": begun}


def check_verdicts(verdicts: Path) -> None:
    """Refuses verdicts that lack a value of the thesis."""

    def rows(path: Path) -> set[tuple[str, ...]]:
        with path.open(newline="", encoding="utf-8") as file:
            return {tuple(row.get(key) or "" for key in KEYS) for row in csv.DictReader(file)}

    lacking = sorted(rows(SOURCE / "analysis" / "common" / "thesis_values.csv") - rows(verdicts))
    if lacking:
        raise Refused(
            f"{verdicts} has no verdict on {', '.join(lacking[0])}: it was made by another version, run again"
        )


def outcome(verdicts: Path) -> str:
    """How often each verdict was given, in the README's words."""
    with verdicts.open(newline="", encoding="utf-8") as file:
        return tally.said(csv.DictReader(file))


def day(reference: Path) -> str:
    """When the run that is kept began; nothing if there is none."""
    run = reference / "run.json"
    return json.loads(run.read_text())["started_utc"][:10] if run.exists() else ""


def keep(results: Path, tables: list[str], run: dict, reference: Path) -> None:
    """Replaces the folder once everything is written. What the older run left in it goes to earlier/DAY, or is removed."""
    reference.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=reference.parent, prefix=".reference-") as folder:
        staged = Path(folder)
        (staged / "tables").mkdir()
        for name in ("verdicts.csv", *tables):
            shutil.copyfile(results / name, staged / name)
        (staged / "run.json").write_text(json.dumps(run, indent=2, sort_keys=True) + "\n")
        if day(reference) not in ("", run["started_utc"][:10]):
            earlier = reference / "earlier" / day(reference)
            earlier.mkdir(parents=True, exist_ok=True)
            for name in EARLIER:
                if (reference / name).exists():
                    shutil.copyfile(reference / name, earlier / Path(name).name)
        if (reference / "tables").exists():
            (reference / "tables").rename(staged / "older")
        for name in ("tables", "verdicts.csv", "run.json"):
            os.replace(staged / name, reference / name)


def main() -> int:
    """Checks everything before it writes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", type=Path, default=SOURCE / "results", help="of a finished full run")
    parser.add_argument(
        "--build", type=Path, default=SOURCE / "build" / "release", help="the build folder of that run"
    )
    parser.add_argument(
        "--reference", type=Path, default=SOURCE / "results" / "reference", help="what is written"
    )
    options = parser.parse_args()
    results = options.results.resolve()
    try:
        outputs = outputs_of(options.build.resolve(), results)
        missing = [output for output in outputs if not (results / output).is_file()]
        if missing:
            more = f" and {len(missing) - 1} more are" if len(missing) > 1 else " is"
            raise Refused(f"{results / missing[0]}{more} not there: run experiments/reproduce --full to its end")
        is_csv = [output for output in outputs if output.endswith(".csv")]
        run = run_of([results / output for output in is_csv if output.startswith("data/")])
        check_verdicts(results / "verdicts.csv")
    except Refused as refusal:
        print(f"keep_reference: {refusal}", file=sys.stderr)
        return 1
    tables = [output for output in outputs if output.startswith("tables/") and not output.endswith(".tex")]
    keep(results, tables, run, options.reference)
    print(
        f"{options.reference}: verdicts and {len(tables)} tables of commit {run['commit'][:12]}, full profile"
    )
    print(f"{outcome(options.reference / 'verdicts.csv')} (for the README)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
