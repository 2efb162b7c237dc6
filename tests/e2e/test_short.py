# SPDX-License-Identifier: GPL-3.0-or-later
"""A first look at experiments/reproduce, in a minute: one table and one figure. test_reproduce.py has the whole run."""

from __future__ import annotations

import csv
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


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
        (self.results / "tables" / "table-2.csv").unlink()
        self.assertIn("table-2.csv is not there yet", self.reproduce("--why", "table-2"))

    def test_b_figure_is_made(self):
        self.reproduce("--only", "figure-50")
        self.assertGreater((self.results / "figures" / "figure-50.png").stat().st_size, 10000)


if __name__ == "__main__":
    unittest.main(verbosity=2)
