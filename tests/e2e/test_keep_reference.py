# SPDX-License-Identifier: GPL-3.0-or-later
"""experiments/keep_reference.py on a small made-up run: what it keeps, and every run that is no reference."""

from __future__ import annotations

import collections
import csv
import hashlib
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "analysis" / "common"))
sys.path.insert(0, str(ROOT / "experiments"))
import compare  # noqa: E402
from tally import NOT_COUNTED  # noqa: E402

RECORD = {
    "profile": "full",
    "commit": "0123456789abcdef",
    "dirty": False,
    "cpu": "a CPU",
    "cores": 2,
    "memory_mib": 1024,
    "system": "Linux",
    "compiler": "GNU 12",
    "flags": "-O3",
    "started_utc": "2026-01-02T00:00:00Z",
}


class KeepReference(unittest.TestCase):
    """A run of two experiments and two tables."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        root = Path(self.folder.name)
        self.results, self.build, self.reference = root / "results", root / "build", root / "reference"
        for folder in (self.results / "data", self.results / "tables", self.build / "graph", self.reference):
            folder.mkdir(parents=True)
        self.graph("full")
        self.data("a")
        self.data("b", started_utc="2026-01-01T00:00:00Z")
        (self.results / "tables" / "a.csv").write_text("x\n1\n")
        (self.results / "tables" / "a.json").write_text("{}")
        (self.results / "tables" / "a.tex").write_text("1")
        with (ROOT / "analysis" / "common" / "thesis_values.csv").open(newline="") as file:
            names = [[row["artefact"], row["row"], row["column"]] for row in csv.DictReader(file)]
        rows = [[*name, "any", "differs" if k == 1 else "reproduced", "computed"] for k, name in enumerate(names)]
        rows[0][3:] = ["not counted: the same number as elsewhere", "differs", "computed"]
        rows[2][4:] = ["inconclusive", "measured"]
        rows[3][4] = "input"
        self.counted = len(rows) - 1
        self.verdicts([["artefact", "row", "column", "rule", "verdict", "kind"], *rows])

    def tearDown(self):
        self.folder.cleanup()

    def graph(self, profile: str, results: Path | str = ""):
        """The graph of a run."""
        made = ["data/a.csv data/a.json", "data/b.csv data/b.json", "tables/a.csv tables/a.json tables/a.tex", "verdicts.csv"]
        job = dict.fromkeys("name kind question script depends command budget".split())
        jobs = [{**job, "outputs": files.split()} for files in made]
        record = {"results": str(results or self.results), "profile": profile, "jobs": jobs}
        (self.build / "graph" / "jobs.json").write_text(json.dumps(record))

    def data(self, name: str, **changes: object):
        """A CSV with its sidecar."""
        table = self.results / "data" / f"{name}.csv"
        table.write_text(f"{name}\n1\n")
        digest = hashlib.sha256(table.read_bytes()).hexdigest()
        table.with_suffix(".json").write_text(json.dumps({**RECORD, "csv_sha256": digest, **changes}))

    def verdicts(self, rows: list[list[str]]):
        """verdicts.csv with these rows."""
        with (self.results / "verdicts.csv").open("w", newline="") as file:
            csv.writer(file).writerows(rows)

    def keep(self) -> subprocess.CompletedProcess:
        """Runs it."""
        folders = ["--results", self.results, "--build", self.build, "--reference", self.reference]
        command = [sys.executable, "-B", ROOT / "experiments" / "keep_reference.py", *folders]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def assert_refused(self, *words: str):
        """One line with these words, and nothing written."""
        done = self.keep()
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertEqual(list(self.reference.rglob("*")), [])

    def test_kept(self):
        """Verdicts, tables and where they come from; a table of an older run goes, a picture stays."""
        (self.reference / "tables").mkdir()
        (self.reference / "tables" / "older.csv").write_text("x\n")
        (self.reference / "joint.png").write_text("a picture")
        done = self.keep()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"{self.counted - 2} computed ({self.counted - 3} reproduced, 1 differs), 1 measured (1 inconclusive), 1 given", done.stdout)
        kept = {str(file.relative_to(self.reference)) for file in self.reference.rglob("*") if file.is_file()}
        self.assertEqual(kept, {"verdicts.csv", "tables/a.csv", "tables/a.json", "run.json", "joint.png"})
        for name in ("verdicts.csv", "tables/a.csv"):
            self.assertEqual((self.reference / name).read_bytes(), (self.results / name).read_bytes())
        run = json.loads((self.reference / "run.json").read_text())
        self.assertEqual((run["commit"], run["started_utc"]), (RECORD["commit"], "2026-01-01T00:00:00Z"))

    def test_run_before(self):
        """Of another day: its verdicts, findings and record stay in earlier/DAY. Of the same day they do not."""
        before = {"verdicts.csv": "older\n", "tables/findings.csv": "older findings\n", "run.json": json.dumps({"started_utc": "2025-12-31T09:00:00Z"})}
        (self.reference / "tables").mkdir()
        for name, text in before.items():
            (self.reference / name).write_text(text)
        for _ in range(2):
            self.assertEqual(self.keep().returncode, 0)
            kept = {file.name: file.read_text() for file in (self.reference / "earlier" / "2025-12-31").iterdir()}
            self.assertEqual(kept, {Path(name).name: text for name, text in before.items()})

    def test_other_profile(self):
        self.graph("quick")
        self.assert_refused("quick profile", "experiments/reproduce --full")
        self.graph("full")
        self.data("b", profile="quick")
        self.assert_refused("b.csv", "quick profile")

    def test_not_one_clean_commit(self):
        self.data("b", dirty=True)
        self.assert_refused("b.csv", "uncommitted")
        self.data("b", commit="fedcba9876543210")
        self.assert_refused("b.csv", "fedcba987654", "0123456789ab")

    def test_incomplete(self):
        (self.results / "tables" / "a.tex").unlink()
        self.assert_refused("tables/a.tex is not there")
        (self.results / "tables" / "a.csv").unlink()
        self.assert_refused("tables/a.csv and 1 more are not there")

    def test_verdict_missing(self):
        lines = (self.results / "verdicts.csv").read_text().splitlines(keepends=True)
        (self.results / "verdicts.csv").write_text("".join(lines[:-1]))
        self.assert_refused("no verdict on", lines[-1].split(",")[0])

    def test_not_vouched_for(self):
        (self.results / "data" / "b.csv").write_text("b\n2\n")
        self.assert_refused("b.csv", "vouches")
        (self.results / "data" / "b.json").write_text("[]")
        self.assert_refused("b.csv", "sidecar")
        self.data("b")
        record = json.loads((self.results / "data" / "b.json").read_text())
        del record["cpu"]
        (self.results / "data" / "b.json").write_text(json.dumps(record))
        self.assert_refused("b.json lacks cpu")

    def test_another_build_folder(self):
        self.graph("full", "/elsewhere")
        self.assert_refused("/elsewhere", "--build")
        (self.build / "graph" / "jobs.json").unlink()
        self.assert_refused(str(self.build), "--build")


def readme() -> str:
    """Of the project, its lines joined."""
    return " ".join((ROOT / "README.md").read_text().split())


class Kept(unittest.TestCase):
    """The run that is kept, and what the project's README says of it."""

    def test_counts_of_the_readme(self):
        with (ROOT / "results" / "reference" / "verdicts.csv").open(newline="") as file:
            found = collections.Counter(row["verdict"] for row in csv.DictReader(file) if not row["rule"].startswith(NOT_COUNTED))
        counts = [found[verdict] for verdict in ("reproduced", "differs", "thesis-misprint", "inconclusive")]
        said = r"of the (\d+) numbers [^.]*? could compare, (\d+) are reproduced, (\d+) differ, (\d+) are misprints and (\d+) are inconclusive"
        words = re.search(said, readme())
        self.assertEqual([int(word) for word in words.groups()], [sum(counts), *counts])

    def test_earlier_runs_agree(self):
        """No measured number that is reproduced in one full run differs in another, by the same rule. (What follows from formulas hangs on no machine.)"""
        kept = compare.Run(ROOT / "results" / "reference")
        kept.verdicts = {key: row for key, row in kept.verdicts.items() if row["kind"] == "measured"}
        self.assertGreater(len(kept.verdicts), 50)
        for folder in sorted((kept.folder / "earlier").iterdir()):
            changed = compare.changed_verdicts(compare.Run(folder), kept)
            self.assertEqual([line for line in changed if re.search("reproduced -> differs|differs -> reproduced", line)], [], folder.name)

    def test_cohort_of_the_readme(self):
        """Internal rotation of hips that stand for controls, above that of the published ones."""
        with (ROOT / "results" / "reference" / "cohort" / "comparison.csv").open(newline="") as file:
            table = {row["statistic"]: row for row in csv.DictReader(file)}
        controls = table["internal rotation at 90, controls"]
        above = float(controls["ours"]) - float(controls["published"])
        self.assertIn(f"internal rotation at 90 degrees of flexion is {above:.0f} degrees above that measured in ten controls", readme())


if __name__ == "__main__":
    unittest.main()
