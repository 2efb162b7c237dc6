# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the report about one table or figure: what it shows, the command that makes it again, and where its data
come from.
"""

from __future__ import annotations

import html
import json
from pathlib import Path

import common
from common.jobs import Job
from report import data_table, picture
from report.artefacts import title_of
from report.markup import element

PROVENANCE = {
    "question": "Question",
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


def provenance(results: Path, name: str) -> str:
    """Where a CSV comes from, folded."""
    record = common.sidecar(results / "data" / f"{name}.csv")
    facts = [(title, fact(record[key])) for key, title in PROVENANCE.items() if key in record]
    timing = record.get("timing") or {}
    facts += [(title, timing_fact(timing[key])) for key, title in TIMING.items() if key in timing]
    lines = "".join(element("dt", title) + element("dd", html.escape(text)) for title, text in facts)
    link = element("a", f"data/{name}.csv", href=f"data/{name}.csv")
    return element("details", element("summary", f"Where {link} comes from") + element("dl", lines))


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


def section(results: Path, job: Job, kept: Path, linked: bool) -> str:
    """A table or figure with its caption, source and way to make it again; kept: the folder of the reference run;
    linked: a figure is a file beside the page, and not in it.
    """
    shown = job.outputs[0]
    if linked and job.kind == "figure":
        file = shown.replace(".svg", ".png")
        body = element("p", html.escape(job.question) + " " + element("a", file, href=file))
    elif job.kind == "table":
        body = element("p", html.escape(job.question)) + data_table.section(results / shown, kept)
    else:
        body = element(
            "figure", picture.image(results / shown, job.question) + element("figcaption", html.escape(job.question))
        )
    again = f"experiments/reproduce --only {job.name}"
    source = element("a", shown, href=shown) + f" · {job.script} · " + element("code", again)
    return (
        element("h3", title_of(job.name), id=job.name)
        + body
        + element("p", source, class_="source")
        + "".join(provenance(results, name) for name in job.data)
    )
