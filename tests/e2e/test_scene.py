# SPDX-License-Identifier: GPL-3.0-or-later
"""The program `scene` as a user runs it: what it writes. What it refuses: test_bad_input.py.

SCENE and MAKE_PAIR name the two programs, HIP the folder of a right hip, in it `scene` what the program made of it.
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
from generated_pair import GeneratedPair, run  # noqa: E402

SCENE = os.environ["SCENE"]
MAKE_PAIR = os.environ["MAKE_PAIR"]
HIP = Path(os.environ["HIP"])


class Scene(GeneratedPair):
    def scene(self, out: str, *more, ball=None, socket=None) -> subprocess.CompletedProcess:
        return run(SCENE, "--ball", ball or self.ball, "--socket", socket or self.socket, "--out", self.root / out,
                   *more)

    def test_writes_the_five_files_of_a_hip_and_says_what_it_found(self):
        """And gives the bytes of the run before it."""
        done = self.scene("good", "--side", "right", ball=HIP / "ball.ply", socket=HIP / "socket.ply")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        names = sorted(path.name for path in (self.root / "good").iterdir())
        self.assertEqual(names, ["ball.ply", "distances.csv", "gaps.csv", "socket.ply", "summary.json"])
        for name in set(names) - {"summary.json"}:
            self.assertEqual((self.root / "good" / name).read_bytes(), (HIP / "scene" / name).read_bytes(), name)
        summary = self.summary("good")
        vertices = {}
        for part in ("ball", "socket"):
            head = (self.root / "good" / f"{part}.ply").read_bytes().split(b"end_header")[0]
            self.assertIn(b"property double gap\n", head)
            vertices[part] = int(head.split(b"element vertex ")[1].split()[0])
        for name, columns in (("gaps.csv", "x,y,z,gap_mm"), ("distances.csv", "gap_mm,distance_lower_mm,distance_upper_mm")):
            rows = (self.root / "good" / name).read_text().splitlines()
            self.assertEqual((rows[0], len(rows) - 1), (f"surface,vertex,{columns}", sum(vertices.values())))
        self.assertLessEqual({"units", "centre", "smallest_gap", "impingement", "error_bound_mm", "contact", "radial_overlap", "euclidean_distance_mm",
                              "left_out", "times_ms", "warnings"}, set(summary))
        self.assertAlmostEqual(summary["centre"]["radius_mm"], 24.0, delta=0.01)
        self.assertLess(max(abs(summary["centre"][axis]) for axis in "xyz"), 0.01)
        self.assertAlmostEqual(summary["smallest_gap"]["gap_mm"], 3.5, delta=0.06)  # the sagitta of coarse faces
        for word in ("centre of rotation", "smallest gap", "impinged at   0 mm   nowhere", "impinged at   4 mm"):
            self.assertIn(word, done.stdout)

    def summary(self, out: str) -> dict:
        return json.loads((self.root / out / "summary.json").read_text())

    def test_what_is_not_asked_for_is_not_written(self):
        five = ["ball.ply", "distances.csv", "gaps.csv", "socket.ply", "summary.json"]
        for out, options, names, words in (
            ("gaps", ["--outputs", "gaps", "--explain"], ["ball.ply", "gaps.csv", "socket.ply", "summary.json"], ["left out", "saves"]),
            ("ball_alone", ["--surfaces", "ball", "--outputs", "gaps"], ["ball.ply", "gaps.csv", "summary.json"], []),
            ("contact", ["--question", "first-contact"], ["summary.json"], ["smallest gap"]),
            ("touch", ["--question", "touch", "--surfaces", "ball"], ["summary.json"], ["touch               no"]),
            ("accurate", ["--max-error", "0.01"], five, ["gaps within 0.01 mm"]),
        ):
            with self.subTest(out):
                done = self.scene(out, *options, *([] if out == "accurate" else ["--precision", 0.2]))
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual(sorted(path.name for path in (self.root / out).iterdir()), names)
                for word in words:
                    self.assertIn(word, done.stdout)
        alone = self.summary("gaps")
        left_out = {item["what"] for item in alone["left_out"]}
        self.assertEqual(left_out, {"vertices", "entries", "error_bounds", "distances", "exact_verdicts"})
        self.assertLess(alone["table_bytes"], 2 * 8 * alone["entries_per_table"])  # of whole tables
        self.assertNotIn("\nsocket,", (self.root / "ball_alone" / "gaps.csv").read_text())
        self.assertFalse(self.summary("touch")["touch"])

    def asked_again(self, out: str) -> list[str]:
        """The options that a summary says it was asked with."""
        said = self.summary(out)
        centre = ",".join(str(said["centre"][axis]) for axis in "xyz")
        options = ["--centre", centre, "--axes", said["axes"], "--question", said["question"]]
        for option, key in (("--side", "side"), ("--motion", "motion"), ("--surfaces", "surfaces"),
                            ("--scheme", "scheme"), ("--cartilage", "cartilage_mm")):
            if said.get(key) is not None:
                options += [option, str(said[key])]
        if said["pose"] != "as scanned":
            options += ["--pose", said["pose"]]
        if said["question"] == "all-gaps":
            options += ["--outputs", ",".join(said["outputs"])]
        if said["question"] != "limit":
            accuracy = "max_error_mm" if said["max_error_mm"] else "precision_deg"
            options += ["--max-error" if said["max_error_mm"] else "--precision", str(said[accuracy])]
        return options

    def test_every_answer_can_be_asked_again(self):
        posed = ["--pose", "flexion=20,abduction=5", "--side", "left", "--axes", "LPS", "--centre", "0,0.25,0"]
        for number, options in enumerate((
            ["--question", "limit", "--motion", "internal_rotation", "--cartilage", "3.5"],
            ["--question", "touch", "--surfaces", "ball", "--precision", "2"],
            ["--question", "first-contact", "--max-error", "0.1"],
            ["--outputs", "gaps,verdicts", "--precision", "2", "--scheme", "rsid"],
        )):
            with self.subTest(options):
                first, second = f"asked_{number}", f"again_{number}"
                done = self.scene(first, *posed, *options)
                self.assertEqual(done.returncode, 0, done.stderr)
                again = self.scene(second, *self.asked_again(first))
                self.assertEqual(again.returncode, 0, again.stderr)
                self.assertEqual(again.stdout.replace(second, first), done.stdout)
                answers = [self.summary(out) for out in (first, second)]
                for answer in answers:
                    del answer["times_ms"]
                self.assertEqual(*answers)

    def test_many_poses_are_answered_also_after_a_kill(self):
        path = ["--path", "flexion=-30..120/0.5,internal_rotation=-40..40/0.5", "--side", "left"]
        folder = self.root / "many"
        running = subprocess.Popen([str(a) for a in (SCENE, "--ball", self.ball, "--socket", self.socket, "--out",
                                                     folder, *path)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
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
        done = self.scene("many", *path)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("poses were answered before", done.stderr)
        self.assertEqual(sorted(file.name for file in folder.iterdir()), ["poses.csv", "summary.json"])
        self.assertIn(f"poses               {301 * 161}, {self.summary('many')['touching']} of them touch", done.stdout)
        rows = (folder / "poses.csv").read_text().splitlines()
        self.assertEqual(len(rows), 301 * 161 + 1)
        self.assertEqual(rows[0], "pose,touch,certified,smallest_gap_mm,surface,vertex,clock,bound_mm,"
                                  "flexion,internal_rotation")
        self.assertEqual(rows[-1].split(",")[0], str(301 * 161))
        (folder / "poses-0123456789abcdef.part").write_text(rows[0] + "\n")
        other = self.scene("many", "--path", "flexion=0..9/1")
        self.assertIn("many/poses-0123456789abcdef.part is left from an earlier scene", other.stderr)

    def test_poses_come_from_a_file(self):
        poses = self.root / "two.csv"
        poses.write_text("flexion\n0\n20\n")
        done = self.scene("of_file", "--poses", poses, "--question", "touch")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.root / "of_file" / "poses.csv").read_text().splitlines()[1:],
                         ["1,no,yes,,,,,,0", "2,no,yes,,,,,,20"])
        self.refused(self.scene("of_file", "--poses", self.root / "none.csv"), 1, "none.csv")
        poses.write_text("flexion,abduction\n0,0\n0,10\n")
        self.refused(self.scene("no_side", "--poses", poses), 1, "two.csv", "--side")
        self.nothing_in("no_side")

    def test_a_limit_takes_no_map_of_cartilage(self):
        thickness = self.root / "map.csv"
        thickness.write_text("x,y,z,thickness_mm\n0,0,25,3\n")
        done = self.scene("map", "--question", "limit", "--motion", "flexion", "--cartilage", thickness)
        self.refused(done, 2, "option --cartilage", "a limit has one threshold; give a number of mm")

    def test_proven_ends_are_printed_outward(self):
        done = self.scene("outward", "--precision", 2, "--pose", "flexion=30,abduction=10", "--side", "left")
        bound, low, high = (
            float(re.search(pattern, done.stdout)[1])
            for pattern in (r"at most ([\d.]+) mm", r"distance  ([\d.]+) to", r"distance  [\d.]+ to ([\d.]+)")
        )
        smallest = self.summary("outward")["smallest_gap"]
        ends = [smallest["error_bound_mm"], *smallest["euclidean_distance_mm"]]
        self.assertTrue(0 <= bound - ends[0] < 1e-3, done.stdout)
        self.assertTrue(-1e-3 < low - ends[1] <= 0 <= high - ends[2] < 1e-3, (done.stdout, ends))

    def test_files_that_are_not_of_this_scene_are_named(self):
        self.assertEqual(self.scene("twice", "--precision", 2).stderr, "")
        before = (self.root / "twice" / "gaps.csv").read_bytes()
        done = self.scene("twice", "--precision", 2, "--surfaces", "ball", "--outputs", "gaps")
        self.assertIn("twice/{socket.ply,distances.csv} is left from an earlier scene", done.stderr)
        done = self.scene("twice", "--question", "touch")
        self.assertIn("twice/{ball.ply,socket.ply,gaps.csv,distances.csv} is left", done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertNotEqual((self.root / "twice" / "gaps.csv").read_bytes(), before)
        self.assertEqual(self.scene("twice", "--precision", 2).stderr, "")
        self.assertEqual((self.root / "twice" / "gaps.csv").read_bytes(), before)

    def test_hips_that_cannot_be(self):
        """Which they are: tests/hip/hip_test.cpp."""
        for options, words in ((["--set", "cam_height=1"], "--set requires --hip"), (["--hip", "normal", "--faces", "100"], "500 faces or more")):
            done = run(MAKE_PAIR, *options, "--out", self.root / "no_hip")
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
            self.assertIn(words, done.stderr)
            self.nothing_in("no_hip")

    def refused(self, done: subprocess.CompletedProcess, code: int, *words: str):
        self.assertEqual(done.returncode, code, done.stderr + done.stdout)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("scene: error: "), done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def nothing_in(self, out: str):
        folder = self.root / out
        self.assertFalse(folder.exists() and any(folder.iterdir()), f"{out} is not empty")


if __name__ == "__main__":
    unittest.main()
