# SPDX-License-Identifier: GPL-3.0-or-later
"""What the graph says of the tables and figures that the report shows, in the order in which it shows them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Job:
    """What the graph says of one table or figure."""

    name: str
    kind: str
    outputs: list[str]
    data: list[str]  # names of the CSVs that it is made from
    script: str
    question: str


def load_jobs(path: Path) -> list[Job]:
    """Tables and figures: those of the thesis by their numbers, then the others in the order of the graph."""
    jobs = []
    for line in path.read_text().splitlines():
        name, kind, _, _, _, _, outputs, depends, command, question = line.split("\t")
        data = [
            Path(file).stem
            for file in depends.split(";")
            if file.startswith("data/") and file.endswith(".csv")
        ]
        script = next((word for word in command.split() if word.endswith(".py")), "")
        jobs.append(Job(name, kind, outputs.split(";"), data, script, question))
    return sorted(jobs, key=place)


def place(job: Job) -> tuple:
    """The thesis' tables, then its figures, by number; then all others."""
    thesis = re.fullmatch(r"(table|figure)-(\d+).*", job.name)
    return (0, thesis[1] == "figure", int(thesis[2])) if thesis else (1,)


def title_of(name: str) -> str:
    """What a reader calls a table or figure: "Table 9: queries", "Figure 36: cargen left", "Error against time"."""
    words = re.sub(r"^(table|figure)-(\d+)-", r"\1 \2: ", name).replace("-", " ").replace("_", " ")
    return words[0].upper() + words[1:]
