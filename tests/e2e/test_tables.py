# SPDX-License-Identifier: GPL-3.0-or-later
"""Where `impinge` writes a table: all motions, measures, and every joint of a folder. Rows of a table are those of the
questions asked one by one. IMPINGE names the program; IMPINGE_BONES may name a folder of real joints.
"""

from __future__ import annotations

import csv
import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

IMPINGE = os.environ["IMPINGE"]
MOTIONS = ["flexion", "extension", "abduction", "adduction", "internal_rotation", "external_rotation"]
CLINICAL = ["internal_rotation_at_45", "internal_rotation_at_70", "internal_rotation_at_90", "external_rotation_at_90", "fadir",
            "faber"]
LIMITS = ("joint,motion,threshold_mm,centre,state,low_deg,high_deg,centre_low_deg,centre_high_deg,half_mm_gap_deg,clock,"
          "what,play_low_deg,play_high_deg,hangs_on_less_than_half_mm").split(",")
MEASURES = ["head_radius", "head_neck_offset", "neck_shaft_angle", "femoral_torsion",
            *(f"alpha_at_{hour}" for hour in (12, 1, "1_30", *range(2, 12))), "alpha_notzli", "socket_radius", "inclination", "version", "half_opening",
            "lateral_centre_edge", "coverage"]

PUBLISHED = [f"published_{key}" for key in ("mean", "sd", "median", "lower_quartile", "upper_quartile", "of", "source")]
ROOT = Path(__file__).resolve().parents[2]


def number(cell):
    return float(cell) if cell else None


def run(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


class Tables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory(prefix="impinge-tables-")
        cls.addClassCleanup(holder.cleanup)
        cls.root = Path(holder.name)
        cls.bones = cls.root / "bones"
        for name, side, hip, faces in (("b_left", "left", "cam", 700), ("a_right", "right", "normal", 600)):
            made = run(IMPINGE, "hip", hip, "--set", f"side={side}", "--faces", faces, "--out", cls.bones / name)
            assert made.returncode == 0, made.stderr
            axes = "+x = patient right, +y = anterior, +z = superior"
            (cls.bones / name / "subject.json").write_text(json.dumps({"side": side, "axes": axes, "center_of_rotation_mm": [0, 0, 0]}))
        (cls.bones / "c_half").mkdir()
        (cls.bones / "c_half/ball.ply").write_bytes((cls.bones / "b_left/ball.ply").read_bytes())
        (cls.bones / "d_broken").mkdir()
        (cls.bones / "d_broken/ball.ply").write_bytes((cls.bones / "b_left/ball.ply").read_bytes()[:2000])
        (cls.bones / "d_broken/socket.ply").write_bytes((cls.bones / "b_left/socket.ply").read_bytes())
        (cls.bones / "e_undescribed").mkdir()
        for surface in ("ball.ply", "socket.ply"):
            (cls.bones / "e_undescribed" / surface).write_bytes((cls.bones / "b_left" / surface).read_bytes())
        (cls.bones / "e_undescribed/subject.json").write_text("{}")

    def ask(self, out, name, command, *more):
        """The answer, and what was printed."""
        folder = self.bones / name
        done = run(IMPINGE, command, folder / "ball.ply", folder / "socket.ply", "--side", name.split("_")[1], "--centre", "0,0,0",
                   "--out", self.root / out, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.root / out / "summary.json").read_text())["answer"], done

    def ask_all(self, out, command, *more):
        """The rows of all joints of the folder."""
        done = run(IMPINGE, command, "--joints", self.bones, "--out", self.root / out, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("impinge: joint 1 of 3, a_right\n", done.stderr)
        self.assertIn(f"impinge: warning: left out: {self.bones}/c_half has no socket mesh\n", done.stderr)
        self.assertRegex(done.stderr, r"left out: \S+d_broken/ball.ply: ")
        self.assertRegex(done.stderr, r"left out: \S+e_undescribed/subject.json: no center_of_rotation_mm: ")
        summary = json.loads((self.root / out / "summary.json").read_text())
        self.assertEqual([one["joint"]["side"] for one in summary["documents"]], ["right", "left"])
        self.assertEqual(len(summary["left_out"]), 3)
        self.assertEqual(sorted(path.name for path in (self.root / out).iterdir() if path.is_dir()), ["a_right", "b_left"])
        return rows_of(next((self.root / out).glob("*.csv")))

    def test_a_named_motion_starts_from_its_pose(self):
        for motion, growing, start in (("fadir", "internal_rotation", "flexion=90,adduction=15"), ("faber", "external_rotation", "flexion=45,abduction=30")):
            asked, _ = self.ask("one", "b_left", "limits", "--motions", growing, "--pose", start)
            named, _ = self.ask("named", "b_left", "limits", "--motions", motion)
            self.assertEqual([{**limit, "motion": motion} for limit in asked["limits"]], named["limits"])

    def test_the_rows_of_limits_are_degrees_and_mm_about_both_centres(self):
        _, done = self.ask("rows", "b_left", "limits", "--cartilage", "3")
        rows = rows_of(self.root / "rows/limits.csv")
        self.assertEqual(list(rows[0]), LIMITS)
        self.assertIn("limits, degrees", done.stdout)
        self.assertIn("{limits.csv,summary.json}", done.stdout)
        self.assertEqual([(row["motion"], row["centre"], float(row["threshold_mm"])) for row in rows],
                         [(motion, *about) for motion in MOTIONS + CLINICAL for about in (("ball", 0), ("socket", 0), ("ball", 3))])
        touches = []
        for row in rows:
            low, limited = float(row["low_deg"]), row["state"] == "limited"
            self.assertIn(row["state"], ("limited", "free", "blocked", "unknown"))
            self.assertTrue(0 <= float(row["centre_low_deg"]) <= low <= 180, row)
            self.assertTrue(not limited or low <= float(row["high_deg"]) < low + 0.01, row)
            if row["clock"]:
                self.assertRegex(row["clock"], r"^(1?\d):[0-5]\d$")
            if limited and (row["centre"], float(row["threshold_mm"])) == ("ball", 0) and row["motion"] in ("abduction", "extension"):
                touches.append([self.ask("at", "b_left", "touch", "--pose", f"{row['motion']}={row[end]}")[0]["contact"]["state"]
                                for end in ("low_deg", "high_deg")])
        self.assertTrue(touches and all(ends == ["no", "yes"] for ends in touches), touches)
        self.ask("bare", "b_left", "limits", "--cartilage", "0")
        self.assertEqual({row["threshold_mm"] for row in rows_of(self.root / "bare/limits.csv")}, {"0"})

    def test_a_folder_gives_the_rows_of_its_joints(self):
        rows = self.ask_all("limits", "limits", "--motions", "flexion")
        for name in ("a_right", "b_left"):
            asked, _ = self.ask("single", name, "limits", "--motions", "flexion")
            self.assertEqual([float(row["low_deg"]) for row in rows if row["joint"] == name], [limit["low_deg"] for limit in asked["limits"]])

    def test_touch_and_smallest_gap_of_a_folder(self):
        for pose in ("flexion=120,internal_rotation=40", "flexion=60,internal_rotation=10"):
            for row in self.ask_all("touch", "touch", "--pose", pose):
                asked, _ = self.ask("single", row["joint"], "touch", "--pose", pose)
                smallest = asked["smallest_gap"]
                self.assertEqual((row["contact"], float(row["smallest_gap_mm"]), row["surface"], int(row["vertex"])),
                                 (asked["contact"]["state"], smallest["gap_mm"], smallest["surface"], smallest["vertex"]))

    def test_the_volume_of_a_folder_is_that_of_its_joints(self):
        rows, every = self.ask_all("volume", "volume", "--width", "0.3"), self.root / "volume"
        self.assertEqual([row.pop("joint") for row in rows], ["a_right", "b_left"])
        for row, name in zip(rows, ("a_right", "b_left")):
            said, _ = self.ask(f"volume_{name}", name, "volume", "--width", "0.3")
            alone = self.root / f"volume_{name}"
            self.assertEqual(list(row), ["share_low", "share_high", "reachable_low", "reachable_high", "unknown", "open"])
            self.assertEqual([float(cell) for cell in row.values()], [said[key] for key in row])
            for of in (alone, every / name):
                self.assertEqual(sorted(file.name for file in of.iterdir()), ["mobility.svg", "summary.json", "volume.csv", "volume.json", "volume.svg"])
            for file in ("volume.csv", "volume.json", "volume.svg"):
                self.assertEqual((every / name / file).read_bytes(), (alone / file).read_bytes(), file)

    def same_files(self, folder, other, *but):
        files = sorted(file.name for file in other.iterdir())
        self.assertEqual(sorted(file.name for file in folder.iterdir()), files)
        for file in set(files) - set(but):
            self.assertEqual((folder / file).read_bytes(), (other / file).read_bytes(), file)

    def test_changes_of_a_folder_are_those_of_its_joints(self):
        required = ("--require", "flexion=100,internal_rotation=25")
        numbers = {
            "resect": lambda said: [*said["volume_mm3"], *said["area_mm2"], *said["depth_mm"]],
            "orient": lambda said: [*said["as_scanned"].values(), *said["area_deg2"].values()],
        }
        for command, more in (("resect", required), ("orient", (*required, "--tilt", "5"))):
            rows = {row.pop("joint"): row for row in self.ask_all(command, command, *more)}
            self.assertEqual(list(rows), ["a_right", "b_left"])
            for name, row in rows.items():
                said, _ = self.ask(f"{command}_{name}", name, command, *more)
                self.assertEqual([cell if cell[0].isalpha() else float(cell) for cell in row.values()], numbers[command](said))
                self.same_files(self.root / command / name, self.root / f"{command}_{name}", "summary.json")

    def test_cut_sockets_of_a_folder_have_an_area_and_without_a_wall_no_volume(self):
        row = self.ask_all("rims", "resect", "--cut", "socket", "--require", "flexion=90,internal_rotation=20")[1]
        self.assertTrue(0 < float(row["area_low_mm2"]) <= float(row["area_high_mm2"]))
        self.assertEqual(row["volume_high_mm3"], "")
        self.assertEqual(sorted(file.name for file in (self.root / "rims/b_left").iterdir()), ["resected_socket.ply", "resection.json", "summary.json"])
        said = json.loads((self.root / "rims/b_left/resection.json").read_text())
        self.assertEqual((said["surface"], said["volume_mm3"]), ("socket", None))
        for leg in said["legs"]:
            self.assertGreater(leg["after"]["low_deg"], leg["required_deg"])

    def test_a_joint_that_a_question_refuses_is_left_out_by_name(self):
        bones = self.root / "sideless"
        for name in ("a_right", "b_left"):
            (bones / name).mkdir(parents=True)
            for surface in ("ball.ply", "socket.ply"):
                (bones / name / surface).write_bytes((self.bones / name / surface).read_bytes())
        (bones / "b_left/subject.json").write_bytes((self.bones / "b_left/subject.json").read_bytes())
        done = run(IMPINGE, "orient", "--joints", bones, "--out", self.root / "sides", "--require", "flexion=90")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, rf"left out: {bones}/a_right: .*side")
        self.assertEqual([path.name for path in (self.root / "sides").iterdir() if path.is_dir()], ["b_left"])

    def test_a_generated_hip_has_its_measures(self):
        folder = self.root / "normal"
        run(IMPINGE, "hip", "normal", "--faces", 12000, "--out", folder)
        done = run(IMPINGE, "measure", folder / "ball.ply", folder / "socket.ply", "--side", "right", "--out", self.root / "measures")
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = json.loads((self.root / "measures/summary.json").read_text())["answer"]
        rows = {row["measure"]: row for row in rows_of(self.root / "measures/measures.csv")}
        self.assertEqual(list(rows), MEASURES)
        self.assertEqual(list(rows["version"]), ["joint", "measure", "value", "uncertainty", "unit", "state", *PUBLISHED])
        for name, truth, most in (("head_radius", 24.0, 0.05), ("head_neck_offset", 9.1, 0.05), ("neck_shaft_angle", 128.0, 0.5),
                                  ("femoral_torsion", 12.0, 0.5), ("socket_radius", 28.5, 0.05), ("inclination", 54.0, 0.5),
                                  ("version", 19.0, 0.5), ("half_opening", 87.0, 0.5), ("lateral_centre_edge", 32.7, 0.5)):
            # A generated socket ends at its rim.
            at_end = name in ("inclination", "version", "half_opening", "lateral_centre_edge")
            self.assertEqual(rows[name]["state"], "measured to the end of the mesh" if at_end else "measured", name)
            self.assertAlmostEqual(float(rows[name]["value"]), truth, delta=most, msg=name)
            self.assertGreaterEqual(float(rows[name]["uncertainty"]), 0)
        self.assertEqual([m["measure"] for m in summary["measures"]], MEASURES)
        self.assertIn("neck_shaft_angle    128 +- ", done.stdout)
        self.assertIn("deg; published: median 122.2, quartiles 117.9 and 125.6 (Hartel 2016)\n", done.stdout)
        self.assertIn("deg; published: mean 40.9, sd 7 (Hack 2010)\n", done.stdout)
        for said in summary["measures"]:
            row = rows[said["measure"]]
            self.assertEqual([number(row[key]) for key in PUBLISHED[:5]] + [row[key] or None for key in PUBLISHED[5:]],
                             [said[key] for key in PUBLISHED])
        self.same_as_the_cohort_study(rows)

    def same_as_the_cohort_study(self, rows):
        """Whose inputs and comparison have the same numbers, and sources, by hand."""
        study = json.loads((ROOT / "experiments/27_cohort/study.json").read_text())["parameters"]
        for name in ("version", "lateral_centre_edge", "half_opening"):
            self.assertEqual([number(rows[name][key]) for key in ("published_mean", "published_sd")],
                             [study[name]["mean"], study[name]["sd"]])
            self.assertEqual(rows[name]["published_source"].split(",")[0], re.search(r"[A-Z][a-z]+ 20\d\d", study[name]["source"])[0])
        for name in ("neck_shaft_angle", "femoral_torsion"):
            row, source = rows[name], study[name]["source"]
            self.assertEqual(source.partition(" of ")[0],
                             f"median {row['published_median']}, quartiles {row['published_lower_quartile']} and {row['published_upper_quartile']}")
            self.assertEqual(number(row["published_median"]), study[name]["mean"])
            self.assertIn(source.rpartition(" ")[2], row["published_source"])
            self.assertEqual(row["published_mean"], "")
        compared = dict(re.findall(r'"(alpha at [\d:]+, (?:mean|sd))": \(([\d.]+), HACK', (ROOT / "analysis/common/cohort.py").read_text()))
        for name, time in (("alpha_at_3", "3:00"), ("alpha_at_1_30", "1:30")):
            self.assertEqual([number(rows[name][key]) for key in ("published_mean", "published_sd")],
                             [number(compared[f"alpha at {time}, {what}"]) for what in ("mean", "sd")])
        with_source = {name for name, row in rows.items() if row["published_source"]}
        self.assertEqual(with_source, {"version", "lateral_centre_edge", "half_opening", "neck_shaft_angle", "femoral_torsion", "alpha_at_3", "alpha_notzli",
                                       "alpha_at_1_30"})

    def test_measures_of_a_folder_are_those_of_its_joints(self):
        table = self.ask_all("all_measures", "measure")
        for name in ("a_right", "b_left"):
            self.ask("one_measured", name, "measure")
            single = rows_of(self.root / "one_measured/measures.csv")
            self.assertEqual([row["value"] for row in table if row["joint"] == name], [row["value"] for row in single])
            self.assertEqual(len(single), len(MEASURES))

    def test_what_a_mesh_does_not_carry_is_refused(self):
        folder = self.root / "stump"
        run(IMPINGE, "hip", "normal", "--set", "shaft_length=0", "--faces", 6000, "--out", folder)
        done = run(IMPINGE, "measure", folder / "ball.ply", folder / "socket.ply", "--side", "right", "--out", self.root / "stump_out")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = {row["measure"]: row for row in rows_of(self.root / "stump_out/measures.csv")}
        for name in ("neck_shaft_angle", "femoral_torsion"):
            self.assertEqual((rows[name]["value"], rows[name]["state"]), ("", "refused: the mesh has no straight shaft"))
        self.assertEqual(rows["version"]["state"], "measured to the end of the mesh")

    def test_a_folder_that_cannot_be_used_is_refused(self):
        for words, said in (
            ((self.root / "nowhere",), "cannot be read"),
            ((self.root,), "no folder in it holds a joint"),
            ((self.bones, "--centre", "0,0,0"), "--centre excludes --joints"),
        ):
            done = run(IMPINGE, "touch", "--joints", *words, "--out", self.root / "refused")
            self.assertIn(said, done.stderr)
            self.assertIn(done.returncode, (1, 2))
            self.assertEqual(done.stderr.count("\n"), 1)
            self.assertFalse((self.root / "refused").exists())

    def hips(self, name, **described):
        """A folder of the left hip, once for each description; None has no subject.json."""
        folder = self.root / name
        for joint, said in described.items():
            (folder / joint).mkdir(parents=True)
            for mesh in ("ball.ply", "socket.ply"):
                (folder / joint / mesh).write_bytes((self.bones / "b_left" / mesh).read_bytes())
            if said is not None:
                (folder / joint / "subject.json").write_text(json.dumps({"side": "left", "center_of_rotation_mm": [0, 0, 0], **said}))
        return folder

    def documents(self, *words):
        """Of the joints of a folder, by name, and what was said besides."""
        done = run(IMPINGE, *words, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return {Path(one["joint"]["ball"]["mesh"]).parent.name: one for one in json.loads(done.stdout)["documents"]}, done.stderr

    def test_all_keys_of_a_description_count(self):
        """As the options of the same names do, of their joint alone; an option of the command counts before them."""
        said = {"landmarks": "marks.csv", "socket_part": ["spur.obj"], "ball_part": "knob.obj", "cartilage_mm": 1.5}
        folder = self.hips("keys", all=said, none={})
        marks = {"asis_left": (-30, 50, 80), "asis_right": (210, 50, 80), "pubic_tubercle_left": (65, 60, -10), "pubic_tubercle_right": (115, 60, -10),
                 "epicondyle_medial": (45, -25, -400), "epicondyle_lateral": (-40, -45, -400)}
        (folder / "all/marks.csv").write_text("label,x,y,z\n" + "".join(f"{label},{x},{y},{z}\n" for label, (x, y, z) in marks.items()))
        for name, y in (("spur", 60), ("knob", -60)):
            (folder / f"all/{name}.obj").write_text(f"v 0 {y} 0\nv 9 {y} 0\nv 0 {y + 9} 0\nv 0 {y} 9\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
        found, _ = self.documents("limits", "--joints", folder, "--motions", "flexion", "--out", self.root / "keys_out")
        ball, socket = (folder / "all" / mesh for mesh in ("ball.ply", "socket.ply"))
        options = ("--side", "left", "--centre", "0,0,0", "--motions", "flexion", "--json")
        alone = json.loads(run(IMPINGE, "limits", ball, socket, *options).stdout)
        more = ("--landmarks", folder / "all/marks.csv", "--socket-part", folder / "all/spur.obj", "--ball-part", folder / "all/knob.obj", "--cartilage", 1.5)
        asked = json.loads(run(IMPINGE, "limits", ball, socket, *options, *more).stdout)
        for key in ("joint", "request", "answer"):
            self.assertEqual(found["all"][key], asked[key])
        self.assertEqual((found["none"]["request"], found["none"]["answer"]), (alone["request"], alone["answer"]))
        self.assertNotEqual(asked["answer"], alone["answer"])
        found, _ = self.documents("limits", "--joints", folder, "--motions", "flexion", "--cartilage", "0.5", "--out", self.root / "keys_out")
        self.assertEqual([one["request"]["cartilage_mm"] for one in found.values()], [0.5, 0.5])

    def test_the_cartilage_of_a_scan_is_that_of_its_joint(self):
        folder = self.root / "scans"
        for name, space in (("first", 6), ("second", 3)):
            self.assertEqual(run(IMPINGE, "hip", "normal", "--set", f"joint_space={space}", "--faces", 600, "--out", folder / name).returncode, 0)
        found, _ = self.documents("limits", "--joints", folder, "--cartilage", "scan", "--motions", "flexion", "--out", self.root / "scans_out")
        self.assertEqual([line for one in found.values() for line in one["joint"]["warnings"] if "cartilage" in line], [])
        first, second = (one["request"]["cartilage_mm"] for one in found.values())
        self.assertTrue(2 < second < 4 < first, (first, second))

    def test_answers_are_no_joints(self):
        """Neither written among the joints nor, where one lies there, read as one."""
        folder = self.hips("posed", hip={})
        for mesh in ("ball.ply", "socket.ply"):
            (folder / "hip" / mesh).rename(folder / "hip" / {"ball.ply": "femoral_head.ply", "socket.ply": "acetabulum.ply"}[mesh])
        (self.root / "link").symlink_to(folder)
        for out in (folder, folder / "out", folder / "hip", self.root / "link/out"):
            done = run(IMPINGE, "gaps", "--joints", folder, "--pose", "flexion=60", "--precision", "5", "--out", out)
            self.assertEqual((done.returncode, done.stderr), (1, f"impinge: error: {out}: lies in the folder of the joints, as if its meshes were joints; "
                                                                 "choose another folder with --out\n"))
        self.assertEqual([path.name for path in folder.iterdir()], ["hip"])
        meshes = (folder / "hip/femoral_head.ply", folder / "hip/acetabulum.ply")
        for out in ("hip", "pose60"):
            done = run(IMPINGE, "gaps", *meshes, "--pose", "flexion=60", "--precision", "5", "--out", folder / out)
            self.assertEqual(done.returncode, 0, done.stderr)
            found = run(IMPINGE, "touch", "--joints", folder, "--out", self.root / "posed_out")
            self.assertIn({"hip": f"{folder}/hip: has both ball.ply and femoral_head.ply; leave the one that is meant\n",
                           "pose60": f"{folder}/pose60/ball.ply: is of the answer in summary.json, and may be moved; "
                                     "give the mesh that was asked about\n"}[out], found.stderr)
            for mesh in ("ball.ply", "socket.ply") if out == "hip" else ():
                (folder / out / mesh).unlink()

    @unittest.skipUnless(os.environ.get("IMPINGE_BONES"), "no real joints")
    def test_real_joints_have_measures_that_agree_or_are_refused(self):
        """The whole pelvis and what was cut out of it have one socket."""
        for folder in Path(os.environ["IMPINGE_BONES"]).iterdir():
            sockets = [folder / f"{name}.ply" for name in ("acetabulum_facing", "acetabulum", "pelvis")]
            femur = folder / "femur.ply"
            if not femur.is_file() or not sockets[0].is_file():
                continue
            said = json.loads((folder / "subject.json").read_text())
            axes = "".join(word[0].upper() for word in said["axes"].replace("patient ", "").split() if word[0] in "rlapsi"
                           and word.strip(",") in ("right", "left", "anterior", "posterior", "superior", "inferior"))
            found = []
            for socket in filter(Path.is_file, sockets):
                done = run(IMPINGE, "measure", femur, socket, "--side", said["side"], "--axes", axes,
                           "--out", self.root / "real")
                self.assertEqual(done.returncode, 0, done.stderr)
                found.append({row["measure"]: row for row in rows_of(self.root / "real/measures.csv")})
            for name in ("version", "inclination", "lateral_centre_edge", "socket_radius"):
                values = [float(rows[name]["value"]) for rows in found if rows[name]["value"]]
                if len(values) > 1:
                    self.assertLess(max(values) - min(values), 5, (folder.name, name, values))


if __name__ == "__main__":
    unittest.main()
