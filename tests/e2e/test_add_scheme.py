# SPDX-License-Identifier: GPL-3.0-or-later
"""Adding a sampling scheme or a method is adding one file: nothing else changes, and it is in the data, plots and tables.

A copy of the project's sources gets tests/data/example_scheme.hpp and example_method.cpp, builds and runs the experiments
on schemes, that on detection and, by tests/check_scheme, what is tested of every scheme, and makes plots and the paper's
tables.
"""

from __future__ import annotations

import csv
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "tests" / "data" / "example_scheme.hpp"
METHOD = ROOT / "tests" / "data" / "example_method.cpp"
NAME = "example_scheme"
LABEL = "Example scheme"
GENERATED = {"build", ".git", "__pycache__"}
DRIVERS = ["01_memory", "08_schemes", "08_scheme_savings", "09_lookup_time", "03_detection_time"]


def run(*words: str | Path, cwd: Path | None = None) -> str:
    """What the command prints; a failure shows its end."""
    cached = {**os.environ, "CCACHE_BASEDIR": str(cwd)} if cwd else None  # paths below the copy are relative to it
    done = subprocess.run([str(word) for word in words], cwd=cwd, env=cached, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{words}\n{done.stdout[-4000:]}\n{done.stderr[-4000:]}")
    return done.stdout


def copy_sources(to: Path) -> None:
    """All that is not generated."""

    def generated(folder: str, names: list[str]) -> set[str]:
        made = set(names) - {"README.md"} if Path(folder) == ROOT / "results" else set()
        return made | GENERATED & set(names)

    shutil.copytree(ROOT, to, ignore=generated)


def rows(path: Path) -> list[dict[str, str]]:
    """The lines of a CSV."""
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


class AddScheme(unittest.TestCase):
    """One copy and build for all tests."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="impinge-add-scheme-")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.project = Path(cls.folder.name) / "project"
        cls.results = Path(cls.folder.name) / "results"
        cls.build = cls.project / "build" / "release"
        copy_sources(cls.project)
        shutil.copy(EXAMPLE, cls.project / "libcore" / "sphere" / "schemes")
        shutil.copy(METHOD, cls.project / "experiments" / "methods")
        run("cmake", "--preset", "release", cwd=cls.project)
        run("cmake", "--build", cls.build, "--target", *DRIVERS, cwd=cls.project)
        for driver in DRIVERS:
            run(cls.build / "experiments" / driver, "--out", cls.results / "data", "--profile", "quick")

    def script(self, name: str) -> None:
        """Makes a table or figure as the graph does."""
        script = self.project / "analysis" / f"{name}.py"
        path = f"PYTHONPATH={self.project / 'analysis'}"
        run("env", path, sys.executable, "-B", script, "--results", self.results, "--out", self.results)

    def test_properties_hold(self):
        """All tests that hold for every scheme pass."""
        output = run(self.project / "tests" / "check_scheme", NAME, cwd=self.project)
        passed = [int(count) for count in re.findall(r"\[  PASSED  \] (\d+) tests", output)]
        self.assertEqual(len(passed), 2, output[-2000:])
        self.assertGreater(min(passed), 12)
        listed = (self.build / "libcore/sphere/generated/sphere/scheme_list.hpp").read_text()
        self.assertIn("ExampleScheme", listed)

    def test_in_the_data(self):
        """Once in schemes.csv with what it says of itself, once a precision in lut_memory.csv."""
        own = [row for row in rows(self.results / "data" / "schemes.csv") if row["scheme"] == NAME]
        self.assertEqual(len(own), 1)
        self.assertEqual(own[0]["label"], LABEL)
        self.assertEqual(own[0]["citation"], "thesis, Section 3.1")
        self.assertAlmostEqual(float(own[0]["covering_constant"]), 9.87, delta=0.1)
        memory = [row for row in rows(self.results / "data" / "lut_memory.csv") if row["scheme"] == NAME]
        self.assertEqual([int(row["entries"]) for row in memory if row["precision_deg"] == "1"], [64442])
        sidecar = json.loads((self.results / "data" / "schemes.json").read_text())
        self.assertIn("csv_sha256", sidecar)

    def test_in_the_plot(self):
        """By its label; text of the PDFs is text."""
        self.script("figures/covering_cost")
        text = run("pdftotext", self.results / "figures" / "covering-cost.pdf", "-")
        self.assertIn(LABEL, " ".join(text.split()))
        for kind in ("svg", "png"):
            self.assertGreater((self.results / "figures" / f"covering-cost.{kind}").stat().st_size, 0)

    def test_in_the_table_of_the_paper(self):
        """tables/scheme-comparison.tex is what the paper shows."""
        self.script("tables/schemes")
        self.assertIn(LABEL, (self.results / "tables" / "scheme-comparison.tex").read_text())
        labels = [row["label"] for row in rows(self.results / "tables" / "scheme-comparison.csv")]
        self.assertEqual(labels.count(LABEL), 1)

    def test_method_in_the_benchmark(self):
        """A method that was dropped in is timed on every joint, and tabled by its label."""
        own = [row for row in rows(self.results / "data" / "detection_time.csv") if row["method"] == "example_method"]
        timed = [(row["joint"], row["triangles"]) for row in own]
        pairs = [("generated", level) for level in ("300", "1000", "3000", "12000")]
        self.assertEqual(timed[:4], pairs)
        self.assertEqual([level for joint, level in timed[4:] if joint != "generated"], ["12000"])  # in the patient's place
        self.script("tables/query_time")
        self.assertIn("Example method", (self.results / "tables" / "table-9-queries.tex").read_text())


if __name__ == "__main__":
    unittest.main(verbosity=2)
