# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames that files bring with them: SPACE= in the headers that 3D Slicer writes, and landmarks. A joint in another frame
has the limits of the joint that it was made from. IMPINGE names the program, HIP the folder of a right hip.
"""

from __future__ import annotations

import csv
import json
import os
import struct
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

IMPINGE = os.environ["IMPINGE"]
HIP = Path(os.environ["HIP"])
LPS = np.diag([-1.0, -1.0, 1.0])


def turn(axis: int, degrees: float) -> np.ndarray:
    """Right-handed, about a coordinate axis."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    matrix = np.eye(3)
    a, b = (axis + 1) % 3, (axis + 2) % 3
    matrix[[a, b, a, b], [a, b, b, a]] = c, c, -s, s
    return matrix


def femur_turn(flexion: float, abduction: float, internal: float, side: str) -> np.ndarray:
    """By words: the femur of a right hip abducts towards +x and turns its front towards -x; mirrored on the left."""
    mirror = -1 if side == "left" else 1
    return turn(0, flexion) @ turn(1, -mirror * abduction) @ turn(2, mirror * internal)


def ply_text(vertices, faces, comment=""):
    head = f"ply\nformat ascii 1.0\ncomment VTK generated PLY File\n{comment}element vertex {len(vertices)}\n"
    head += "property float x\nproperty float y\nproperty float z\n"
    head += f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    rows = [" ".join(map(repr, map(float, v))) for v in vertices] + [f"3 {a} {b} {c}" for a, b, c in faces]
    return (head + "\n".join(rows) + "\n").encode()


def stl_bytes(vertices, faces, header):
    rows = [struct.pack("<12fH", 0, 0, 0, *vertices[face].ravel(), 0) for face in faces]
    return header.ljust(80, b"\0") + struct.pack("<I", len(faces)) + b"".join(rows)


def stl_text(vertices, faces, header):
    corner = "    vertex {} {} {}\n"
    facets = ["  facet normal 0 0 0\n   outer loop\n" + "".join(corner.format(*map(float, vertices[v])) for v in face)
              + "   endloop\n  endfacet\n" for face in faces]
    return f"solid {header}\n{''.join(facets)}endsolid\n".encode()


def obj_text(vertices, faces, header):
    rows = ["v {} {} {}".format(*map(float, v)) for v in vertices] + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
    return (f"# {header}\n\nmtllib ball.mtl\n\n" + "\n".join(rows) + "\n").encode()


# A right pelvis and femur that stand straight, about the centre of the right hip.
STANDING = {
    "asis_right": (40.0, 45.0, 75.0),
    "asis_left": (-210.0, 45.0, 75.0),
    "pubic_tubercle_right": (-60.0, 45.0, -15.0),
    "pubic_tubercle_left": (-110.0, 45.0, -15.0),
    "epicondyle_medial": (-40.0, 0.0, -400.0),
    "epicondyle_lateral": (40.0, 0.0, -400.0),
}


class Frames(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory(prefix="impinge-frames-")
        cls.addClassCleanup(holder.cleanup)
        cls.root = Path(holder.name)
        cls.meshes = {}
        for name in ("ball", "socket"):
            cls.meshes[name] = cls.read_ply(HIP / f"{name}.ply")
        cls.truth = cls("test_what_is_said_otherwise_stays").limit("truth", *cls.write(cls, "truth", lambda v, f: ply_text(v, f)))

    @staticmethod
    def read_ply(path):
        """As `impinge hip` writes it: binary, doubles, triangles."""
        data = path.read_bytes()
        head, body = data.split(b"end_header\n", 1)
        counts = [int(line.split()[-1]) for line in head.decode().splitlines() if line.startswith("element")]
        vertices = np.frombuffer(body, "<f8", 3 * counts[0]).reshape(-1, 3)
        faces = np.frombuffer(body, np.dtype([("n", "u1"), ("v", "<i4", 3)]), counts[1], 24 * counts[0])["v"]
        return vertices, faces

    def write(self, name, text, kind="ply", ball=np.eye(3), socket=np.eye(3)):
        files = []
        (self.root / name).mkdir(exist_ok=True)
        for part, move in (("ball", ball), ("socket", socket)):
            vertices, faces = self.meshes[part]
            path = self.root / name / f"{part}.{kind}"
            path.write_bytes(text(vertices @ move.T, faces))
            files.append(path)
        return files

    def asked(self, command, name, ball, socket, *more):
        words = [IMPINGE, command, ball, socket, "--side", "right", "--out", self.root / name / "out", *more]
        return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)

    def impinge(self, *words):
        """The summary, and what is said."""
        done = self.asked(*words)
        if done.returncode != 0:
            raise AssertionError(done.stderr)
        return json.loads((self.root / words[1] / "out/summary.json").read_text()), done.stdout

    def limit(self, name, ball, socket, *more):
        found, said = self.impinge("limits", name, ball, socket, "--centre", "0,0,0", "--motions", "internal_rotation",
                                   "--pose", "flexion=60,abduction=-10", *more)
        return found["answer"]["limits"][0]["low_deg"], found["joint"], said

    def same_limit(self, name, files, *more):
        low, found, said = self.limit(name, *files, *more)
        self.assertAlmostEqual(low, self.truth[0], delta=1e-3)
        return found, said

    def test_slicers_headers_are_used_and_said(self):
        self.assertEqual(self.truth[1]["axes"], "RAS")
        self.assertNotIn("axes", self.truth[2])
        header = "3D Slicer output. SPACE=LPS"
        for name, kind, text in (
            ("ply", "ply", lambda v, f: ply_text(v, f, "comment SPACE=LPS\n")),
            ("stl", "stl", lambda v, f: stl_bytes(v, f, header.encode())),
            ("stl_text", "STL", lambda v, f: stl_text(v, f, header)),
            ("obj", "obj", lambda v, f: obj_text(v, f, header)),
        ):
            with self.subTest(name):
                found, said = self.same_limit(name, self.write(name, text, kind, LPS, LPS))
                self.assertEqual(found["axes"], "LPS")
                self.assertIn("axes                LPS, as the headers of the meshes say\n", said)
                self.assertFalse([w for w in found["warnings"] if "no right socket" in w])

    def test_a_cut_mesh_lies_in_the_frame_of_its_files_and_lets_the_joint_turn(self):
        """As far as was required, before it does not: of a hip that is not about the origin, in LPS."""
        made = self.root / "walled"
        subprocess.run([IMPINGE, "hip", "cam", "--set", "wall_thickness=3", "--faces", "800", "--out", made],
                       check=True, capture_output=True)
        walled = {name: self.read_ply(made / f"{name}.ply") for name in ("ball", "socket")}
        for cut, more, meshes in (("ball", ("--least",), walled), ("socket", (), self.meshes)):
            files = {}
            for name, (vertices, faces) in meshes.items():
                files[name] = self.root / f"{cut}_{name}.ply"
                files[name].write_bytes(ply_text(vertices @ LPS + (3, -70, 12), faces, "comment SPACE=LPS\n"))
            summary, told = self.impinge("resect", cut, *files.values(), "--require", "flexion=90,internal_rotation=20", "--cut", cut, *more)
            folder, said = self.root / cut / "out", summary["answer"]
            self.assertEqual((said["surface"], said, summary["request"]["require"]),
                             (cut, json.loads((folder / "resection.json").read_text()), [{"flexion": 90, "abduction": 0, "internal_rotation": 20}]))
            self.assertIn("nothing in this may guide the treatment", told)
            centre = ",".join(map(str, summary["joint"]["centre"]["position"]))
            for socket_or_ball, limited in ((files[cut], True), (folder / f"resected_{cut}.ply", False)):
                again, _ = self.impinge("limits", "again", *({**files, cut: socket_or_ball}).values(), "--axes", "LPS", "--centre", centre,
                                        "--motions", "internal_rotation", "--pose", "flexion=90")
                low = again["answer"]["limits"][0]["low_deg"]
                self.assertEqual(low < 20, limited, (cut, low))
            if cut == "ball":
                self.assertLessEqual(said["least"]["volume_mm3"][1], said["volume_mm3"][1])
                swept = (folder / "swept.csv").read_text().splitlines()
                self.assertEqual(swept[0], "a_x,a_y,a_z,b_x,b_y,b_z,c_x,c_y,c_z,from_mm,to_mm")
                self.assertGreaterEqual(len(swept) - 1, said["least"]["cells"])
                self.assertIn("least cut of all    ", told)
                self.assertGreater(said["neck"]["after_mm"], said["neck"]["least_mm"])
            else:
                self.assertIn("no closed mesh", said["volume_why"])

    def test_the_map_of_orientations_is_whole(self):
        """The cam's cup of 54 and 19 degrees, seen from above, has 15.7 of anteversion."""
        files = self.write("cup", lambda v, f: ply_text(v, f, "comment SPACE=LPS\n"), "ply", LPS, LPS)
        summary, told = self.impinge("orient", "cup", *files, "--require", "flexion=90,internal_rotation=25", "--tilt", 5)
        said = json.loads((self.root / "cup/out/orientation.json").read_text())
        self.assertIn("nothing in this may guide the treatment", told)
        self.assertEqual((summary["request"]["tilt_deg"], summary["answer"]), (5, said))
        self.assertAlmostEqual(said["as_scanned"]["anteversion_deg"], 15.7, delta=1)
        with (self.root / "cup/out/orientation.csv").open() as file:
            squares = list(csv.DictReader(file))
        self.assertEqual(list(squares[0]), ["inclination_deg", "anteversion_deg", "half_width_deg", "state", "motion"])
        for state, area in said["area_deg2"].items():
            self.assertAlmostEqual(sum(4 * float(row["half_width_deg"]) ** 2 for row in squares if row["state"] == state), area, delta=1e-6)
        self.assertAlmostEqual(sum(said["area_deg2"].values()), 8100, delta=1e-6)
        self.assertTrue(said["area_deg2"]["free"] > 500 and said["area_deg2"]["open"] < 1500, said["area_deg2"])

    def test_what_is_said_otherwise_stays(self):
        for name, text in (
            ("none", lambda v, f: ply_text(v, f, "comment COLORSPACE=LPS\n")),
            ("longer", lambda v, f: ply_text(v, f, "comment SPACE=LPSX\n")),
            ("ras", lambda v, f: ply_text(v, f, "comment SPACE=RAS\n")),
        ):
            self.assertEqual(self.same_limit(name, self.write(name, text))[0]["axes"], "RAS")
        ball, _ = self.write("half", lambda v, f: ply_text(v, f, "comment SPACE=LPS\n"), "ply", LPS, LPS)
        _, socket = self.write("other_half", lambda v, f: ply_text(v, f), "ply", LPS, LPS)
        self.assertEqual(self.same_limit("half", (ball, socket))[0]["axes"], "LPS")
        self.assertEqual(self.same_limit("half", (ball, socket), "--axes", "LPS")[0]["axes"], "LPS")

    def test_contradictions_are_refused(self):
        lps = self.write("lps", lambda v, f: ply_text(v, f, "comment SPACE=LPS\n"))
        ras = self.write("ras", lambda v, f: ply_text(v, f, "comment SPACE=RAS\n"))
        bare = self.write("bare", lambda v, f: ply_text(v, f))
        both = self.write("both", lambda v, f: ply_text(v, f, "comment SPACE=RAS\nobj_info SPACE=LPS\n"))
        for files, more, said in (
            (lps, ("--axes", "RAS"), f"{lps[0]}: its header says SPACE=LPS, and --axes says RAS; leave --axes out, or correct "
                                     "the header"),
            ((lps[0], ras[1]), (), f"{ras[1]}: its header says SPACE=RAS, and that of the ball SPACE=LPS; export both in one "
                                   "frame"),
            (ras, ("--socket-part", lps[0]), f"{lps[0]}: its header says SPACE=LPS, and that of the ball SPACE=RAS; export both in one frame"),
            (bare, ("--ball-part", ras[0], "--ball-part", lps[1]),
             f"{lps[1]}: its header says SPACE=LPS, and that of {ras[0].name} SPACE=RAS; export both in one frame"),
            (bare, ("--ball-part", lps[0], "--axes", "RAS"), f"{lps[0]}: its header says SPACE=LPS, and --axes says RAS; leave --axes out, or correct "
                                                             "the header"),
            (both, (), f"{both[0]}: its header says both SPACE=RAS and SPACE=LPS; leave the one that is true"),
        ):
            done = self.asked("touch", "refused", *files, *more)
            self.assertEqual((done.returncode, done.stderr), (1, f"impinge: error: {said}\n"))

    def posed(self, name, landmarks, body, femur, file="points.csv", meshes="RAS"):
        """Files of the joint with the femur turned and the whole body turned, and its landmarks beside it."""
        space = LPS if meshes == "LPS" else np.eye(3)
        files = self.write(name, lambda v, f: ply_text(v, f), "ply", space @ body @ femur, space @ body)
        points = {label: body @ (femur if "epicondyle" in label else np.eye(3)) @ np.array(at)
                  for label, at in landmarks.items()}
        path = self.root / name / file
        if path.suffix == ".json":
            control = [{"id": str(k), "label": label.upper().replace("_", " "), "position": list(LPS @ at)}
                       for k, (label, at) in enumerate(points.items())] + [{"id": "9", "label": "L4"}]
            path.write_text(json.dumps({"markups": [{"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": control}]}))
        else:
            rows = [f"{label},{','.join(map(repr, map(float, space @ at)))}\n" for label, at in points.items()]
            path.write_text("label,x,y,z\n" + "".join(rows) + "sacrum,1,2,3\n")
        return (*files, path)

    def test_landmarks_bring_a_posed_joint_back_to_neutral(self):
        body = turn(2, 4) @ turn(1, -3) @ turn(0, -12)  # about x by -12: the upper end forward
        femur = femur_turn(14, -6, 9, "right")
        up = body @ (0, 0, 1)
        for name, file, meshes in (("csv", "points.csv", "RAS"), ("markups", "points.mrk.json", "RAS"),
                                   ("markups_lps", "points.mrk.json", "LPS"), ("csv_lps", "points.csv", "LPS")):
            with self.subTest(name):
                ball, socket, points = self.posed(name, STANDING, body, femur, file, meshes)
                found, said = self.same_limit(name, (ball, socket), "--landmarks", points, "--axes", meshes)
                marks = found["landmarks"]
                self.assertAlmostEqual(marks["pelvic_tilt_deg"], np.degrees(np.arctan2(up[1], up[2])), delta=1e-6)
                self.assertGreater(marks["pelvic_tilt_deg"], 10)
                for key, angle in (("flexion", 14), ("abduction", -6), ("internal_rotation", 9)):
                    self.assertAlmostEqual(marks[f"scanned_{key}_deg"], angle, delta=1e-6)
                self.assertIn("the femur at flexion 14.0, abduction -6.0, internal rotation 9.0: angles are counted from neutral",
                              said)

    def test_without_epicondyles_angles_begin_at_the_scan(self):
        pelvis = {label: at for label, at in STANDING.items() if "epicondyle" not in label}
        ball, socket, points = self.posed("pelvis", pelvis, turn(0, -20), np.eye(3))
        found, said = self.same_limit("pelvis", (ball, socket), "--landmarks", points)
        self.assertIsNone(found["landmarks"]["scanned_flexion_deg"])
        warning = (f"{points}: has no epicondyles, so angles are counted from the scan; its labels sacrum are of no landmark: "
                   "if two of them are meant, call them epicondyle_medial and epicondyle_lateral")
        self.assertIn(warning, found["warnings"])
        self.assertIn("landmarks           pelvic tilt 20.0 degrees in the scan: angles are counted from the pose of the scan",
                      said)
        self.assertEqual(self.asked("report", "pelvis", ball, socket, "--landmarks", points, "--width", 1).returncode, 0)
        self.assertIn("<dt>Angles are counted from</dt><dd>the pose of the scan (pelvic tilt 20.0° in the scan)</dd>",
                      (self.root / "pelvis/out/report.html").read_text())

    def test_landmarks_that_cannot_be_used_are_refused(self):
        swapped = dict(STANDING, asis_right=STANDING["asis_left"], asis_left=STANDING["asis_right"])
        pelvis = {label: at for label, at in STANDING.items() if "epicondyle" not in label}
        for name, landmarks, said in (
            ("missing", {k: v for k, v in STANDING.items() if k != "asis_left"}, "the landmark asis_left is missing; mark it"),
            ("one", {k: v for k, v in STANDING.items() if k != "epicondyle_medial"},
             "the landmark epicondyle_medial is missing; mark it"),
            ("swapped", swapped, "the right landmarks of the pelvis lie to the left of the left ones; check the labels and "
                                 "the axes"),
            ("above", dict(STANDING, pubic_tubercle_right=(-60, 45, 200), pubic_tubercle_left=(-110, 45, 200)),
             "the ASIS lie below the pubic tubercles; check the labels and the axes"),
            ("close", dict(STANDING, epicondyle_medial=(30, 0, -400)),
             "the landmarks epicondyle_medial and epicondyle_lateral are closer than 20 mm; check them"),
            ("tenths", {k: 10.0 * np.array(at) for k, at in STANDING.items()},
             "the landmarks asis_left and asis_right are 2500 mm apart; give all places in mm"),
            ("micrometres", dict(STANDING, epicondyle_medial=(-4e4, 0, -4e5), epicondyle_lateral=(4e4, 0, -4e5)),
             "the landmarks epicondyle_medial and epicondyle_lateral are 80000 mm apart; give all places in mm"),
            ("inside", dict(STANDING, epicondyle_medial=(40, 0, -400), epicondyle_lateral=(-40, 0, -400)),
             "the lateral epicondyle lies medially; check the labels, the side and the axes"),
            ("line", dict(pelvis, asis_left=(-210, 45, 25), pubic_tubercle_right=(-300, 45, 7), pubic_tubercle_left=(-350, 45, -3)),
             "the landmarks of the ASIS and of the pubic tubercles lie on one line within 20 mm; check them"),
            ("axis", dict(STANDING, epicondyle_medial=(0, 0, -400), epicondyle_lateral=(1, 0, -350)),
             "the landmarks of the epicondyles and the centre of rotation lie on one line within 20 mm; check them"),
            ("elsewhere", {k: np.array(at) + (1e4, -1e4, 1e4) for k, at in STANDING.items() if "asis" not in k and "pubic" not in k} | pelvis,
             "the epicondyles are too far from the centre of rotation for a femur; check that landmarks and meshes are of one scan"),
            ("other hip", {k: np.array(at) + (170, 0, 0) for k, at in pelvis.items()},
             "the centre of rotation lies on the other side of the middle of both ASIS; check the side and the axes, and that "
             "landmarks and meshes are of one scan"),
            ("knee up", dict(STANDING, epicondyle_medial=(-40, 0, 400), epicondyle_lateral=(40, 0, 400)),
             "the knee lies above the hip, and behind; check the labels and the axes"),
        ):
            with self.subTest(name):
                ball, socket, points = self.posed(name, landmarks, np.eye(3), np.eye(3))
                done = self.asked("touch", name, ball, socket, "--landmarks", points)
                self.assertEqual((done.returncode, done.stderr.splitlines()[-1]), (1, f"impinge: error: {points}: {said}"))

    def test_a_file_of_no_landmarks_is_refused(self):
        files = self.write("files", lambda v, f: ply_text(v, f))
        path = self.root / "files/headless.csv"
        path.write_text("asis_right,1,2,3\n")
        done = self.asked("touch", "files", *files, "--landmarks", path)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.splitlines()[-1], f"impinge: error: {path}: line 1 does not name the columns label,x,y,z, label,r,a,s"
                         " or label,l,p,s; give markups of 3D Slicer (.mrk.json, .fcsv, or its table label,r,a,s or label,l,p,s) or a CSV label,x,y,z in mm")

    def test_matrices_begin_at_the_scan_and_are_refused_beside_a_femur(self):
        ball, socket, points = self.posed("matrices", STANDING, np.eye(3), np.eye(3))
        poses = self.root / "matrices/poses.csv"
        poses.write_text("1,0,0,0,0,1,0,0,0,0,1,0\n")
        done = self.asked("poses", "matrices", ball, socket, "--landmarks", points, "--poses", poses)
        self.assertIn("give angles, or leave the landmarks out", done.stderr)
        self.assertEqual(done.returncode, 1)
        done = self.asked("poses", "matrices", ball, socket, "--landmarks", points, "--path", "rot_x=0..90/30")
        self.assertIn("path: its turns begin at the pose of the scan", done.stderr)
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
