# SPDX-License-Identifier: GPL-3.0-or-later
"""The program `impinge` as a user runs it: what its commands write. What it refuses: test_bad_input.py.

IMPINGE names the program, HIP the folder of a right hip.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from generated_pair import IMPINGE, GeneratedPair, run  # noqa: E402

HIP = Path(os.environ["HIP"])
FIVE = ["ball.ply", "distances.csv", "gaps.csv", "socket.ply", "summary.json"]


def typed(value) -> str:
    """A value of a request as a person types it."""
    if isinstance(value, dict):
        return ",".join(f"{name}={angle}" for name, angle in value.items())
    return ",".join(map(str, value)) if isinstance(value, list) else str(value)


def options(request: dict) -> list[str]:
    """A request as a person types it: clearance_mm is --clearance, and what is null or false is left out."""
    words = []
    for name, value in request.items():
        option = "--" + name.removesuffix("_mm").removesuffix("_deg").replace("_", "-")
        several = isinstance(value, list) and not (value and all(isinstance(one, float) for one in value))
        for one in value if several else [value]:
            words += [] if one in (None, False) else [option] if one is True else [option, typed(one)]
    return words


class Program(GeneratedPair):
    def impinge(self, question: str, out: str, *more, files=()) -> subprocess.CompletedProcess:
        return run(IMPINGE, question, *(files or (self.ball, self.socket)), "--out", self.root / out, *more)

    def answered(self, *words, **files) -> subprocess.CompletedProcess:
        """Without a warning."""
        done = self.impinge(*words, **files)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done

    def written(self, out: str) -> list[str]:
        return sorted(path.name for path in (self.root / out).iterdir())

    def document(self, out: str) -> dict:
        return json.loads((self.root / out / "summary.json").read_text())

    def test_writes_the_five_files_of_a_hip_and_says_what_it_found(self):
        """Again, the same bytes."""
        files = HIP / "ball.ply", HIP / "socket.ply"
        done = self.answered("gaps", "good", "--side", "right", files=files)
        same = self.answered("gaps", "same", "--side", "right", "--json", files=files)
        self.assertEqual(same.stdout, (self.root / "same" / "summary.json").read_text())
        self.assertEqual(self.written("good"), FIVE)
        for name in set(FIVE) - {"summary.json"}:
            self.assertEqual((self.root / "good" / name).read_bytes(), (self.root / "same" / name).read_bytes(), name)
        vertices = {}
        for part in ("ball", "socket"):
            head = (self.root / "good" / f"{part}.ply").read_bytes().split(b"end_header")[0]
            self.assertIn(b"property double gap\n", head)
            vertices[part] = int(head.split(b"element vertex ")[1].split()[0])
        for name, columns in (("gaps.csv", "x,y,z,gap_mm"), ("distances.csv", "gap_mm,distance_lower_mm,distance_upper_mm")):
            rows = (self.root / "good" / name).read_text().splitlines()
            self.assertEqual((rows[0], len(rows) - 1), (f"surface,vertex,{columns}", sum(vertices.values())))
        said = self.document("good")
        self.assertEqual((said["command"], sorted(said["files"]), said["joint"]["warnings"]), ("gaps", FIVE, []))
        self.assertAlmostEqual(said["joint"]["centre"]["radius_mm"], 24.0, delta=0.01)
        self.assertLess(max(map(abs, said["joint"]["centre"]["position"])), 0.01)
        self.assertAlmostEqual(said["answer"]["smallest_gap"]["gap_mm"], 3.5, delta=0.06)  # the sagitta of coarse faces
        for word in ("centre of rotation", "smallest gap", "bone on bone        nowhere", "within cartilage    ball"):
            self.assertIn(word, done.stdout)

    def test_what_is_not_asked_for_is_not_written(self):
        tables = ["--precision", 0.2, "--outputs", "gaps"]
        for out, question, more, names, words in (
            ("gaps", "gaps", tables, ["ball.ply", "gaps.csv", "socket.ply", "summary.json"], ["table               "]),
            ("ball_alone", "gaps", [*tables, "--surfaces", "ball"], ["ball.ply", "gaps.csv", "summary.json"], []),
            ("touch", "touch", [], ["summary.json"], ["contact             no", "smallest gap"]),
            ("accurate", "gaps", ["--max-error", 0.01], FIVE, ["gaps within 0.01 mm"]),
        ):
            with self.subTest(out):
                done = self.answered(question, out, *more)
                self.assertEqual(self.written(out), names)
                for word in words:
                    self.assertIn(word, done.stdout)
        alone = self.document("gaps")["answer"]
        left_out = {item["what"] for item in alone["left_out"]}
        self.assertEqual(left_out, {"vertices", "entries", "error_bounds", "distances", "exact_verdicts"})
        self.assertLess(alone["table_bytes"], 2 * 8 * alone["entries_per_table"])  # of whole tables
        self.assertNotIn("\nsocket,", (self.root / "ball_alone" / "gaps.csv").read_text())
        self.assertEqual(self.document("touch")["answer"]["contact"]["state"], "no")

    def test_every_answer_can_be_asked_again(self):
        """By what its document says of the joint and of the request; without --out nothing is written."""
        files = HIP / "ball.ply", HIP / "socket.ply"
        pose = ["--pose", "flexion=20,abduction=5"]
        for question, *more in (
            ("touch", *pose, "--overlap", 0.1),
            ("gaps", *pose, "--max-error", 0.1, "--cartilage", 3),
            ("gaps", "--outputs", "gaps,verdicts", "--precision", 2, "--scheme", "rsid"),
            ("limits", *pose, "--motions", "flexion,internal_rotation", "--cartilage", 2.5, "--translation", "0,0,0.25"),
            ("poses", "--path", "flexion=0..20/10,abduction=5", "--outputs", "touch"),
            ("certify", *pose, "--motion", "internal_rotation"),
            ("volume", "--width", 0.4, "--gap", 0.1, "--play", 0.2),
            ("resect", "--require", "flexion=90,internal_rotation=25", "--require", "flexion=100", "--clearance", 0.4),
            ("orient", "--require", "flexion=30", "--tilt", -5, "--resolution", 2),
            ("measure",),
        ):
            with self.subTest(question, more=more):
                first = run(IMPINGE, question, *files, "--side", "right", "--json", "--quiet", *more)
                self.assertEqual(first.returncode, 0, first.stderr)
                said = json.loads(first.stdout)
                joint = {name: said["joint"][name] for name in ("side", "axes", "overlap_mm")}
                joint["centre"] = said["joint"]["centre"]["position"]
                again = run(IMPINGE, question, *files, "--json", "--quiet", *options(joint | said["request"]))
                self.assertEqual(again.returncode, 0, again.stderr)
                again = json.loads(again.stdout)
                self.assertEqual(again["request"], said["request"])
                self.assertEqual(again["answer"], said["answer"])
                self.assertEqual(again["joint"]["centre"]["position"], said["joint"]["centre"]["position"])

    def test_many_poses_are_answered_also_after_a_kill(self):
        path = ["--path", "flexion=-30..120/0.5,internal_rotation=-40..40/0.5", "--side", "left"]
        folder = self.root / "many"
        words = [str(word) for word in (IMPINGE, "poses", self.ball, self.socket, "--out", folder, *path)]
        running = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            until = time.monotonic() + 60.0
            while sum(part.stat().st_size for part in folder.glob("*.part")) < 100_000:
                self.assertLess(time.monotonic(), until)
                self.assertIsNone(running.poll(), "it ended before it was killed")
                time.sleep(0.01)
        finally:
            running.kill()
            running.wait()
        self.assertFalse((folder / "poses.csv").exists())
        done = self.impinge("poses", "many", *path)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("poses were answered before", done.stderr)
        self.assertEqual(self.written("many"), ["poses.csv", "summary.json"])
        self.assertIn(f"poses               {301 * 161}, {self.document('many')['answer']['touching']} of them touch", done.stdout)
        rows = (folder / "poses.csv").read_text().splitlines()
        self.assertEqual(len(rows), 301 * 161 + 1)
        self.assertEqual(rows[0], "pose,touch,certified,smallest_gap_mm,surface,vertex,clock,bound_mm,"
                                  "flexion,internal_rotation")
        self.assertEqual(rows[-1].split(",")[0], str(301 * 161))
        (folder / "poses-0123456789abcdef.part").write_text(rows[0] + "\n")
        other = self.impinge("poses", "many", "--path", "flexion=0..9/1")
        self.assertIn("many/poses-0123456789abcdef.part is left from an earlier command", other.stderr)

    def test_proven_ends_are_printed_outward(self):
        done = self.answered("gaps", "outward", "--precision", 2, "--pose", "flexion=30,abduction=10", "--side", "left")
        bound, low, high = (
            float(re.search(pattern, done.stdout)[1])
            for pattern in (r"at most ([\d.]+) mm", r"distance  ([\d.]+) to", r"distance  [\d.]+ to ([\d.]+)")
        )
        smallest = self.document("outward")["answer"]["smallest_gap"]
        ends = [smallest["error_bound_mm"], *smallest["euclidean_distance_mm"]]
        self.assertTrue(0 <= bound - ends[0] < 1e-3, done.stdout)
        self.assertTrue(-1e-3 < low - ends[1] <= 0 <= high - ends[2] < 1e-3, (done.stdout, ends))

    def test_help(self):
        """Each command has an example that begins with its name; without a command there is help, too."""
        commands = re.findall(r"^  (\w+) +\S", run(IMPINGE, "--help").stdout.split("Subcommands:")[1], re.M)
        self.assertLessEqual({"gaps", "touch", "limits", "hip", "check"}, set(commands))
        for command in commands:
            done = run(IMPINGE, command, "--help")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn(f"Example: impinge {command} ", done.stdout)
        self.assertEqual(run(IMPINGE).returncode, 2)
        self.assertRegex(run(IMPINGE, "--version").stdout, r"^impinge \d+\.\d+\.\d+ \(commit \S+\)\n$")


if __name__ == "__main__":
    unittest.main()
