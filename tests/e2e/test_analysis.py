# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules of the analysis on small made-up data: loading, rounding, refusal, verdicts, the reference run."""

from __future__ import annotations

import hashlib
import itertools
import json
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "analysis"))

import numpy as np  # noqa: E402
import pandas as pd  # noqa: E402

import common  # noqa: E402
from common import drawing, measured, pareto, ranges, tally, timing, work_precision  # noqa: E402
from findings import finding  # noqa: E402
from report import data_table, judged, markup, reference  # noqa: E402
from verdicts import conchoid as verdicts_conchoid, memory as verdicts_memory  # noqa: E402
from verdicts import timing as verdicts_timing, verdict  # noqa: E402


class Palette(unittest.TestCase):
    """Every colour has a contrast of 3 : 1 on white (WCAG 2.1), and a method keeps its look whatever is beside it."""

    def contrast(self, colour: str) -> float:
        """Of the colour on white."""
        parts = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
        linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
        return 1.05 / (0.05 + float(np.dot([0.2126, 0.7152, 0.0722], linear)))

    def test_contrast(self):
        for colour in [*common.COLOURS, *(look[0] for look in drawing.METHODS.values())]:
            self.assertGreaterEqual(self.contrast(colour), 3.0, colour)

    def test_look(self):
        alone = common.look(["Embree"])["Embree"]
        self.assertEqual(common.look(["a", "CGAL", "Embree"])["Embree"], alone)
        self.assertEqual(common.look(["embree_ray8"])["embree_ray8"], alone)


class Paying(unittest.TestCase):
    """A table that takes 10 ms more to build and 0.1 ms less a pose pays from 100 poses on."""

    def test_pays_from(self):
        tree = pd.Series({"build_ms": 5.0, "pose_us": 300.0})
        for build, pose, poses in ((15.0, 200.0, 100), (15.0, 300.0, np.inf), (4.0, 200.0, 1), (15.0, 400.0, np.inf), (4.0, 400.0, np.inf)):
            self.assertEqual(work_precision.pays_from(pd.Series({"build_ms": build, "pose_us": pose}), tree), poses)


class Loading(unittest.TestCase):
    """A CSV counts only with the sidecar that has its hash."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.results = Path(self.folder.name)
        (self.results / "data").mkdir()
        self.csv = self.results / "data" / "x.csv"
        self.csv.write_text("a,flag\n0.1,yes\n")
        self.vouch()

    def tearDown(self):
        self.folder.cleanup()

    def vouch(self):
        """Writes the sidecar for the bytes as they are."""
        digest = hashlib.sha256(self.csv.read_bytes()).hexdigest()
        self.csv.with_suffix(".json").write_text(json.dumps({"csv_sha256": digest, "seed": 1}))

    def test_good(self):
        table = common.load(self.results, "x")
        self.assertEqual(table.a[0], 0.1)
        self.assertTrue(table.flag[0])
        self.assertEqual(table.attrs["seed"], 1)

    def test_refused(self):
        self.csv.write_text("a,flag\n0.2,yes\n")
        with self.assertRaisesRegex(common.Refused, "x.csv"):
            common.load(self.results, "x")
        self.csv.with_suffix(".json").write_text("[]")
        with self.assertRaisesRegex(common.Refused, "x.json"):
            common.load(self.results, "x")
        self.csv.with_suffix(".json").unlink()
        with self.assertRaisesRegex(common.Refused, "no sidecar"):
            common.load(self.results, "x")
        self.csv.unlink()
        with self.assertRaisesRegex(common.Refused, "not there"):
            common.load(self.results, "x")


class Measured(unittest.TestCase):
    """Two CSVs of one run as one table, and what its rows are called."""

    def test_joined(self):
        """By their keys, in the first one's order; of different runs they are refused."""

        def write(results: Path, name: str, text: str):
            csv = results / "data" / f"{name}.csv"
            csv.write_text(text)
            digest = hashlib.sha256(csv.read_bytes()).hexdigest()
            csv.with_suffix(".json").write_text(json.dumps({"csv_sha256": digest, "name": name}))

        with tempfile.TemporaryDirectory() as folder:
            results = Path(folder)
            (results / "data").mkdir()
            write(results, "main", "k,x\nb,1\na,2\n")
            write(results, "more", "k,y\na,3\nb,4\n")
            table = measured.joined(results, "main", "more", ["k"])
            self.assertEqual((list(table.k), list(table.x), list(table.y)), (["b", "a"], [1, 2], [4, 3]))
            self.assertEqual(table.attrs["name"], "main")
            write(results, "more", "k,y\na,3\nc,4\n")
            with self.assertRaisesRegex(common.Refused, "main.csv and more.csv"):
                measured.joined(results, "main", "more", ["k"])

    def test_lines(self):
        """A method's title or own name, and its storage where it has one."""
        table = pd.DataFrame({"method": ["m", "n", "m"], "storage": ["uint16", "none", "double"]})
        self.assertEqual(list(measured.lines(table, {"m": "M"})), ["M, 16 bits", "n", "M, double"])
        without = measured.lines(table, {"m": "M"}, stored=table.storage != "double")
        self.assertEqual(list(without), ["M, 16 bits", "n", "M"])


class Findings(unittest.TestCase):
    """The verdict on a statement follows from what was computed."""

    def test_verdict(self):
        line = finding.finding("3.2", "One is two.", "1 is 1.", "data: column", holds=1 == 2)
        self.assertEqual((line["verdict"], line["where"], line["source"]), ("wrong", "Section 3.2", ""))
        self.assertEqual(
            finding.finding("Eq. 7", "", "", "", holds=True, otherwise="misprint")["verdict"], "holds"
        )
        self.assertEqual(
            finding.finding("Eq. 7", "", "", "", holds=False, otherwise="misprint")["verdict"], "misprint"
        )
        with self.assertRaises(KeyError):  # nobody forgets the condition
            finding.finding("Eq. 7", "", "", "")
        with self.assertRaises(ValueError):
            finding.finding("Eq. 7", "", "", "", holds=False, otherwise="bad")
        for low, high, found in ((1, 2, "holds"), (1, 4, "inconclusive"), (4, 5, "misprint")):  # a part settles nothing
            value = ranges.Range(low, high)
            line = finding.finding("Eq. 7", "", "", "", value=value, within=(0, 3), otherwise="misprint")
            self.assertEqual((line["verdict"], line["low"], line["high"]), (found, str(low), str(high)))

    def test_one(self):
        table = pd.DataFrame({"k": [1, 2, 2], "x": [3.0, 4.0, 5.0]})
        self.assertEqual(finding.one(table, "x", k=1), 3.0)
        with self.assertRaises(ValueError):
            finding.one(table, "x", k=2)
        with self.assertRaises(ValueError):
            finding.one(table, "x", k=7)

    def test_rounded(self):
        self.assertEqual(finding.rounded(0.012345), "0.0123")
        with self.assertRaises(ValueError):
            finding.rounded(float("nan"))


class Numbers(unittest.TestCase):
    """What readers see."""

    def test_digits(self):
        for value, text in (
            (0, "0"),
            (1234.5, "1,230"),
            (0.012345, "0.0123"),
            (5.7, "5.70"),
            (float("nan"), ""),
            (17722156, "17,700,000"),
            (-2.345, "-2.35"),
        ):
            self.assertEqual(common.digits(value), text)

    def test_outward(self):
        for value, places, low, high in (
            (53.56, 1, "53.5", "53.6"),
            (53.54, 1, "53.5", "53.6"),
            (53.6, 1, "53.6", "53.6"),
            (-0.04, 1, "-0.1", "0.0"),
            (5.7e-8, 7, "0.0000000", "0.0000001"),
        ):
            self.assertEqual(common.rounded_down(value, places), low)
            self.assertEqual(common.rounded_up(value, places), high)
        for value, text in ((0, "0"), (1234.5, "1,240"), (0.012341, "0.0124"), (5.7, "5.70"), (float("nan"), "")):
            self.assertEqual(common.digits_up(value), text)

    def test_rows(self):
        for text, value in (("0.5deg", 0.5), ("12k", 12000), ("300", 300)):
            self.assertEqual(common.number(text), value)
        self.assertNotEqual(common.number("N/A"), common.number("N/A"))

    def test_slope(self):
        x = pd.Series([1.0, 2.0, 4.0])
        self.assertAlmostEqual(timing.slope(x, 3 * x**2), 2)

    def test_tex(self):
        self.assertEqual(common.tex("50 % of a_b"), r"50 \% of a\_b")


class Written(unittest.TestCase):
    """Tables are read by pandas as numbers, with units beside them."""

    def test_units(self):
        table = pd.DataFrame({"joint": ["a", "b"], "build_ms": [1234.5, np.nan], "free_share_low": [0.1, 0.2], "held": [True, False],
                              "thesis_mib": ["0.40", "1.98"], "ODE, extrapolated, s": [1.0, 2.0]})
        with tempfile.TemporaryDirectory() as folder:
            common.write_table(Path(folder), "t", "What?", table, "latex")
            record = common.sidecar(Path(folder) / "tables" / "t.csv")
            read = pd.read_csv(Path(folder) / "tables" / "t.csv")
        self.assertEqual([column["unit"] for column in record["columns"]], ["", "ms", "1", "", "MiB", "s"])
        self.assertEqual([column["name"] for column in record["columns"]], list(read))
        self.assertEqual(read.build_ms[0], 1234.5)
        self.assertEqual(record["question"], "What?")

    def test_numbers_as_text_are_refused(self):
        for cell in ("1,234", "12†", "99 %", "< 0.001", "1e-7*", "7"):
            with self.assertRaisesRegex(ValueError, "tables/t.csv: column x holds"):
                common.write_table(Path("/nowhere"), "t", "", pd.DataFrame({"x": ["word", cell]}), "")
        for cell in ("12:30", "1-2", "0.5 deg", "n=291", "10 x 10"):
            with self.assertRaises(OSError):  # words: only there is no such folder
                common.write_table(Path("/dev/null/t"), "t", "", pd.DataFrame({"x": ["word", cell]}), "")


class Pareto(unittest.TestCase):
    """What no other point beats, by the definition alone."""

    def test_front(self):
        """Small whole numbers, so that points share an error or a cost, or both."""
        random = np.random.default_rng(5)
        for _ in range(50):
            points = random.integers(0, 6, (random.integers(1, 20), 2)).astype(float)
            beaten = [any((other <= own).all() and (other < own).any() for other in points) for own in points]
            self.assertEqual(pareto.front(*points.T).tolist(), [not one for one in beaten])


class Counterparts(unittest.TestCase):
    """Every timed column of the thesis' tables has a method of ours."""

    def test_complete(self):
        self.assertEqual(
            [table.artefact for table in timing.TABLES], ["table-3", "table-4", "table-8", "table-9"]
        )
        for table in timing.TABLES:
            columns = set(common.thesis(table.artefact).column)
            self.assertEqual(columns, set(common.counterparts(table.artefact)))
            methods = common.methods_of(table.artefact)
            self.assertLessEqual(set(common.counterparts(table.artefact).values()), set(methods))
            self.assertEqual(len(methods), len(set(methods)))


class Verdict(unittest.TestCase):
    """Printed digits decide."""

    def test_rounds_to(self):
        for measured, printed, good in (
            (0.2715, "0.272", True),
            (0.2714, "0.272", False),
            (52441.0, "52441", True),
            (-3.77, "-4", True),
            (-0.13, "0", True),
            (1.14896, "1.15", True),
        ):
            self.assertEqual(verdict.rounds_to(measured, printed), good, f"{measured} {printed}")

    def test_printed_row(self):
        value = next(common.thesis("table-5").itertuples())
        good = verdict.printed_row(value, float(value.value) + 1e-5)
        bad = verdict.printed_row(value, 2 * float(value.value), "because", "thesis-misprint")
        self.assertEqual(
            (good["verdict"], bad["verdict"], bad["note"]), ("reproduced", "thesis-misprint", "because")
        )
        self.assertEqual(
            (good["artefact"], good["row"], good["column"]), (value.artefact, value.row, value.column)
        )


    def test_same_number(self):
        cases = (("1.5", "1.45", True), ("1.5", "1.44", False), ("0.40", "0.4", True), ("15", "16", False), ("N/A", "N/A", True), ("N/A", "1", False))
        for one, other, same in cases:
            self.assertEqual(common.same_number(one, other), same, f"{one} {other}")

    def test_several_values(self):
        """All that the thesis may mean must round to its digits, or none."""
        value = next(common.thesis("table-5").itertuples())
        printed = float(value.value)
        for also, found in (([printed], "reproduced"), ([2 * printed], "inconclusive")):
            line = verdict.printed_row(value, printed, also=also)
            self.assertEqual((line["verdict"], line["kind"], float(line["high"])), (found, "computed", also[0]))

    def test_counted(self):
        """Sums leave out what is not counted, whatever its verdict; what was computed and what was measured are apart."""
        kept = verdict.row("t", "a", "x", rule="any", verdict="differs")
        rows = pd.DataFrame([kept, verdict.not_counted(kept, "the same number as u, a, x")])
        self.assertEqual(list(verdict.counted(rows).rule), ["any"])
        self.assertEqual(list(rows.verdict), ["differs", "differs"])
        more = [verdict.row("t", "b", "x", kind="computed", rule="any", verdict=name) for name in ("reproduced", "input")]
        self.assertEqual(tally.said([*rows.to_dict("records"), *more]), "1 computed (1 reproduced), 1 measured (1 differs), 1 given")


class TimedVerdicts(unittest.TestCase):
    """Tables 3, 4, 8 and 9 with the thesis' own times for ours, but for what a test changes."""

    def rows(self, change=None, more: list | None = None) -> dict[tuple[str, str, str], dict]:
        """The verdicts by artefact, row and column; change(line) may alter a line of ours, in place, and add to more."""
        with tempfile.TemporaryDirectory() as folder:
            results = Path(folder)
            (results / "data").mkdir()
            for table in (timing.TABLE_8, timing.TABLE_9):
                self.write(results, table, change, more)
            found = verdicts_timing.rows(results)
        return {(line["artefact"], line["row"], line["column"]): line for line in found}

    def write(self, results: Path, table: timing.TimingTable, change, more: list | None):
        """Our CSV of a table: the thesis' times, a tenth of them; 1 s where it has none."""
        methods = {(column, one[column]): 0 for one in common.readings(table.artefact) for column in one}
        times = timing.thesis_times(table)
        lines = []
        for key, column, method, ms in ((*name, method, ms) for name, ms in times.items() for of, method in methods if of == name[1]):
            triangles = 3000 if table.key != "triangles" else int(key)
            line = {
                "method": method,
                table.key: key,
                "triangles": triangles,
                "triangles_of_both": 2 * triangles,
                "median_ms": 1000.0 if np.isnan(ms) else ms / 10,
                "iqr_ms": 0.0,
                "rounds": 9,
                "extrapolated": "no",
                "inconclusive": "no",
            }
            if change:
                change(line)
            lines.append(line)
        lines += more or []
        csv = results / "data" / f"{table.data}.csv"
        pd.DataFrame(lines).to_csv(csv, index=False)
        digest = hashlib.sha256(csv.read_bytes()).hexdigest()
        csv.with_suffix(".json").write_text(json.dumps({"csv_sha256": digest}))

    def test_the_same_times(self):
        """Everything that is judged comes out; what stands in two tables is counted in one."""
        rows = self.rows()
        judged = [line for line in rows.values() if line["verdict"] != "not-comparable"]
        near = [name for name, line in rows.items() if line["verdict"] == "inconclusive"]
        self.assertEqual(near, [("table-9", "300", "order")])  # 0.06 and 0.07 ms: another machine may turn them round
        self.assertEqual({line["verdict"] for line in judged}, {"reproduced", "inconclusive"})
        again = [line for line in rows.values() if "the same number as" in line["rule"]]
        self.assertEqual((len(again), {line["artefact"] for line in again}), (28, {"table-3", "table-4"}))
        self.assertIn("part of table-8, 1deg, order", rows["table-3", "1deg", "order"]["rule"])
        self.assertIn("not counted", rows["table-4", "12k", "rapid/rsid"]["rule"])  # 1.5 here, 1.45 in Table 9, which rounds to it
        for name in ("table-8", "0.05deg", "pairwise"), ("table-9", "12k", "pairwise"):
            self.assertIn("not counted: the thesis gives no time", rows[name]["rule"])
        self.assertEqual(rows["table-8", "growth", "rsid"]["thesis"], "0.84")

    def test_the_range_decides(self):
        """Reproduced or different only if all of it is: rounds, readings of the thesis, joints."""
        name = ("table-8", "0.05deg", "usid/rsid")

        def times(factor: float, spread: float = 0.0, method: str = "usid_thesis_kept"):
            def change(line):
                if (line["method"], line.get("precision_deg")) == (method, 0.05):
                    line["median_ms"] *= factor
                    line["iqr_ms"] = spread * line["median_ms"]

            return change

        for factor, spread, found in ((2, 0, "reproduced"), (2, 0.6, "inconclusive"), (3, 0, "inconclusive"), (9, 0, "inconclusive")):
            line = self.rows(times(factor, spread))[name]
            self.assertEqual(line["verdict"], found, (factor, spread))
            self.assertTrue(float(line["low"]) <= float(line["measured"]) <= float(line["high"]), line)
        self.assertIn("tables kept, 430 to 672: does not; ", line["note"])
        self.assertIn("tables made anew, 47.8 to 74.7: meets the rule", line["note"])

        def slow(line):
            line["median_ms"] *= 9 if line["method"].startswith("usid") and line.get("precision_deg") == 0.05 else 1

        self.assertEqual(self.rows(slow)[name]["verdict"], "differs")

        def once(line):
            line["rounds"] = 1

        self.assertEqual(self.rows(once)[name]["verdict"], "inconclusive")

    def test_a_tick(self):
        """16 ms are one tick of the thesis' clock: the time may have been twice as long or any shorter, and what that explains does not
        differ. 62 ms are four.
        """

        def pairwise(share: float):
            def change(line):
                line["median_ms"] *= share if line["method"].startswith("pairwise") and line.get("precision_deg", 1) < 1 else 1

            return self.rows(change)

        for share, half, tenth in ((1 / 6, "inconclusive", "differs"), (1 / 9, "differs", "differs")):
            rows = pairwise(share)
            found = [rows["table-8", name, "pairwise/rsid"]["verdict"] for name in ("0.5deg", "0.1deg")]
            self.assertEqual(found, [half, tenth], share)

        def grows(power: float):
            def change(line):
                if line["method"].startswith("rsid_thesis"):
                    line["median_ms"] = line["precision_deg"] ** -power

            return self.rows(change)["table-8", "growth", "rsid"]["verdict"]

        self.assertEqual([grows(power) for power in (0, 0.84, 2)], ["differs", "reproduced", "inconclusive"])

    def test_joints(self):
        """A second joint of 12,000 triangles at which the ratio is another: it hangs on the stand-in."""

        def other(line):
            line["joint"] = "generated"
            if line["method"] == "fcl_obb" and line["triangles"] == 12000:
                again.append({**line, "joint": "other_hip", "median_ms": line["median_ms"] / 9})
            elif line["triangles"] == 12000:
                again.append({**line, "joint": "other_hip"})

        again = []
        line = self.rows(other, more=again)["table-9", "12k", "rapid/rsid"]
        self.assertEqual(line["verdict"], "inconclusive")
        self.assertIn("other hip, 0.0226 to 0.0353: does not", line["note"])

    def test_the_opposite_trend(self):
        """Every ratio within half an order of magnitude, but falling where the thesis' rise."""

        def falls(line):
            if line["method"].startswith("usid") and "precision_deg" in line:
                line["median_ms"] *= {1.0: 3, 0.5: 2, 0.1: 0.35, 0.05: 0.35}[line["precision_deg"]] ** 0.9
            if line["method"].startswith("rsid_thesis"):
                line["median_ms"] *= {1.0: 1, 0.5: 1, 0.1: 8, 0.05: 8}[line["precision_deg"]]

        self.assertEqual(self.rows(falls)["table-8", "1deg", "usid/rsid"]["verdict"], "differs")

    def test_growth(self):
        """A power more than a quarter off differs, by the triangles that a joint has; extrapolated times are none."""

        def steeper(line):
            if line["method"].startswith("usid"):
                line["median_ms"] *= line["triangles"] ** 0.4

        line = self.rows(steeper)["table-9", "growth", "usid"]
        self.assertEqual(line["verdict"], "differs")
        self.assertAlmostEqual(float(line["measured"]) - float(line["thesis"]), 0.4)

        def fewer(line):
            line["triangles_of_both"] = int(2 * line["triangles"] ** 0.5)

        line = self.rows(fewer)["table-9", "growth", "usid"]
        self.assertEqual(line["verdict"], "differs")
        self.assertAlmostEqual(float(line["measured"]), 2 * float(line["thesis"]), delta=0.03)

        def scaled(line):
            line["extrapolated"] = "yes" if line["method"].startswith("pairwise") else "no"

        line = self.rows(scaled)["table-8", "growth", "pairwise"]
        self.assertEqual((line["verdict"], line["measured"], line["thesis"]), ("not-comparable", "", "2.00"))

    def test_differs(self):
        """A method ten times faster than it should be, by every reading: what rests on it differs, and the note computes why."""

        def faster(line):
            line["median_ms"] /= 10 if (line["method"][:8], line.get("precision_deg")) == ("pairwise", 1.0) else 1

        rows = self.rows(faster)
        line = rows["table-8", "1deg", "pairwise/rsid"]
        self.assertEqual(line["verdict"], "differs")
        for words in ("off by a factor of 10", f"{common.label('pairwise_thesis')} takes 1/100 of", "4.51 ns a test, there 451", "15 ms are 1"):
            self.assertIn(words, line["note"])
        self.assertEqual(rows["table-8", "1deg", "order"]["verdict"], "reproduced")


class Ranges(unittest.TestCase):
    """Against what is drawn at random from them."""

    def test_slope(self):
        """Straight lines through points within the ranges: nearly all slopes lie inside, and the exact one in the middle."""
        random = np.random.default_rng(7)
        x = np.array([300.0, 1000, 3000, 12000])
        y = [ranges.Range(value**1.5 / 1.3, value**1.5 * 1.3) for value in x]
        found = ranges.slope_range(x, y)
        drawn = [timing.slope(pd.Series(x), pd.Series(x**1.5 * 1.3 ** random.uniform(-1, 1, 4))) for _ in range(300)]
        self.assertGreater(np.mean([found.low < slope < found.high for slope in drawn]), 0.95)
        self.assertAlmostEqual((found.low + found.high) / 2, 1.5)

    def test_slope_limits(self):
        """The least and the largest slope of all corners; open above where a small one may have taken no time."""
        x, y = [1.0, 2, 10, 20], [ranges.Range(1, 3), ranges.Range(2, 4), ranges.Range(3, 5), ranges.Range(9, 12)]
        corners = itertools.product(*((one.low, one.high) for one in y))
        drawn = [timing.slope(pd.Series(x), pd.Series(corner)) for corner in corners]
        found = ranges.slope_limits(x, y)
        self.assertAlmostEqual(found.low, min(drawn))
        self.assertAlmostEqual(found.high, max(drawn))
        self.assertEqual(ranges.slope_limits(x, [ranges.Range(0, 3), *y[1:]]), ranges.Range(found.low, np.inf))
        self.assertEqual(y[0] / ranges.Range(0, 2), ranges.Range(0.5, np.inf))

    def test_times(self):
        """Most medians lie in the range of another of the same times; once is a factor of two."""
        random = np.random.default_rng(3)
        drawn = 10 + random.normal(size=(400, 15))
        found = [ranges.time_range(float(np.median(one)), float(np.subtract(*np.quantile(one, (0.75, 0.25)))), 15) for one in drawn]
        self.assertGreater(np.mean([one.low < other < one.high for one, other in zip(found, np.median(drawn[::-1], axis=1))]), 0.65)
        self.assertLess(np.mean([one.high - one.low for one in found]), 1.35)
        self.assertEqual(ranges.time_range(8, 0, 1), ranges.Range(4, 16))
        self.assertEqual(ranges.time_range(8, 40, 9).low, 4)

    def test_within(self):
        value = ranges.Range(1, 2)
        self.assertEqual([value.within(*ends) for ends in ((0, 3), (1.5, 3), (3, 4), (-1, 0.5))], [True, None, False, False])
        self.assertEqual([ranges.both(*pair) for pair in ((True, True), (True, None), (False, None), (True, False))], [True, None, False, False])


class Steadied(unittest.TestCase):
    """The kept run's range counts where its rule is the same."""

    def test_kept(self):
        names = "artefact,row,column,rule,low,high,verdict,note"
        with tempfile.TemporaryDirectory() as folder:
            kept = Path(folder) / "verdicts.csv"
            kept.write_text(f"{names}\nt,a,c,r,1,2,reproduced,\nt,b,c,r,5,6,differs,\nt,c,c,other,5,6,differs,\nt,d,c,r,,,input,\n")
            ours = pd.DataFrame([["t", row, "c", "r", low, high, "reproduced", "n"] for row, low, high in
                                 (("a", "1.5", "3"), ("b", "1", "2"), ("c", "1", "2"), ("d", "", ""))], columns=names.split(","))
            found = ranges.steadied(ours, kept, ["artefact", "row", "column", "rule"], "note")
            self.assertEqual(list(found.verdict), ["reproduced", "inconclusive", "reproduced", "reproduced"])
            self.assertEqual([(row.low, row.high) for row in found.itertuples()], [("1", "3"), ("1", "6"), ("1", "2"), ("", "")])
            self.assertIn("n; reproduced in this run, from 1 to 2, and differs in the kept one, from 5 to 6", found.note[1])
            self.assertIs(ranges.steadied(ours, kept.with_name("none"), [], ""), ours)


class Claims(unittest.TestCase):
    """A claim in tens of per cent is judged only where every reading of it gives one verdict."""

    def test_centres(self):
        (value,) = [v for v in common.thesis("section-5.1").itertuples() if v.column == "centre_origin_excess"]
        for middle, found in (([1.2, 1.21], "reproduced"), ([1.2, 1.4], "inconclusive"), ([1.3, 1.4], "differs")):
            names = ["conchoid_origin", "one", "other"]
            origins = pd.DataFrame({"middle_mm_per_deg": [1.2, *middle], "apex_mm_per_deg": 1.0}, index=names)
            self.assertEqual(verdicts_conchoid.centre_claim(value, origins)["verdict"], found, middle)

    def test_about(self):
        (value,) = common.thesis("section-4.4").itertuples()
        for readings, found in (([18.1, 19], "reproduced"), ([18.1, 17.9], "inconclusive"), ([23, 17.9], "differs")):
            line = verdict.claim_row(value, readings, "", "")
            self.assertEqual((line["verdict"], float(line["low"]), float(line["measured"])), (found, min(readings), readings[0]))


class Reference(unittest.TestCase):
    """The committed full run beside this one."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.kept = Path(self.folder.name) / "kept"
        (self.kept / "tables").mkdir(parents=True)
        self.table = Path(self.folder.name) / "t.csv"

    def tearDown(self):
        self.folder.cleanup()

    def test_verdicts(self):
        """What it measured, and its verdict where that is another."""
        names = ["artefact", "row", "column", "measured", "verdict"]
        ours = pd.DataFrame(
            [["t", "a", "c", "1", "input"], ["t", "b", "c", "2", "reproduced"]], columns=names
        )
        self.assertIs(reference.with_verdicts(ours, self.kept), ours)
        kept = "artefact,row,column,measured,verdict\nt,b,c,3,differs\nt,a,c,1,input\n"
        (self.kept / "verdicts.csv").write_text(kept)
        both = reference.with_verdicts(ours, self.kept)
        self.assertEqual(list(both.reference), ["1", "3"])
        self.assertEqual(list(both.measured), ["1", "2"])
        self.assertEqual(list(both.verdict_reference), ["", "differs"])

    def shown(self, ours: str, kept: str | None) -> str:
        """The HTML of a table beside the reference's."""
        self.table.write_text(ours)
        if kept is not None:
            (self.kept / "tables" / "t.csv").write_text(kept)
        return data_table.section(self.table, self.kept)

    def test_tables(self):
        """A value that is another stands below ours; rows of other names make a table of their own."""
        self.assertNotIn("eference", self.shown("a,b\nx,1\n", None))
        self.assertIn("same values", self.shown("a,b\nx,1\n", "a,b\nx,1\n"))
        together = self.shown("a,b\nx,1\ny,5\n", "a,b\nx,2\ny,5\n")
        self.assertEqual(together.count('class="kept"'), 1)
        self.assertIn('1<br><span class="kept">2</span>', together)
        self.assertNotIn("<details>", together)
        for other in ("a,b\nz,1\n", "a,b\nx,1\nx,1\n", "a,c\nx,1\n"):
            apart = self.shown("a,b\nx,1\n", other)
            self.assertIn("<details>", apart)
            self.assertNotIn('class="kept"', apart)

    def test_long_table(self):
        """The page holds its first rows, and says where all are."""
        found = self.shown("a\n" + "7\n" * 1000, None)
        self.assertEqual(found.count("<td"), data_table.MOST)
        self.assertIn("1,000 rows; all are in tables/t.csv", found)

    def test_written(self):
        """Digits that a reader can use, in the page alone."""
        for value, text in (
            ("0.49713134", "0.4971"),
            ("25927200", "25,927,200"),
            ("2.8421e-14", "2.84e-14"),
            ("0.27", "0.27"),
            ("15.0", "15"),
            ("RSID <1>", "RSID &lt;1&gt;"),
        ):
            self.assertEqual(markup.written(value, shorten=True)[0], text)
        self.assertEqual(markup.written("0.50", shorten=False), ("0.50", True))  # the thesis' digits
        self.assertEqual(markup.written("18690000000000000696272435122", shorten=True)[0], "1.87e+28")

    def test_words(self):
        """No name of a column stands over one."""
        names = {"iqr_ms": "spread (IQR), ms", "ns_vertex": "vertex, ns", "measured_mib_rsid": "measured RSID, MiB", "rounds": "rounds"}
        for name, text in names.items():
            self.assertEqual(markup.words(name).replace("\u00a0", " "), text)
        self.assertEqual(markup.readable("rsid_thesis, float"), "RSID, raster of the thesis, float")

    def test_by_rule(self):
        """A rule stands once, with all that it judges; what no sum counts comes last."""
        rows = pd.DataFrame([["not counted: a", ""], ["r", "0.1"], ["not counted: b", ""], ["r", "0.1"], ["r", "none"]], columns=["rule", "tolerance"])
        self.assertEqual([len(found) for found in judged.by_rule(rows).values()], [2, 1, 2])
        self.assertEqual(list(judged.by_rule(rows)), ["Rule: r (0.1)", "Rule: r", judged.UNCOUNTED])


class Memory(unittest.TestCase):
    """A memory that does not round from the entries of its own row is a slip of the thesis."""

    def test_contradiction(self):
        values = common.thesis("table-7")
        found = {value.row: verdicts_memory.contradiction(value, values) for value in values.itertuples() if value.column == "memory"}
        slips = [row for row, words in found.items() if words]
        self.assertEqual(slips, ["0.1deg"])
        self.assertEqual(found["0.1deg"]["otherwise"], "thesis-misprint")
        self.assertRegex(found["0.1deg"]["note"], "40.0792 MiB: digits were cut off")


    def test_equator(self):
        """Counted on every turn across the equator, by both readings of the helix; the formula decides nothing."""
        (value,) = [v for v in common.thesis("table-6").itertuples() if (v.row, v.column) == ("0.1deg", "equator_points")]
        cases = (((3600, 3601), (3601, 3601), "reproduced"), ((3599, 3600), (3602, 3602), "differs"), ((3600, 3601), (3600, 3600), "inconclusive"))
        for *counted, found in cases:
            line, arcs = (pd.Series({"equator_least": least, "equator_most": most, "equator_points": 3601}) for least, most in counted)
            self.assertEqual(verdicts_memory.equator_row(value, line, arcs)["verdict"], found)


if __name__ == "__main__":
    unittest.main(verbosity=2)
