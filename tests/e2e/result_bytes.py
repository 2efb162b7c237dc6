# SPDX-License-Identifier: GPL-3.0-or-later
"""The bytes of a results folder, times aside.

What holds a time is named, not guessed: the columns of a CSV whose unit in the sidecar is one of time, and
keys of the JSON files. A timed experiment (its sidecar has a `timing`) takes as many samples as fit into its
time, so there the columns and keys that follow from that are named too, and of its samples only the header is
compared. Everything else must be the same to the byte in every run.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import re
from pathlib import Path

UNITS_OF_TIME = {"ns", "us", "ms", "s", "min", "h", "misses"}  # a cache, even simulated, misses as memory happens to lie
KEYS_OF_TIME = {"started_utc", "duration_s", "load", "times_ms"}
FOLLOW_FROM_TIMES = {"timing", "csv_sha256", "rows"}  # keys, of a timed experiment
COLUMNS_FROM_TIMES = {"rounds", "inconclusive", "repeats"}  # likewise


def is_time(unit: str) -> bool:
    """Whether a unit such as "ms", "ms or ns" or "1/s" has one of time in it."""
    return bool(UNITS_OF_TIME & set(re.split(r"[ /*]", unit)))


def untimed_csv(text: str, sidecar: dict) -> str:
    """The table without its columns of time."""
    timed = {column["name"] for column in sidecar["columns"] if is_time(column["unit"])}
    timed |= COLUMNS_FROM_TIMES if sidecar.get("timing") else set()
    rows = list(csv.reader(io.StringIO(text)))
    kept = [i for i, name in enumerate(rows[0]) if name not in timed]
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([row[i] for i in kept] for row in rows)
    return out.getvalue()


def untimed_json(text: str) -> str:
    """The record without what a run's times make."""
    record = json.loads(text)
    keys = KEYS_OF_TIME | (FOLLOW_FROM_TIMES if record.get("timing") else set())
    if any(is_time(column["unit"]) for column in record.get("columns", [])):
        keys.add("csv_sha256")
    return json.dumps({key: value for key, value in record.items() if key not in keys}, sort_keys=True)


def untimed(file: Path) -> bytes:
    """What must be the same in every run."""
    sidecar = file.with_suffix(".json")
    if file.suffix == ".csv" and sidecar.is_file() and "columns" in json.loads(sidecar.read_text()):
        record = json.loads(sidecar.read_text())
        text = file.read_text()
        digest = hashlib.sha256(file.read_bytes()).hexdigest()
        assert record["csv_sha256"] == digest, f"{file} is not that of its sidecar"
        samples = record.get("timing") and file.stem.endswith("_samples")
        return (text.splitlines()[0] if samples else untimed_csv(text, record)).encode()
    if file.suffix == ".json":
        return untimed_json(file.read_text()).encode()
    return file.read_bytes()


def untimed_bytes(results: Path) -> dict[str, str]:
    """SHA-256 of what must be the same of every file of the folder, hidden and temporary ones too."""
    files = sorted(file for file in results.rglob("*") if file.is_file())
    return {str(file.relative_to(results)): hashlib.sha256(untimed(file)).hexdigest() for file in files}
