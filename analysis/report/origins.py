# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the report that says where each CSV comes from: program, commit, machine and settings, from its sidecar."""

from __future__ import annotations

import html
import json
from pathlib import Path

from common.jobs import Job
from report.markup import element, fold

FACTS = {
    "command": "Command",
    "profile": "Profile",
    "seed": "Seed",
    "commit": "Commit",
    "dirty": "Uncommitted changes",
    "driver_sha256": "SHA-256 of the program",
    "csv_sha256": "SHA-256 of the CSV",
    "compiler": "Compiler",
    "flags": "Flags",
    "cpu": "CPU",
    "cores": "Cores",
    "memory_mib": "Memory, MiB",
    "governor": "Frequency governor",
    "load": "Load before",
    "system": "System",
    "started_utc": "Started",
    "duration_s": "Took, s",
    "libraries": "Libraries",
    "parameters": "Parameters",
}
TIMING = {"inconclusive": "Inconclusive timings", "control": "Control (one case against itself)"}
MOST_CASES = 10  # inconclusive timings that are named; the sidecar names all


def section(results: Path, jobs: list[Job]) -> str:
    """What all of them share, then each CSV that something of the page is made from."""
    names = sorted({name for job in jobs for name in job.data})
    records = {name: json.loads((results / "data" / f"{name}.json").read_text()) for name in names}
    facts = {name: facts_of(record) for name, record in records.items()}
    shared = dict(set.intersection(*(set(own.items()) for own in facts.values())))
    shared = {title: shared[title] for title in FACTS.values() if title in shared}
    about = "Each CSV has a sidecar (.json) with these facts and the SHA-256 of its bytes. The same for all of them:"
    inner = element("p", about, class_="soft") + listed(shared)
    for name, own in facts.items():
        title = element("summary", html.escape(f"{name.replace('_', ' ')}: {records[name]['question']}"))
        link = element("p", element("a", f"data/{name}.csv", href=f"data/{name}.csv"))
        rest = {title: text for title, text in own.items() if title not in shared}
        inner += element("details", title + link + listed(rest), id=f"data-{name}")
    return fold("Where the data come from", inner, "origins", f"{len(names)} CSVs")


def listed(facts: dict[str, str]) -> str:
    """Titles and texts."""
    return element("dl", "".join(element("dt", title) + element("dd", html.escape(text)) for title, text in facts.items()))


def facts_of(record: dict) -> dict[str, str]:
    """What a sidecar says, as a reader calls it."""
    facts = {title: fact(record[key]) for key, title in FACTS.items() if key in record}
    timing = record.get("timing") or {}
    return facts | {title: timing_fact(timing[key]) for key, title in TIMING.items() if key in timing}


def fact(value: object) -> str:
    """A value of a sidecar, as text."""
    return json.dumps(value, ensure_ascii=False) if isinstance(value, (dict, list, bool)) else str(value)


def timing_fact(value: object) -> str:
    """What a sidecar says of the timing, without the single samples."""
    if isinstance(value, dict):
        value = {key: inner for key, inner in value.items() if key != "samples_ms"}
    if isinstance(value, list) and len(value) > MOST_CASES:
        return f"{len(value)}, such as {', '.join(value[:MOST_CASES])}; the sidecar (.json) names all"
    return json.dumps(value) if value else "none"
