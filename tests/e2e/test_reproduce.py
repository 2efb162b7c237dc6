# SPDX-License-Identifier: GPL-3.0-or-later
"""experiments/reproduce from end to end, in the order in which a user meets it.

The first test makes everything in a temporary results folder (killed on the way, see test_kill.py for more); the others
look at what is there. With IMPINGE_BONES set, these real joints are part of it. ctest runs the steps one by one:
test_reproduce.py FOLDER STEP. Those whose first line says so are left to the nightly run.
"""

from __future__ import annotations

import csv
import fcntl
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BONES = os.environ.get("IMPINGE_BONES", "")
sys.path[:0] = [str(ROOT / "experiments"), str(Path(__file__).resolve().parent)]
import graph  # noqa: E402
import kept_numbers  # noqa: E402
import tally  # noqa: E402

THESIS_TABLES = [f"table-{n}" for n in range(1, 14)]
BORROWED = {*range(2, 13), *range(14, 25), 43, 51}  # "reproduced from" others, by their captions in the thesis
MEASURED_TABLES = {"joint3d-speed.csv"}  # timed when it is made, not made from data


def promised() -> dict[str, graph.Job]:
    """What the graph says that there is to make."""
    return graph.all_jobs(graph.Setup(Path("/"), RESULTS, "quick", Path(BONES) if BONES else None))


def joints() -> list[Path]:
    """The real joints; tests/run gives the gate one of them."""
    return sorted(folder for folder in Path(BONES).iterdir() if folder.is_dir()) if BONES else []


def command(*options: str) -> list[str]:
    """The command with the test's results folder."""
    bones = ["--bones", BONES] if BONES else []
    return [str(ROOT / "experiments" / "reproduce"), "--results", str(RESULTS), *bones, *options]


def reproduce(*options: str, words: list[str] | None = None) -> subprocess.CompletedProcess:
    """Runs it to its end, from a folder that is not the project's."""
    return subprocess.run(words or command(*options), cwd="/", capture_output=True, text=True)


def wait_for(condition, seconds: float) -> bool:
    """Whether the condition comes true in time."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.2)
    return False


def rows(file: Path) -> list[dict[str, str]]:
    """The lines of a CSV."""
    with file.open(newline="") as stream:
        return list(csv.DictReader(stream))


def pdf_text(file: Path) -> str:
    """The words of a PDF, in the order in which they were written."""
    return subprocess.run(["pdftotext", "-raw", str(file), "-"], check=True, capture_output=True, text=True).stdout


def said_besides(row: dict[str, str]) -> list[float]:
    """The numbers with decimals in a row's note that are not its two values, their difference or their quotient."""
    pair = [float(row[name]) for name in ("thesis", "measured") if re.fullmatch(r"-?[\d.]+", row[name])]
    known = [abs(value) for value in pair]
    if len(pair) == 2:
        known += [abs(pair[0] - pair[1]), pair[0] / pair[1], pair[1] / pair[0]]
    said = [float(number.replace(",", "")) for number in re.findall(r"(?<![\w.,])\d[\d,]*\.\d+(?!\.?\d)", row["note"])]
    return [number for number in said if all(abs(number - value) > 0.01 * value for value in known)]


def bytes_of(*patterns: str) -> dict[str, str]:
    """SHA-256 of every file of the results that matches, but those that hold times."""
    found = {file for pattern in patterns for file in RESULTS.glob(pattern) if file.is_file()}
    files = sorted(file for file in found if file.name not in MEASURED_TABLES)
    return {str(file.relative_to(RESULTS)): hashlib.sha256(file.read_bytes()).hexdigest() for file in files}


class Reproduce(unittest.TestCase):
    """Tests in alphabetical order: a, b, c."""

    def test_a_bad_input_is_one_line_and_changes_nothing(self):
        """Exit code 2, one line that names what is wrong, no results folder."""
        program = str(ROOT / "experiments" / "reproduce")
        nowhere = str(RESULTS / "no" / "such")
        cases = [
            (["--frobnicate"], "--frobnicate"),
            (["--jobs", "0"], "--jobs 0"),
            (["--jobs", "many"], "--jobs many"),
            (["--results"], "--results"),
            (["--bones", nowhere], nowhere),
            (["--results", "/proc/x"], "/proc"),
            (["--results", "/etc/passwd"], "/etc/passwd"),
            (["--bones", str(ROOT / "libcore")], "libcore"),
            (["stray"], "stray"),
        ]
        for options, named in cases:
            with self.subTest(options=options):
                done = subprocess.run([program, *options], cwd="/", capture_output=True, text=True)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertIn(named, done.stderr)
        self.assertFalse(any(RESULTS.iterdir()))

    def test_b_killed_runs_go_on(self):
        """Killed while an experiment runs; then it ends, and nothing half-written is left."""
        process = subprocess.Popen(command(), cwd="/", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_for(lambda: (RESULTS / "data/detection_time.json").exists() or process.poll() is not None, 1200)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assertFalse((RESULTS / "report.html").exists())
        before = bytes_of("data/lut_memory.*")
        done = reproduce()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(before, bytes_of("data/lut_memory.*"), "a finished job ran again")
        self.assertFalse((RESULTS / ".staging").exists())
        for job in promised().values():
            for file in job.outputs:
                self.assertTrue((RESULTS / file).is_file() and (RESULTS / file).stat().st_size, file)
        self.assertIn("report.html", done.stdout)
        self.assertRegex(done.stdout, r"verdicts \d+ ")

    def test_c_second_run_does_nothing_and_says_so(self):
        """Within five seconds."""
        begin = time.monotonic()
        done = reproduce()
        self.assertLess(time.monotonic() - begin, 5)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("nothing to do", done.stdout)

    def test_d_same_bytes_when_made_again(self):  # nightly
        """Whatever holds no time is the same to the byte: tables of memory, figures, papers, for the same
        data. Of real joints the first stands for all, as one script draws them.
        """
        others = [joint.name for joint in joints()[1:]]
        patterns = [
            "data/lut_memory.csv",
            "tables/*",
            "figures/*",
            "verdicts.csv",
            "paper-*.pdf",
            "scenes/*/*.ply",
        ]
        before = bytes_of(*patterns)
        for file in [
            *(file for file in RESULTS.glob("tables/*") if file.name not in MEASURED_TABLES),
            *(file for file in RESULTS.glob("figures/*") if not any(name in file.name for name in others)),
            *RESULTS.glob("paper-*.pdf"),
            RESULTS / "verdicts.csv",
            RESULTS / "data" / "lut_memory.csv",
            RESULTS / "scenes" / "generated" / "ball.ply",
        ]:
            file.unlink()
        self.assertEqual(reproduce().returncode, 0)
        self.assertEqual(before, bytes_of(*patterns))

    def test_e_list_names_each_artefact_once(self):  # nightly
        """With experiment, script, command and time."""
        lines = reproduce("--list").stdout.splitlines()
        artefacts = [line for line in lines if line and not line.startswith(" ")]
        self.assertEqual(len(artefacts), len(set(artefacts)))
        made = [artefact for job in promised().values() for artefact in job.artefacts]
        self.assertEqual(artefacts, made)
        self.assertLessEqual({*THESIS_TABLES, "verdicts", "findings", "report", *graph.PAPERS, "joint3d", "lut_memory"}, {*made})
        self.assertEqual(
            sum("script" in line and "experiment" in line and "about" in line for line in lines),
            len(artefacts),
        )

    def test_e_a_question_does_not_wait_for_a_run(self):
        """Nor does it change what the run works on."""
        with (Path(os.environ["IMPINGE_BUILD_DIR"]) / "graph" / "run.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            for question, answer in ((["--list"], "table-2\n"), (["--why", "table-2"], "up to date")):
                done = subprocess.run(command(*question), capture_output=True, text=True, timeout=30, check=False)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertIn(answer, done.stdout)

    def test_e_report_works_in_a_browser(self):
        """First screen, filters, the plot to explore, the joint that turns, no request, no error, on a desktop and on a phone."""
        script = Path(__file__).resolve().parent / "report_page.cjs"
        done = subprocess.run(
            ["node", str(script), str(RESULTS / "report.html")], capture_output=True, text=True, check=False
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_g_only(self):
        """Makes one artefact alone."""
        away, table = RESULTS.with_name(f"{RESULTS.name}-table-3"), RESULTS / "tables" / "table-3.csv"
        table.rename(away)
        self.addCleanup(away.rename, table)
        (RESULTS / "tables" / "table-2.csv").unlink(missing_ok=True)
        done = reproduce("--only", "table-2")
        self.assertEqual(done.returncode, 0)
        self.assertIn(f"made     {RESULTS}/tables/table-2.csv\n", done.stdout)
        self.assertNotIn("report.html", done.stdout)
        self.assertTrue((RESULTS / "tables" / "table-2.csv").is_file())
        self.assertFalse(table.exists())

    def test_h_a_changed_byte_is_refused(self):  # nightly
        """The report names the CSV that its sidecar does not vouch for; removing the CSV mends it."""
        table = RESULTS / "data" / "lut_memory.csv"
        good = table.read_bytes()
        table.write_bytes(good.replace(b"65160", b"65161", 1))
        refused = reproduce()
        self.assertEqual(refused.returncode, 1)
        self.assertIn("lut_memory.csv", refused.stderr)
        table.unlink()
        self.assertEqual(reproduce().returncode, 0)
        self.assertEqual(table.read_bytes(), good)

    def test_every_figure_of_the_thesis_is_made_or_borrowed(self):
        """By its captions, which are typed here; what is made, is not."""
        made = {name for name in promised() if re.fullmatch(r"figure-\d+", name)}
        self.assertEqual(made, {f"figure-{n}" for n in range(1, 64) if n not in BORROWED})
        table = rows(RESULTS / "tables" / "thesis-figures.csv")
        self.assertEqual({int(row["figure"]) for row in table if row["made"] == "no" and row["source"]}, BORROWED)
        self.assertEqual({row["name"] for row in table if row["made"] == "yes"}, made)

    def test_i_what_differs_says_why(self):
        """With a number that was computed: none of the row's own, nor how far they are apart."""
        for row in rows(RESULTS / "verdicts.csv"):
            if row["verdict"] == "differs":
                self.assertTrue(said_besides(row), row)

    def assert_pinned(self, found: Path, pins: Path, names: list[str], otherwise: str = ""):
        """Every line has a verdict that the pins allow, of two at most; a line without a pin has the verdict `otherwise`."""
        pinned = {tuple(pin[name] for name in names): pin for pin in rows(pins)}
        lines = {tuple(row[name] for name in names): row for row in rows(found)}
        self.assertLessEqual(set(pinned), set(lines))
        wrong = []
        for key, row in lines.items():
            pin = pinned.get(key, {"allowed": otherwise})
            allowed = pin["allowed"].split("|")
            self.assertLess(len(allowed), 3, f"{pins.name} allows {', '.join(key)} anything")
            if row["verdict"] not in allowed:
                wrong.append(f"{', '.join(key)}: {row['verdict']}, pinned {' or '.join(allowed)}")
        self.assertFalse(wrong, f"{pins.name}:\n" + "\n".join(wrong))

    def test_i_verdicts_are_those_that_are_pinned(self):
        """Reproduced where there is no pin, with real joints and without. What rests on a time may also be inconclusive, on a machine
        that does other work, but never turns round; the rest is one word.
        """
        here = Path(__file__).resolve().parent
        names = ["artefact", "row", "column"]
        self.assert_pinned(RESULTS / "verdicts.csv", here / "pinned_verdicts.csv", names, "reproduced")
        verdicts = {tuple(row[name] for name in names): row for row in rows(RESULTS / "verdicts.csv")}
        for row in rows(ROOT / "analysis" / "common" / "thesis_values.csv"):
            self.assertEqual(verdicts[tuple(row[name] for name in names)]["thesis"], row["value"], row)
        unmeasured = [name for name, row in verdicts.items() if not row["measured"]]
        self.assertEqual(unmeasured, [("table-8", "growth", "pairwise")])  # scaled, which decides the power
        self.assert_pinned(RESULTS / "tables" / "findings.csv", here / "pinned_findings.csv", ["where", "claim"])

    def test_i_data_are_those_that_are_kept(self):
        """What experiments write that hold no time, real joints aside."""
        self.assertEqual(kept_numbers.differences(RESULTS), [], kept_numbers.__doc__)

    def test_i_findings_have_verdicts(self):
        """Each statement has one, with a number that was computed; the data that it names are there."""
        findings = rows(RESULTS / "tables" / "findings.csv")
        self.assertGreater(len(findings), 20)
        for row in findings:
            self.assertIn(row["verdict"], {"holds", "wrong", "misprint", "imprecise", "inconclusive"})
            if row["source"] == "ganz2003":  # a matter of definition
                continue
            self.assertRegex(row["computed"], r"\d")
            if row["evidence"].startswith("no data: "):
                continue
            for part in row["evidence"].split("; "):
                name = part.split(":")[0]
                self.assertTrue(
                    any((RESULTS / file).is_file() for file in (f"data/{name}.csv", f"{name}.csv", name)), row
                )

    def test_j_report_stands_alone(self):
        """No picture from elsewhere; links lead to files beside it, and every figure is inside or linked."""
        self.assertLess((RESULTS / "report.html").stat().st_size, 5_000_000)
        page = re.sub(r"<script\b.*?</script>", "", (RESULTS / "report.html").read_text(), flags=re.DOTALL)
        self.assertEqual(re.findall(r"""src=["'](?!data:)[^"']*""", page), [])
        links = set(re.findall(r'href="(?!data:|#)([^"]*)"', page))
        self.assertEqual([link for link in sorted(links) if not (RESULTS / link).is_file()], [])
        figures = {file.stem for file in RESULTS.glob("figures/*")}
        self.assertEqual(figures - {Path(link).stem for link in links}, set())
        self.assertGreater(page.count("<img"), 40)

    def test_k_papers_have_the_numbers_of_the_report(self):
        """Text of the PDFs: no fact left open, a draft says so on page 1, and counts are those of verdicts.csv and of the report."""
        said = {name: " ".join(pdf_text(RESULTS / f"{name}.pdf").split()) for name in graph.PAPERS}
        report = re.sub(r"<[^>]*>", "", (RESULTS / "report.html").read_text())
        for name, text in said.items():
            self.assertNotIn("??", text, name)
            self.assertRegex(text[:1500], r"Draft\. Every number here is of a quick run", name)
        verdicts = tally.counts(rows(RESULTS / "verdicts.csv"))
        computed, measured = verdicts["computed"], verdicts["measured"]
        text = said["paper-reproduction"]
        for words in (
            f"Of {computed.total()} numbers that follow from formulas we reproduce {computed['reproduced']}.",
            f"Of {measured.total()} that are measured {measured['reproduced']} are reproduced, {measured['differs']} differ, "
            f"{measured['inconclusive']} are inconclusive",
            "21,013,056",  # of Table 7
        ):
            self.assertIn(words, text)
        own = [row["said_by"] == "thesis" for row in rows(RESULTS / "tables" / "findings.csv")]
        self.assertIn(f"Of {sum(own)} statements of the thesis that we test", text)
        self.assertRegex(report, f"Of {sum(own)} statements of the thesis .*; {len(own) - sum(own)} of others are listed apart")
        kernel = r"Without the mask of the rim it would be [\d.]+ times as fast"
        self.assertEqual(re.findall(kernel, text), re.findall(kernel, report)[:1])
        labels = re.findall(r"\\begin\{theorem\}", (ROOT / "paper" / "proofs.tex").read_text())
        numbers = [int(number) for text in said.values() for number in re.findall(r"Theorem (\d+) \([A-Z][\w ]*\)\.", text)]
        self.assertEqual(sorted(numbers), [*range(1, len(labels) + 1)])  # each in one of the two, as claims.md numbers them

    def test_l_sidecars(self):
        """Each CSV has one, with its hash and where it comes from."""
        for table in RESULTS.glob("data/*.csv"):
            record = json.loads(table.with_suffix(".json").read_text())
            self.assertEqual(record["csv_sha256"], hashlib.sha256(table.read_bytes()).hexdigest())
            for key in (
                "question",
                "columns",
                "seed",
                "commit",
                "driver_sha256",
                "compiler",
                "flags",
                "cpu",
                "command",
            ):
                self.assertIn(key, record, table.name)


if __name__ == "__main__":
    if len(sys.argv) == 3:  # one step, in a folder that the first one empties
        RESULTS, step = Path(sys.argv[1]), sys.argv[2]
        if step.startswith("test_a"):
            shutil.rmtree(RESULTS, ignore_errors=True)
            RESULTS.mkdir(parents=True)
        unittest.main(argv=["test_reproduce.py", f"Reproduce.{step}"], verbosity=2)
    with tempfile.TemporaryDirectory() as folder:
        RESULTS = Path(folder)
        unittest.main(verbosity=2, failfast=True)
