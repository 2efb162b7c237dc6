# SPDX-License-Identifier: GPL-3.0-or-later
"""For those who evaluate the artefact: each claim, the command that checks it, its minutes and what to expect."""

from __future__ import annotations

import html
from pathlib import Path

import common
from common.jobs import Job
from report.artefacts import heading
from report.markup import element, fold

HEADS = ("claim", "command", "minutes", "expected")
# What the first screen says beyond the thesis.
FIRST = {
    "error-against-time": "the same errors; times of your machine, in the same order",
    "limit-time": "ours misses no contact; times of your machine",
    "scene-needs": "the same answers; times of your machine",
    "stability-overview": "ours: none wrong, no bound broken",
}


def seconds(job: Job, maker: dict[str, Job], seen: set[str]) -> float:
    """Budget of a job and of all that it is made from, each once."""
    if job.name in seen:
        return 0.0
    seen.add(job.name)
    needed = (maker[file] for file in job.depends if file in maker)
    return job.budget[0] + sum(seconds(other, maker, seen) for other in needed)


def expected(job: Job, kept: Path) -> str:
    """What the first screen says, or the reference run found; empty where it has no verdict on it."""
    if job.name in FIRST:
        return FIRST[job.name]
    if not (kept / "verdicts.csv").is_file():
        return ""
    verdicts = common.as_text(kept / "verdicts.csv")
    counts = verdicts[verdicts.artefact == job.name].verdict.value_counts()
    return ", ".join(f"{count} {name}" for name, count in counts.items())


def minutes(of: float) -> str:
    """As a reader has them."""
    return f"{of / 60:.1f}" if of >= 6 else "under 0.1"


def section(jobs: list[Job], kept: Path) -> str:
    """A row for each table and figure that has verdicts or that the first screen rests on."""
    maker = {output: job for job in jobs for output in job.outputs}
    rows = ""
    for job in jobs:
        if job.kind not in ("table", "figure") or not (verdicts := expected(job, kept)):
            continue
        cells = [
            element("a", html.escape(heading(job)), href=f"#{job.name}"),
            element("code", f"experiments/reproduce --only {job.name}"),
            minutes(seconds(job, maker, set())),
            verdicts,
        ]
        rows += element("tr", "".join(element("td", cell) for cell in cells))
    head = "".join(element("th", title, scope="col") for title in HEADS)
    table = element("table", element("thead", element("tr", head)) + element("tbody", rows), class_="cards")
    about = (
        "Each command, from a clone of the project, measures again what the table or figure needs, and nothing else. Minutes: time budget"
        " of the quick profile on two cores, after the build, with no earlier results. Expected: the verdicts of the reference run, or what the first screen says. What is"
        " called proven, theorem by theorem, with the tests that attack it: " + element("code", "paper/claims.md") + "."
    )
    return fold("Check a claim", element("p", about) + element("div", table, class_="scroll"), "claims", "a command, its minutes and what to expect")
