# SPDX-License-Identifier: GPL-3.0-or-later
"""The jobs of the graph of results, as experiments/graph.py writes them into graph/jobs.json. Standard library only."""

import json
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Job:
    """One node of the graph."""

    name: str
    kind: str  # data, table, figure, verdicts, text, page, report or paper
    question: str  # that it answers; the caption of a table or figure
    script: str  # the file that one edits to change what it makes
    outputs: list[str]  # in the results folder
    depends: list[str]  # outputs of other jobs, programs/NAME, files of the project, or absolute
    command: list[str]  # runs in a fresh folder laid out as the results folder, and writes there
    budget: list[float]  # seconds that it may take on two cores, in the quick and the full profile
    timing: bool = False  # it has the machine to itself
    seconds: float = 0.0  # expected

    @property
    def artefacts(self) -> list[str]:
        """What a reader calls the outputs: the tables of an experiment, or the job's own name."""
        return csv_names(self.outputs) or [self.name]

    @property
    def data(self) -> list[str]:
        """Names of the CSVs from which the job is made."""
        return csv_names(self.depends)


def csv_names(files: list[str]) -> list[str]:
    """NAME of each data/NAME.csv."""
    return [Path(file).stem for file in files if file.startswith("data/") and file.endswith(".csv")]


def load(path: Path) -> list[Job]:
    """All jobs, in the order in which they are declared."""
    return [Job(**fields) for fields in json.loads(path.read_text())["jobs"]]
