# SPDX-License-Identifier: GPL-3.0-or-later
"""The program `cohort`: the same bytes however a study is cut and wherever it is killed, shards that are missing or broken,
and bad input, each with the whole line that must come. IMPINGE names the program.
"""

import csv
import hashlib
import json
import os
import re
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

IMPINGE = os.environ["IMPINGE"]
SPREAD = {"distribution": "normal", "mean": 19, "sd": 5, "source": "test"}
STUDY = {
    "title": "test",
    "hips": 9,
    "seed": 3,
    "faces": 500,
    "start": "normal",
    "parameters": {
        "version": SPREAD,
        "femoral_torsion": {**SPREAD, "mean": 12},
        "cam_height": {"distribution": "censored_normal", "mean": 0, "sd": 2, "most": 4, "source": "test"},
        "neck_fillet": 5,
    },
    "correlations": [{"between": ["version", "femoral_torsion"], "r": 0.3, "source": "test"}],
    "questions": ["limits", "morphology", "zones", "volume"],
    "volume_every": 4,
    "check_every": 5,
    "check_faces": 800,
}
RESULTS = ("cohort.csv", "cohort.json")
VOLUME_ENDS = ("free_low", "free_high", "reach_low", "reach_high")


class Cohort(unittest.TestCase):
    def setUp(self):
        self.root = Path(tempfile.mkdtemp(prefix="impinge-cohort-"))
        self.addCleanup(shutil.rmtree, self.root)

    def study(self, name="study.json", **changes) -> Path:
        file = self.root / name
        text = {**STUDY, **changes}
        file.write_text(json.dumps({key: value for key, value in text.items() if value is not None}))
        return file

    def run_cohort(self, *words) -> subprocess.CompletedProcess:
        return subprocess.run([IMPINGE, "cohort", *map(str, words)], capture_output=True, text=True, check=False)

    def done(self, *words) -> str:
        found = self.run_cohort(*words)
        self.assertEqual((found.returncode, found.stderr), (0, ""))
        return found.stdout

    def refused(self, code: int, line: str, *words):
        found = self.run_cohort(*words)
        self.assertEqual(found.stdout, "")
        self.assertEqual(found.stderr, f"impinge: error: {line}\n")
        self.assertEqual(found.returncode, code)

    def whole(self, shards: int, study: Path, *more) -> Path:
        """The folder of a study that was cut in so many parts."""
        out = self.root / f"out-{shards}"
        for i in range(1, shards + 1):
            self.done("--study", study, *more, "--shard", f"{i}/{shards}", "--out", out)
        self.done("--merge", out)
        return out

    def bytes_of(self, out: Path) -> list[str]:
        return [hashlib.sha256((out / name).read_bytes()).hexdigest() for name in RESULTS]

    def test_the_same_bytes_for_any_number_of_shards(self):
        study = self.study()
        one = self.whole(1, study)
        for shards in (7, 1000):
            self.assertEqual(self.bytes_of(self.whole(shards, study)), self.bytes_of(one), shards)
        with (one / "cohort.csv").open() as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["hip"] for row in rows], [str(j) for j in range(9)])
        for row in rows:
            self.assertLess(abs(float(row["version"]) - float(row["measured_version"])), 1.5)
            self.assertLessEqual(float(row["flexion_low_deg"]), float(row["flexion_deg"]))
            self.assertGreaterEqual(float(row["flexion_high_deg"]), float(row["flexion_deg"]))
            self.assertEqual(row["fine_flexion_deg"] != "", int(row["hip"]) % 5 == 0)
            self.assertEqual(row["volume_free_low"] != "", int(row["hip"]) % 4 == 0)
            if row["volume_free_low"]:
                low, high, reach, within_reach = (float(row["volume_" + end]) for end in VOLUME_ENDS)
                self.assertLess(0.1, low)
                self.assertLess(low, high)
                self.assertLess(high, low + 0.05 + 1e-9)
                self.assertLessEqual(reach, low)
                self.assertLessEqual(within_reach, high)
        summary = json.loads((one / "cohort.json").read_text())
        self.assertEqual((summary["hips"], summary["seed"]), (9, 3))
        self.assertEqual({column["name"] for column in summary["columns"]}, set(rows[0]))
        shards = json.loads((one / "shards.json").read_text())["shards"]
        self.assertEqual(sum(shard["hips"] for shard in shards), 9)

    def test_more_hips_begin_with_the_same(self):
        study = self.study(questions=["morphology"])
        self.whole(1, study, "--hips", 3)
        few = (self.root / "out-1" / "cohort.csv").read_text()
        more = (self.whole(2, study, "--hips", 12) / "cohort.csv").read_text()
        self.assertTrue(more.startswith(few))
        self.assertEqual(more.count("\n"), 13)

    def test_killed_and_started_again(self):
        """At any moment: a run that is cut short leaves whole rows, and the next one ends with the same bytes."""
        study = self.study(hips=120, questions=["morphology"], faces=2000, check_every=None, check_faces=None)
        killed = 0
        out = self.root / "out"
        words = [IMPINGE, "cohort", "--study", study, "--shard", "1/1", "--out", out]
        for wait in (0.05, 0.2, 0.7, 6.0, 7.0):
            with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
                time.sleep(wait)
                process.send_signal(signal.SIGKILL)
                killed += process.wait() == -signal.SIGKILL
            self.assertEqual([file.suffix for file in out.glob("shards/*") if not file.name.startswith(".")],
                             [".rows"] * len(list(out.glob("shards/*.rows"))))
        self.assertGreater(killed, 0)
        self.done(*words[2:])
        self.done("--merge", out)
        self.assertEqual(self.bytes_of(out), self.bytes_of(self.whole(1, study)))

    def test_rows_that_are_there_are_kept(self):
        study = self.study(questions=["morphology"])
        out = self.whole(1, study)
        self.assertIn("9 of them kept", self.done("--study", study, "--shard", "1/1", "--out", out))

    def test_missing_unfinished_and_broken_shards_have_a_name(self):
        study = self.study(questions=["morphology"])
        out = self.whole(4, study)
        shard = out / "shards" / "3-of-4.rows"
        whole = shard.read_bytes()
        (out / "shards" / "2-of-4.rows").unlink()
        shard.write_bytes(whole.replace(b",", b";", 9))
        self.refused(1, f"shards 2, 3 of 4 cannot be merged, the first because it is missing: run cohort --shard 2/4 again",
                     "--merge", out)
        self.done("--study", study, "--shard", "2/4", "--out", out)
        shard.write_bytes(whole[:-3])
        broken = f"{shard}: is broken, its rows are not those that were written; remove it and work out this shard again"
        self.refused(1, f"shard 3 of 4 cannot be merged, the first because {broken}: run cohort --shard 3/4 again",
                     "--merge", out)
        self.refused(1, broken, "--study", study, "--shard", "3/4", "--out", out)
        head, row, *_ = whole.split(b"\n")
        part = json.loads(head)
        part.update(rows=1, sha256=hashlib.sha256(row + b"\n").hexdigest())
        shard.write_bytes(json.dumps(part).encode() + b"\n" + row + b"\n")
        self.refused(1, "shard 3 of 4 cannot be merged, the first because it has 1 of its 2 hips: "
                     "run cohort --shard 3/4 again", "--merge", out)
        before = self.root / "before"
        shutil.copytree(out, before)
        self.done("--study", study, "--shard", "3/4", "--out", out)
        self.done("--merge", out)
        self.assertEqual(self.bytes_of(out), self.bytes_of(before))  # the results of the first merge

    def test_rows_of_other_joints_or_another_program_are_not_kept(self):
        folder, out = self.joints(), self.root / "out"
        study = self.study(joints=str(folder), questions=["limits"], **dict.fromkeys(set(STUDY) - {"title", "seed", "questions"}))
        words = ("--study", study, "--shard", "1/1", "--out", out)
        self.assertEqual(self.run_cohort(*words).returncode, 0)
        shard, said, ball = out / "shards/1-of-1.rows", folder / "a/subject.json", folder / "a/ball.ply"
        before = said.read_bytes(), ball.read_bytes(), shard.read_bytes()
        other = "was worked out when the joints had other files"

        def of_another_program():
            head, rows = before[2].split(b"\n", 1)
            shard.write_bytes(json.dumps({**json.loads(head), "commit": "0123456789ab"}).encode() + b"\n" + rows)

        for change, why in (
            (lambda: said.write_text(json.dumps({"side": "right", "center_of_rotation_mm": [0, 0, 0]})), other),
            (lambda: ball.write_bytes(before[1][:-13]), None),  # that joint is left out, and there is none
            (lambda: ball.write_bytes(before[1].replace(b"lengths in millimetres", b"another made the mesh.")), other),
            (of_another_program, 'was worked out by another version of the program, "0123456789ab"'),
        ):
            change()
            for words_of in (words, ("--merge", out)):
                found = self.run_cohort(*words_of)
                self.assertEqual(found.returncode, 1)
                self.assertIn(f"{shard}: {why}; remove it and work out this shard again" if why else "none of its joints can be used", found.stderr)
            said.write_bytes(before[0])
            ball.write_bytes(before[1])
            shard.write_bytes(before[2])
        self.done("--merge", out)

    def test_folders_that_are_no_run_of_the_study(self):
        study = self.study(questions=["morphology"])
        out = self.whole(1, study)
        other = self.study("other.json", questions=["morphology"], seed=4)
        self.refused(1, f"{out} holds another study, or one of another number of hips: choose another folder with --out",
                     "--study", other, "--shard", "1/1", "--out", out)
        self.refused(1, f"{out} holds another study, or one of another number of hips: choose another folder with --out",
                     "--study", study, "--hips", "8", "--shard", "1/1", "--out", out)
        shutil.copy(out / "shards" / "1-of-1.rows", out / "shards" / "1-of-2.rows")
        self.refused(1, f"{out} holds shards of 1 and of 2: remove those of one of the two in {out}/shards", "--merge", out)
        empty = self.root / "empty"
        empty.mkdir()
        self.refused(1, f"{empty} holds no study.json: it is no folder that cohort --out made", "--merge", empty)
        (out / "shards" / "1-of-1.rows").unlink()
        (out / "shards" / "1-of-2.rows").unlink()
        self.refused(1, f"{out} holds no shard: run cohort --study FILE --shard 1/1 --out {out}", "--merge", out)

    def test_bad_studies(self):
        p = STUDY["parameters"]
        known = "title, hips, seed, faces, start, parameters, correlations, questions, zone_gap_mm, volume_every, check_every, check_faces"
        for changes, line in (
            ({"hips": 0}, "hips is 0; give a number from 1 to 1e+09"),
            ({"hips": 2.5}, "hips is 2.5; give a whole number"),
            ({"seed": -1}, "seed is -1; give a number from 0 to 9007199254740992"),
            ({"seed": None}, "seed is missing; give a number"),
            ({"title": ""}, "title is missing; give a text"),
            ({"colour": 1}, f"colour is not known; there are {known}"),
            ({"questions": ["size"]}, 'questions: "size" is not known; there are limits, morphology, zones, volume'),
            ({"questions": ["zones"]}, "questions: zones are those at the limits; ask for limits too"),
            ({"parameters": {"version": {**SPREAD, "sd": 0}}},
             "parameters.version.sd is 0; give a number from 1e-09 to 105"),
            ({"parameters": {"version": {**SPREAD, "source": ""}}}, "parameters.version.source is missing; give a text"),
            ({"parameters": {"version": {**SPREAD, "least": 30, "most": 20}}},
             "parameters.version: least is not below most; exchange them"),
            ({"parameters": {"version": {**SPREAD, "distribution": "gauss"}}},
             "parameters.version.distribution: no distribution is called 'gauss'; there are normal, censored_normal, "
             "lognormal, uniform"),
            ({"parameters": {"version": 300}}, "parameters.version is 300; give a number from -45 to 60"),
            ({"correlations": [{"between": ["version", "femoral_torsion"], "r": 2, "source": "x"}]},
             "correlations[0].r is 2; give a number from -1 to 1"),
            ({"correlations": [{"between": ["version", "femoral_torsion"], "r": 1, "source": "x"}]},
             "correlations: the matrix is not positive definite, no population has these; make some of them smaller"),
            ({"correlations": [{"between": ["version", "neck_fillet"], "r": 0.1, "source": "x"}]},
             "correlations: 'neck_fillet' is no parameter with a distribution; give it one"),
        ):
            with self.subTest(line):
                study = self.study(**changes)
                self.refused(1, f"study {study}: {line}", "--study", study, "--out", self.root / "out")
        study = self.study(parameters={**p, "cam_size": 3})
        found = self.run_cohort("--study", study, "--out", self.root / "out")
        self.assertRegex(found.stderr, r"^impinge: error: study .*: parameters: a hip has no parameter 'cam_size'; there are "
                                       r"side, head_radius, [a-z_, ]*\n$")
        study.write_text('{"title": ')
        self.refused(1, f"study {study}: it is no JSON object {{...}}", "--study", study, "--out", self.root / "out")
        self.assertFalse((self.root / "out" / "study.json").exists())

    def test_bad_options(self):
        study, out = self.study(), self.root / "out"
        for shard in ("0/0", "0/3", "4/3", "one", "1/"):
            self.refused(2, f"--shard: '{shard}' is no shard; give i/K with i from 1 to K, as 3/12; see impinge cohort --help",
                         "--study", study, "--shard", shard, "--out", out)
        self.refused(2, "nothing to do: give --study and --out, or --merge; see impinge cohort --help")
        self.refused(2, "--study requires --out; see impinge cohort --help", "--study", study)
        self.refused(2, "--study excludes --merge; see impinge cohort --help", "--merge", out, "--study", study, "--out", out)
        missing = self.root / "none.json"
        found = self.run_cohort("--study", missing, "--out", out)
        self.assertEqual((found.returncode, found.stderr.count("\n")), (1, 1))
        self.assertIn(str(missing), found.stderr)

    def test_a_folder_of_joints(self):
        """Hip j is the j-th joint by name; what a joint does not show is empty."""
        for name, hip in (("b", "cam"), ("a", "normal")):
            subprocess.run([IMPINGE, "hip", hip, "--faces", "600", "--out", self.root / "joints" / name],
                           check=True, capture_output=True)
        (self.root / "joints" / "a" / "subject.json").write_text(
            '{"side": "right", "axes": "RAS", "center_of_rotation_mm": [0, 0, 0]}')
        study = self.root / "study.json"
        study.write_text(json.dumps({"title": "two", "seed": 1, "joints": str(self.root / "joints"),
                                     "questions": ["limits", "morphology"]}))
        out = self.root / "out"
        for shard in ("1/2", "2/2"):
            self.assertEqual(self.run_cohort("--study", study, "--shard", shard, "--out", out).returncode, 0)
        self.done("--merge", out)
        with (out / "cohort.csv").open() as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["joint"] for row in rows], ["a", "b"])
        self.assertEqual([row["measured_version"] == "" for row in rows], [False, True])  # without a side
        self.assertTrue(all(row["flexion_deg"] for row in rows))
        self.refused(1, f"study {study}: its hips are those of a folder; leave out --hips",
                     "--study", study, "--hips", "2", "--out", out)

    def joints(self) -> Path:
        """A left hip in LPS, which only the headers of its meshes say, and five that cannot be used."""
        folder = self.root / "bones"
        made = self.root / "made"
        shape = ("side=left", "head_neck_offset=14", "lateral_centre_edge=15", "half_opening=75", "version=35")
        loose = [word for change in shape for word in ("--set", change)]
        subprocess.run([IMPINGE, "hip", "normal", *loose, "--faces", "600", "--out", made], check=True, capture_output=True)
        here = {"side": "left", "center_of_rotation_mm": [0, 0, 0]}
        for name, said in (("a", here), ("bad", {**here, "side": "up"}), ("half", here), ("marked", {**here, "landmarks": "m.csv"}),
                           ("said", {**here, "axes": "RAS"}), ("swapped", here)):
            (folder / name).mkdir(parents=True)
            (folder / name / "subject.json").write_text(json.dumps(said))
            for mesh in ("ball", "socket"):
                head, end, body = (made / f"{mesh}.ply").read_bytes().partition(b"end_header\n")
                count = 3 * int(head.split(b"element vertex ")[1].split()[0])
                places = struct.unpack_from(f"<{count}d", body)
                turned = [-x if k % 3 < 2 else x for k, x in enumerate(places)]
                name_of = {"ball": "socket", "socket": "ball"}[mesh] if name == "swapped" else mesh
                if (name, mesh) != ("half", "socket"):
                    (folder / name / f"{name_of}.ply").write_bytes(
                        head.replace(b"SPACE=RAS", b"SPACE=LPS") + end + struct.pack(f"<{count}d", *turned) + body[8 * count:])
        return folder

    def test_joints_are_taken_as_by_the_other_commands(self):
        """The same limits, whatever says where the axes point; and what is left out there is left out here, and told."""
        folder, out = self.joints(), self.root / "out"
        study = self.study(joints=str(folder), questions=["limits"], **dict.fromkeys(set(STUDY) - {"title", "seed", "questions"}))
        found = self.run_cohort("--study", study, "--out", out)
        self.assertEqual(found.returncode, 0, found.stderr)
        self.done("--merge", out)
        with (out / "cohort.csv").open() as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["joint"] for row in rows], ["a"])
        asked = subprocess.run([IMPINGE, "limits", "--joints", folder, "--out", self.root / "limits", "--json", "--quiet"],
                               capture_output=True, text=True, check=True)
        told = json.loads(asked.stdout)
        limits = {one["motion"]: one for one in told["documents"][0]["answer"]["limits"] if one["centre"] == "ball"}
        self.assertEqual(told["documents"][0]["joint"]["axes"], "LPS")
        for motion, one in limits.items():
            self.assertAlmostEqual(float(rows[0][f"{motion}_deg"]), one["low_deg"], delta=1e-6)
            self.assertEqual((rows[0][f"{motion}_state"], rows[0][f"{motion}_high_deg"] == ""), (one["state"], one["centre_high_deg"] is None))
        self.assertEqual([limits[motion]["state"] for motion in ("flexion", "extension")], ["free", "limited"])
        self.assertIsNone(limits["extension"]["centre_high_deg"])
        summary = json.loads((out / "cohort.json").read_text())
        self.assertNotIn("flexion_deg", summary["quantities"])
        extension = summary["quantities"]["extension_deg"]
        self.assertEqual((extension["n"], extension["without_limit"], extension["quantiles"][5]["mesh_and_centre"][1]), (1, {}, None))
        self.assertEqual(summary["warnings"], [f"a: {line}" for line in told["documents"][0]["joint"]["warnings"]])
        self.assertEqual(len(told["left_out"]), 5)  # the landmarks are missing there
        self.assertEqual([re.search(r"\b(bad|half|marked|said|swapped)\b", line.replace(str(folder), ""))[1] for line in summary["left_out"]],
                         ["bad", "half", "marked", "said", "swapped"])
        lines = summary["warnings"] + [f"left out: {line}" for line in summary["left_out"]]
        self.assertEqual(found.stderr, "".join(f"impinge: warning: {line}\n" for line in lines))


if __name__ == "__main__":
    unittest.main()
