# SPDX-License-Identifier: GPL-3.0-or-later
"""What the graph says of the tables and figures that the report shows, in the order in which it shows them, and what each is called."""

from __future__ import annotations

import re
from pathlib import Path

from common import jobs
from common.jobs import Job

# Parts of the page, and how the names of what stands there begin; the first that fits counts. What no beginning fits stands in the last.
TOPICS = {
    "Error, time and memory of each method": (
        "error-", "contact-against", "work-", "ablation", "fast-", "matched-", "touch-", "limit-time", "joint3d-speed",
    ),
    "Stiff and extreme cases": ("stability-", "turns-"),
    "What one question needs": ("scene-needs", "needs-", "build-"),
    "Range of motion, shape and cartilage": ("motion-", "certified-", "cohort-", "strain-", "joint-"),
    "Sampling schemes and band limits": (
        "scheme-", "covering-", "band-limit", "slice-", "power-", "weighted-", "conchoid-",
    ),
    "More": ("",),
}  # fmt: skip
THESIS = {"table": "Tables of the thesis, ours beside them", "figure": "Figures of the thesis, made again"}
REAL = "Pictures of each real joint"


def load_jobs(path: Path) -> list[Job]:
    """All jobs: tables and figures of the thesis by their numbers, then the others in the order of the graph."""
    return sorted(jobs.load(path), key=place)


def place(job: Job) -> tuple:
    """The thesis' tables, then its figures, by number; then all others."""
    thesis = re.fullmatch(r"(table|figure)-(\d+).*", job.name)
    return (0, thesis[1] == "figure", int(thesis[2]), job.name) if thesis else (1,)


def repeats(job: Job, names: set[str]) -> bool:
    """Whether it shows one more real joint in a figure that the page has anyway."""
    base, _, joint = job.name.rpartition("-")
    again = base in names if re.fullmatch(r"figure-\d+", base) else base == "joint" and joint != "generated"
    return again and f"scene-{joint}" in names


def topic(job: Job, names: set[str]) -> str:
    """The part of the page that it belongs to."""
    if repeats(job, names):
        return REAL
    thesis = re.match(r"(table|figure)-\d|thesis-", job.name)
    return THESIS[thesis[1] or "figure"] if thesis else next(title for title, begins in TOPICS.items() if job.name.startswith(begins))


def by_topic(jobs: list[Job]) -> dict[str, list[Job]]:
    """The tables and figures of each part that has any; beyond the thesis the figures come first."""
    names = {job.name for job in jobs}
    parts: dict[str, list[Job]] = {title: [] for title in (*THESIS.values(), *TOPICS, REAL)}
    for job in sorted(jobs, key=lambda job: place(job) == (1,) and job.kind == "table"):
        if job.kind in ("table", "figure") and job.name != "findings":  # which has a part of its own
            parts[topic(job, names)].append(job)
    return {title: found for title, found in parts.items() if found}


def heading(job: Job) -> str:
    """What it shows: "Table 9: Time to test one pose by RSID and USID", or the question that it answers."""
    words = re.sub(r" \((Table|Figure) \d+[^()]*\)(?=[.?]?$)", "", job.question).removesuffix(".")
    thesis = re.match(r"(table|figure)-(\d+)", job.name)
    return f"{thesis[1].capitalize()} {thesis[2]}: {words}" if thesis else words


def title_of(name: str) -> str:
    """What a reader calls where a verdict belongs: "Table 9", "Section 3.5.2"."""
    words = name.replace("-", " ").replace("_", " ")
    return words[0].upper() + words[1:]


def row_label(name: str) -> str:
    """What a reader calls a row of a table of the thesis: "0.5°", and not "0.5deg"."""
    return re.sub(r"^([\d.]+)deg$", r"\1°", name).replace("_", " ")
