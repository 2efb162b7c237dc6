# SPDX-License-Identifier: GPL-3.0-or-later
"""A first look at experiments/reproduce, in a minute: one table and one figure, and the report while it is not finished.
test_reproduce.py has the whole run.
"""

from __future__ import annotations

import csv
import json
import os
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("IMPINGE_BUILD_DIR", ROOT / "build" / "release"))


class Short(unittest.TestCase):
    """One results folder; tests in alphabetical order."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="impinge-short-")
        cls.addClassCleanup(folder.cleanup)
        cls.results = Path(folder.name)

    def reproduce(self, *options: str) -> str:
        """What it prints; it ends well."""
        words = [ROOT / "experiments" / "reproduce", "--results", self.results, *options]
        done = subprocess.run(words, cwd="/", capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_a_table_is_made_once(self):
        """With the numbers of the thesis; the second run does nothing within five seconds."""
        self.assertIn("made     ", self.reproduce("--only", "table-2"))
        with (self.results / "data" / "lut_memory.csv").open(newline="") as file:
            found = {(row["scheme"], row["precision_deg"]): row["entries"] for row in csv.DictReader(file)}
        self.assertEqual(found["rsid", "1"], "65160")
        begin = time.monotonic()
        self.assertIn("nothing to do", self.reproduce("--quick", "--only", "table-2"))
        self.assertLess(time.monotonic() - begin, 5)
        self.assertIn("up to date", self.reproduce("--why", "table-2"))
        self.assertIn("would be made again", self.reproduce("--why", "error-against-time"))

    def test_b_figure_is_made(self):
        self.reproduce("--only", "figure-50")
        self.assertGreater((self.results / "figures" / "figure-50.png").stat().st_size, 10000)

    def test_c_report_says_what_is_not_made(self):
        """It shows the table, and asks to be read again."""
        jobs = {job["name"]: job for job in json.loads((BUILD / "graph" / "jobs.json").read_text())}
        subprocess.run([*jobs["report"]["command"], "--out", self.results], cwd=ROOT, check=True)
        page = (self.results / "report.html").read_text()
        self.assertRegex(page[:1000], 'http-equiv="refresh"')
        self.assertRegex(page, "Not finished: 2 of [0-9]+ tables and figures are made")
        for name, made in (("table-2", True), ("figure-50", True), ("table-3", False), ("verdicts-title", False)):
            after = page.split(f'id="{name}">', 1)[1][:200]
            self.assertEqual("Not made yet." not in after, made, name)

    def test_d_the_report_that_is_not_finished_is_none(self):
        """The next run makes it."""
        self.assertIn("report", self.reproduce("--list"))
        code = (
            "import sys, pathlib, run_graph as r; b, p = map(pathlib.Path, sys.argv[1:]); "
            "d = r.Draft(b, p, r.load_jobs(b, 'quick')['report']); print(d.wanted, d.write() > 0, d.page.is_file())"
        )
        words = ["/usr/bin/python3", "-B", "-c", code, BUILD, self.results]
        done = subprocess.run(words, cwd=ROOT / "experiments", capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.split(), ["True"] * 3)
        (self.results / "report.html").write_text("<html>finished</html>")
        done = subprocess.run(words, cwd=ROOT / "experiments", capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.split()[0], "False")

    def test_budgets_sum_to_ten_minutes(self):
        """Of the run that a newcomer begins: no real joints, two cores, timings alone."""
        jobs = json.loads((BUILD / "graph" / "jobs.json").read_text())
        alone = sum(job["budget"][0] for job in jobs if job["timing"])
        beside = sum(job["budget"][0] for job in jobs if not job["timing"])
        longest = sorted(jobs, key=lambda job: -job["budget"][0])[:5]
        said = ", ".join(f"{job['name']} {job['budget'][0]}" for job in longest)
        self.assertLessEqual(alone + beside / 2, 600, f"shorten one, and its @seconds: {said}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
