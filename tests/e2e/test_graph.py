# SPDX-License-Identifier: GPL-3.0-or-later
"""The graph of results (experiments/graph.py): which jobs follow from heads, imports and the folders of real joints."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "experiments"))

import graph  # noqa: E402
import run_graph  # noqa: E402
from graph import heads  # noqa: E402

CENTRE = {"center_of_rotation_mm": [0, 0, 0]}
# Folders of real joints: files, and what subject.json says.
FOLDERS = {
    "by_plain_names": (["ball.ply", "socket.ply"], None),
    "facing_first": (["femoral_head.ply", "acetabulum.ply", "acetabulum_facing.ply"], None),
    "two_balls": (["humeral_head.ply", "femoral_head.ply", "acetabulum.ply"], None),
    "two_sockets": (["ball.ply", "acetabulum.ply", "glenoid_facing.ply"], None),
    "two_files": (["ball.ply", "socket.ply", "socket.stl"], None),
    "described": (["ball.ply", "socket.ply"], {**CENTRE, "side": "left", "axes": "+x = patient left, +y = posterior, +z = superior"}),
    "no_side": (["ball.ply", "socket.ply"], {**CENTRE, "side": None}),
    "by_code": (["ball.ply", "socket.ply"], {**CENTRE, "axes": "LPS"}),
    "by_sign": (["ball.ply", "socket.ply"], {**CENTRE, "axes": "+z = superior, -y=posterior , -x = left (RAS)"}),
    "no_axes": (["ball.ply", "socket.ply"], {**CENTRE, "axes": "as scanned"}),
    "wrong_side": (["ball.ply", "socket.ply"], {**CENTRE, "side": "both"}),
    "no_socket": (["ball.ply"], None),
    "upper_case": (["ball.PLY", "socket.PLY"], None),
    "no_centre": (["ball.ply", "socket.ply"], {"side": "left"}),
    "short_centre": (["ball.ply", "socket.ply"], {"center_of_rotation_mm": [0, 0]}),
    "worded_centre": (["ball.ply", "socket.ply"], {"center_of_rotation_mm": [0, 0, "0"]}),
    "left_handed": (["ball.ply", "socket.ply"], {**CENTRE, "axes": "+x = left, +y = anterior, +z = superior"}),
    "one_way_twice": (["ball.ply", "socket.ply"], {**CENTRE, "axes": "+x = left, +y = right, +z = superior"}),
    "two_axes": (["ball.ply", "socket.ply"], {**CENTRE, "axes": "+x = right, +y = anterior"}),
    "a_list": (["ball.ply", "socket.ply"], [1]),
}


def setup(folder: Path = Path("/tmp"), bones: Path | None = None) -> graph.Setup:
    """Of a run into a folder."""
    return graph.Setup(folder / "build", folder / "results", "quick", bones)


class Heads(unittest.TestCase):
    """The jobs that follow from the heads and imports of scripts."""

    def declared(self, head: str, lists: dict[str, str], **files: str) -> list[dict]:
        """The jobs of a table with this head, whose script imports common/part.py; files: further ones of common/."""
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(heads, "ANALYSIS", Path(folder) / "analysis"):
            files = {"__init__": "", "part": "# @depends analysis/common/*.csv\n", **files}
            for name in ("tables", "common"):
                (heads.ANALYSIS / name).mkdir(parents=True)
            (heads.ANALYSIS / "common" / "part.csv").write_text("")
            for name, text in files.items():
                (heads.ANALYSIS / "common" / f"{name}.py").write_text(text)
            (heads.ANALYSIS / "tables" / "one.py").write_text(f"{head}\nfrom common import part\n")
            self.assertEqual([path.stem for path in heads.unused()], [*files][2:])
            return heads.script_jobs("tables", lists, Path("/results"))

    def test_jobs(self):
        """What stands before the first name holds for all; what an import needs, the script needs."""
        head = """# @data a\n# @name t\n# @question One?\n# @depends s/{x,y}.ply
# @name t-JOINT\n# @for JOINT in JOINTS\n# @question Of JOINT?\n# @options --name NAME --all JOINTS\n# @outputs csv
# @name t-all\n# @question All?\n# @when JOINTS\n# @seconds 2 3"""
        found = {job["name"]: job for job in self.declared(head, {"JOINTS": "p,q"})}
        self.assertEqual([*found], ["t", "t-p", "t-q", "t-all"])
        one, of_q = found["t"], found["t-q"]
        files = "data/a.csv data/a.json s/x.ply s/y.ply analysis/common/part.csv".split()
        scripts = "analysis/tables/one.py analysis/common/__init__.py analysis/common/part.py".split()
        self.assertEqual(one["depends"], files + scripts)
        self.assertEqual((one["kind"], one["question"], one["budget"]), ("table", "One?", [1, 1]))
        self.assertEqual(one["outputs"], ["tables/t.csv", "tables/t.json", "tables/t.tex"])
        self.assertEqual((of_q["question"], of_q["outputs"]), ("Of q?", ["tables/t-q.csv"]))
        self.assertEqual(of_q["command"][4:], ["--results", "/results", "--name", "t-q", "--all", "p,q"])
        self.assertEqual(found["t-all"]["budget"], [2, 3])
        self.assertEqual([job["name"] for job in self.declared(head, {"JOINTS": ""})], ["t"])

    def test_refused(self):
        """A key that is none, and a name without a question; a file that no script imports is told."""
        for head, words in (("# @naem t", "there is no @naem"), ("# @name t", "t needs @question")):
            with self.assertRaisesRegex(SystemExit, words):
                self.declared(head, {})
        self.declared("# @name t\n# @question One?", {}, stray="")


class Joints(unittest.TestCase):
    """The joints of a folder."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="impinge-graph-")
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def test_the_same_as_impinge(self):
        """Which are joints, their meshes, sides and axes."""
        subprocess.run([os.environ["IMPINGE"], "hip", "pair", "--faces", "300", "--out", self.folder / "pair"], check=True, capture_output=True)
        for name, (files, said) in FOLDERS.items():
            (self.folder / "bones" / name).mkdir(parents=True)
            for file in files:
                ball = file.split(".")[0] in graph.BALLS
                mesh = (self.folder / "pair" / ("ball.ply" if ball else "socket.ply")).read_bytes()
                (self.folder / "bones" / name / file).write_bytes(mesh.replace(b"comment SPACE=RAS\n", b""))
            if said is not None:
                (self.folder / "bones" / name / "subject.json").write_text(json.dumps(said))
        (self.folder / "bones" / "a_file").write_text("")
        words = [os.environ["IMPINGE"], "touch", "--joints", self.folder / "bones", "--out", self.folder / "out", "--json"]
        told = [one["joint"] for one in json.loads(subprocess.run(words, check=True, capture_output=True).stdout)["documents"]]
        found = graph.find_joints(self.folder / "bones")
        self.assertEqual([joint.name for joint in found], ["by_code", "by_plain_names", "by_sign", "described", "facing_first", "no_side"])
        self.assertEqual([[str(joint.ball), str(joint.socket)] for joint in found], [[one[mesh]["mesh"] for mesh in ("ball", "socket")] for one in told])
        self.assertEqual([joint.options for joint in found],
                         [["--axes", "LPS"], [], ["--axes", "RAS"], ["--side", "left", "--axes", "LPS"], [], []])
        self.assertEqual([(one["side"], one["axes"]) for one in told],
                         [(None, "LPS"), (None, "RAS"), (None, "RAS"), ("left", "LPS"), (None, "RAS"), (None, "RAS")])

    def test_refused(self):
        """A folder without a joint, and a joint whose name cannot be a file's here: one line, exit code 2."""
        for name, files in (("empty", []), ("my hip", ["ball.ply", "socket.ply"])):
            (self.folder / name).mkdir()
            for file in files:
                (self.folder / name / file).write_text("")
            with self.assertRaises(SystemExit) as refused, mock.patch("sys.stderr") as said:
                graph.find_joints(self.folder)
            self.assertEqual(refused.exception.code, 2)
            self.assertIn(str(self.folder), "".join(call.args[0] for call in said.write.mock_calls))


class Graph(unittest.TestCase):
    """The jobs of this project."""

    @classmethod
    def setUpClass(cls):
        cls.jobs = graph.all_jobs(setup())

    def test_what_is_needed_is_made_or_there(self):
        made = {output for job in self.jobs.values() for output in job.outputs}
        for job in self.jobs.values():
            for file in job.depends:
                kept = file in made or file.startswith(("programs/", "analysis/node_modules/", "/tmp/build/"))
                self.assertTrue(kept or (ROOT / file).is_file(), f"{job.name} needs {file}")

    def test_only_programs_that_an_artefact_needs(self):
        """Not all, where one of them is timed."""
        job = run_graph.find(self.jobs, "scheme-comparison")
        programs = ["08_scheme_savings", "08_schemes", "09_lookup_time"]
        self.assertEqual(graph.programs_behind(self.jobs, [job]), programs)

    def test_names(self):
        """Of a job, an artefact or a file; another is refused with those near it."""
        for name in ("table-2", "tables/table-2.csv", "table-2"):
            self.assertEqual(run_graph.find(self.jobs, name).name, "table-2")
        self.assertEqual(run_graph.find(self.jobs, "lut_memory").name, "01_memory")
        with self.assertRaises(SystemExit) as refused, mock.patch("sys.stderr") as said:
            run_graph.find(self.jobs, "table-99")
        self.assertEqual(refused.exception.code, 2)
        self.assertIn("Near: table-9 ", "".join(call.args[0] for call in said.write.mock_calls))

    def test_budgets_sum_to_ten_minutes(self):
        """Of the run that a newcomer begins: no real joints, two cores, timings alone."""
        jobs = self.jobs.values()
        alone = sum(job.budget[0] for job in jobs if job.timing)
        beside = sum(job.budget[0] for job in jobs if not job.timing)
        longest = sorted(jobs, key=lambda job: -job.budget[0])[:5]
        said = ", ".join(f"{job.name} {job.budget[0]}" for job in longest)
        self.assertLessEqual(alone + beside / 2, 600, f"shorten one, and its @seconds: {said}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
