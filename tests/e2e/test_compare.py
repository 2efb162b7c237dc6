# SPDX-License-Identifier: GPL-3.0-or-later
"""experiments/compare.py on small made-up runs: every kind of change it must name, and those it must not."""

import csv
import hashlib
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

COMPARE = Path(__file__).resolve().parents[2] / "experiments" / "compare.py"
RECORD = {"commit": "abc", "dirty": False, "profile": "quick", "compiler": "GNU 12", "flags": "-O3", "cpu": "a CPU",
          "cores": 2, "system": "Linux"}
TIMES = [("method", ""), ("median_ms", "ms"), ("iqr_ms", "ms")]
ERRORS = [("method", ""), ("max_over_um", "um"), ("max_under_um", "um"), ("bound_um", "um"), ("build_ms", "ms")]


class Compare(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.runs = [Path(folder.name) / name for name in ("one", "two")]
        for run in self.runs:
            self.verdicts(run, "reproduced", "1.5")
            self.data(run, "sampling_time", TIMES, [["a", 10, 1], ["b", 4, 0.2]], timing={"rounds": 9})
            self.data(run, "error_against_time", ERRORS, [["a", 1, 2, 3, 5], ["b", 1, 2, "", 7]])
            self.data(run, "error_against_time_spread", [("method", ""), ("build_iqr_ms", "ms")], [["a", 1], ["b", 1]])

    def verdicts(self, run: Path, verdict: str, measured: str, rule: str = "within 10 %"):
        (run / "data").mkdir(parents=True, exist_ok=True)
        (run / "verdicts.csv").write_text(f"artefact,row,column,measured,rule,verdict\ntable-5,x,y,{measured},{rule},{verdict}\n")

    def data(self, run: Path, name: str, columns: list[tuple[str, str]], rows: list[list], **record):
        table = run / "data" / f"{name}.csv"
        with table.open("w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([[column for column, _ in columns], *rows])
        record = {**RECORD, "columns": [{"name": column, "unit": unit} for column, unit in columns], **record,
                  "csv_sha256": hashlib.sha256(table.read_bytes()).hexdigest()}
        table.with_suffix(".json").write_text(json.dumps(record))

    def compare(self, *words: str) -> subprocess.CompletedProcess:
        return subprocess.run([sys.executable, "-B", COMPARE, *self.runs, *words], capture_output=True, text=True, check=False)

    def test_a_run_and_itself(self):
        found = self.compare()
        self.assertEqual((found.returncode, found.stderr), (0, ""))
        self.assertIn("commit: abc\n", found.stdout)
        self.assertIn("verdicts that changed: none\n", found.stdout)
        self.assertIn("error_against_time.csv build_ms: 1 in the geometric mean of 2, from 1 to 1, spread 0.28 in", found.stdout)
        self.assertIn("sampling_time.csv median_ms: 1 in the geometric mean of 2, from 1 to 1, spread 0.14 in the median; "
                      "0 beyond their spread", found.stdout)

    def test_an_answer_beside_times(self):
        for run, wrong in zip(self.runs, (0, 99)):
            self.data(run, "contact", [("method", ""), ("wrong", "1"), ("rounds", "1"), ("us_pose", "us")], [["a", wrong, 3 + wrong, 5]], timing={"rounds": 9})
        found = self.compare()
        self.assertEqual(found.returncode, 1)
        self.assertIn("columns whose numbers differ: 1\n  contact.csv wrong: 1 of 1", found.stdout)

    def test_a_verdict(self):
        self.verdicts(self.runs[1], "differs", "1.9")
        found = self.compare()
        self.assertEqual(found.returncode, 1)
        self.assertIn("verdicts that changed: 1\n  table-5, x, y: reproduced -> differs (1.5 -> 1.9)\n", found.stdout)

    def test_a_verdict_by_another_rule(self):
        self.verdicts(self.runs[1], "differs", "1.9", "within 1 %")
        self.assertIn("verdicts that changed: none\n", self.compare().stdout)

    def test_a_finding(self):
        """Of the run kept before, findings.csv is beside its verdicts."""
        head = "where,claim,verdict\nSection 1,It is so.,"
        (self.runs[0] / "findings.csv").write_text(head + "holds\nSection 2,Other words.,holds\n")
        (self.runs[1] / "tables").mkdir()
        (self.runs[1] / "tables" / "findings.csv").write_text(head + "wrong\nSection 2,Words.,wrong\n")
        found = self.compare()
        self.assertEqual(found.returncode, 1)
        self.assertIn("findings that changed: 1\n  Section 1, It is so.: holds -> wrong\n", found.stdout)

    def test_times_and_their_spread_change_no_result(self):
        """Twice the time is beyond a spread of 14 %, five per cent more is not."""
        self.data(self.runs[1], "sampling_time", TIMES, [["a", 20, 2], ["b", 4.2, 0.21]], timing={"rounds": 9}, cpu="another CPU")
        found = self.compare()
        self.assertEqual(found.returncode, 0)
        self.assertIn("cpu: a CPU -> a CPU and another CPU\n", found.stdout)
        self.assertIn("median_ms: 1.45 in the geometric mean of 2, from 1.05 to 2, spread 0.14 in the median; 1 beyond", found.stdout)

    def test_an_error_above_its_bound_in_either(self):
        self.data(self.runs[0], "error_against_time", ERRORS, [["a", 1, 3.5, 3, 5], ["b", 1, 2, "", 7]])
        found = self.compare()
        self.assertEqual(found.returncode, 1)
        self.assertIn("errors above their proven bounds: 1\n  first, error_against_time.csv, line 2: max_under_um 3.5 > bound_um 3\n",
                      found.stdout)
        self.assertIn("error_against_time.csv max_under_um: 1 of 2, by 42.9 % at most\n", found.stdout)

    def test_rows_of_another_run_are_not_compared(self):
        self.data(self.runs[1], "sampling_time", TIMES, [["a", 20, 2], ["c", 4.2, 0.21]])
        self.data(self.runs[1], "more", TIMES, [])
        found = self.compare()
        self.assertEqual(found.returncode, 1)
        self.assertIn("  more.csv is in the second alone\n  sampling_time.csv has other rows\n", found.stdout)

    def test_folders_that_are_no_runs(self):
        table = self.runs[0] / "data" / "sampling_time.csv"
        table.write_text(table.read_text().replace("10", "11"))
        found = self.compare()
        self.assertEqual((found.returncode, found.stdout), (2, ""))
        self.assertRegex(found.stderr, r"^compare: error: .*sampling_time.csv does not have the bytes that .* again\n$")
        self.runs[0] = self.runs[0].parent
        found = self.compare()
        self.assertEqual(found.stderr, f"compare: error: {self.runs[0]} is no result folder: it has no verdicts.csv and no data/*.csv\n")


if __name__ == "__main__":
    unittest.main()
