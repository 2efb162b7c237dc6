# SPDX-License-Identifier: GPL-3.0-or-later
"""What the graph says of the tables and figures that the report shows, in the order in which it shows them."""

from __future__ import annotations

import re
from pathlib import Path

from common import jobs
from common.jobs import Job


def load_jobs(path: Path) -> list[Job]:
    """All jobs: tables and figures of the thesis by their numbers, then the others in the order of the graph."""
    return sorted(jobs.load(path), key=place)


def place(job: Job) -> tuple:
    """The thesis' tables, then its figures, by number; then all others."""
    thesis = re.fullmatch(r"(table|figure)-(\d+).*", job.name)
    return (0, thesis[1] == "figure", int(thesis[2]), job.name) if thesis else (1,)


def title_of(name: str) -> str:
    """What a reader calls a table or figure: "Table 9: queries", "Figure 36: cargen left", "Error against time"."""
    words = re.sub(r"^(table|figure)-(\d+)-", r"\1 \2: ", name).replace("-", " ").replace("_", " ")
    return words[0].upper() + words[1:]


def row_label(name: str) -> str:
    """What a reader calls a row of a table of the thesis: "0.5°", and not "0.5deg"."""
    return re.sub(r"^([\d.]+)deg$", r"\1°", name).replace("_", " ")
