# SPDX-License-Identifier: GPL-3.0-or-later
"""The graph of results, as CMake writes it into graph/jobs.json. Standard library only."""

import json
from dataclasses import dataclass
from pathlib import Path

EXPERIMENTS = Path(__file__).resolve().parents[2] / "experiments"


@dataclass(frozen=True)
class Job:
    """One node of the graph."""

    name: str
    kind: str  # see experiments/graph.cmake
    budget: list[float]  # seconds that it may take in the quick and the full profile
    timing: bool  # it has the machine to itself
    artefacts: list[str]
    outputs: list[str]
    depends: list[str]
    command: list[str]
    question: str
    seconds: float = 0.0  # expected

    @property
    def data(self) -> list[str]:
        """Names of the CSVs that it is made from."""
        return [Path(file).stem for file in self.depends if file.startswith("data/") and file.endswith(".csv")]

    @property
    def script(self) -> str:
        """The file that one edits to change what it makes."""
        for word in self.command:
            if word.startswith(("analysis/", "paper/")):
                return word
        name = Path(self.command[0]).stem
        return f"experiments/{name}/main.cpp" if (EXPERIMENTS / name).is_dir() else f"experiments/{name}.cpp"


def load(path: Path) -> list[Job]:
    """All jobs, in the order in which they are declared."""
    return [Job(**fields) for fields in json.loads(path.read_text())]
