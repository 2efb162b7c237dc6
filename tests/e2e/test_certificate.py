# SPDX-License-Identifier: GPL-3.0-or-later
"""impinge certify, and what check_certificate.py and .cpp say of it: accepted as it is, refused after any change that makes it false.

IMPINGE and CHECK_CERTIFICATE name the programs. With IMPINGE_BONES set, real joints are certified too.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import re
import struct
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from generated_pair import IMPINGE, GeneratedPair, run  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
CHECKER = ROOT / "experiments" / "check_certificate.py"
FAST = os.environ["CHECK_CERTIFICATE"]
BONES = os.environ.get("IMPINGE_BONES", "")
LIMIT = ["--motion", "internal_rotation", "--pose", "flexion=80"]


def read_mesh(file: Path) -> tuple[list, list]:
    """Points and faces of a PLY that impinge hip wrote."""
    head, body = file.read_bytes().split(b"end_header\n")
    vertices, faces = (int(head.split(kind)[1].split()[0]) for kind in (b"element vertex ", b"element face "))
    assert len(body) == 24 * vertices + 13 * faces
    points = [struct.unpack_from("<3d", body, 24 * k) for k in range(vertices)]
    return points, [struct.unpack_from("<3i", body, 24 * vertices + 13 * k + 1) for k in range(faces)]


def write_obj(file: Path, points, faces) -> Path:
    text = "".join("v {} {} {}\n".format(*p) for p in points)
    file.write_text(text + "".join("f {} {} {}\n".format(*(i + 1 for i in f)) for f in faces))
    return file


class Certificate(GeneratedPair):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        bone = ["greater_trochanter_width=30", "lesser_trochanter_height=8", "aiis_height=10"]
        for name, words in {"pair": ["cam"], "with": ["normal", *(word for one in bone for word in ("--set", one))]}.items():
            made = run(IMPINGE, "hip", *words, "--faces", "600", "--out", cls.root / name)
            assert made.returncode == 0, made.stderr
        cls.with_parts = {"ball": cls.root / "with/ball.ply", "socket": cls.root / "with/socket.ply"}
        cls.greater, cls.lesser, cls.spine = (cls.root / f"with/{name}.ply" for name in ("greater_trochanter", "lesser_trochanter", "aiis"))
        cls.parts = ["--ball-part", cls.greater, "--ball-part", cls.lesser, "--socket-part", cls.spine]

    def certify(self, name: str, *words, ball=None, socket=None) -> subprocess.CompletedProcess:
        """Writes certificate.txt in a folder of that name."""
        return run(IMPINGE, "certify", ball or self.ball, socket or self.socket, "--out", self.root / name, *(() if "--side" in words else ("--side", "right")), *words)

    def made(self, name: str, *words, **files) -> list[str]:
        """The lines of a certificate."""
        done = self.certify(name, *words, **files)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"{self.root / name}/{{certificate.txt,summary.json}}\n", done.stdout)
        return (self.root / name / "certificate.txt").read_text().splitlines()

    def accepted(self, name: str, says: str, *parts, ball=None, socket=None) -> str:
        done = run(sys.executable, CHECKER, self.root / name / "certificate.txt", ball or self.ball, socket or self.socket, *parts)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout.startswith(says), done.stdout)
        fast = run(FAST, self.root / name / "certificate.txt", ball or self.ball, socket or self.socket, *parts)
        self.assertEqual((fast.returncode, fast.stderr, fast.stdout.split()[0]), (0, "", done.stdout.split(":")[0]), fast.stdout)
        return done.stdout

    def refused(self, lines: list[str], reason="", *parts, ball=None, socket=None):
        changed = self.root / "changed.txt"
        changed.write_text("\n".join(lines) + "\n")
        done = run(sys.executable, CHECKER, changed, ball or self.ball, socket or self.socket, *parts)
        self.assertEqual((done.returncode, done.stdout), (1, ""), "accepted")
        self.assertRegex(done.stderr, f"^refused: .*{reason}.*\n$")
        fast = run(FAST, changed, ball or self.ball, socket or self.socket, *parts)
        self.assertIn(fast.returncode, (1, 2))
        self.assertNotRegex(fast.stdout, "^(clear|contact)")

    def test_the_checker_is_short_and_stands_alone(self):
        lines = CHECKER.read_text().splitlines()
        self.assertLessEqual(len(lines), 250)
        imports = [line for line in lines if "import" in line.split()[:1] or line.startswith("from")]
        self.assertEqual(imports, [*(f"import {name}" for name in ("hashlib", "math", "pathlib", "struct", "sys")), "from fractions import Fraction"])

    def test_impinge_check_runs_it(self):
        lines = self.made("check", *LIMIT, *self.parts, **self.with_parts)
        words = [IMPINGE, "check", self.root / "check/certificate.txt", *self.with_parts.values()]
        done = run(*words, *self.parts)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, self.accepted("check", "clear", *self.parts, **self.with_parts))
        (self.root / "check/certificate.txt").write_text("\n".join(lines[:-1]) + "\n")
        for done in (run(*words, *self.parts), run(*words)):
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (1, "", 1))

    def test_poses(self):
        for number, (pose, says) in enumerate({
            "flexion=0": "clear", "flexion=90": "clear", "flexion=40,abduction=20,internal_rotation=10": "clear",
            "flexion=120,internal_rotation=40": "contact", "abduction=80": "contact",
        }.items()):
            with self.subTest(pose):
                self.made(f"pose_{number}", "--pose", pose)
                self.accepted(f"pose_{number}", says)

    def test_what_is_said_is_what_is_proven(self):
        """A proof of another pose, centre or file is no answer: the reader sees which one it is."""
        self.made("said", "--motion", "abduction", "--pose", "flexion=30")
        said = self.accepted("said", "clear: no two faces meet, and no piece of one body is inside a closed file of the other\n")
        kinds = dict(line.split(": ", 1) for line in said.splitlines())
        self.assertEqual(list(kinds), ["clear", "ball", "socket", "centre", "pose", "motion"])
        for side, file in (("ball", self.ball), ("socket", self.socket)):
            self.assertIn(f"{file} (sha256 {hashlib.sha256(file.read_bytes()).hexdigest()})", kinds[side])
        self.assertIn("1 pieces, 1 of 1 files closed", kinds["ball"])
        self.assertIn("1 pieces, 0 of 1 files closed, no other has an inside", kinds["socket"])
        self.assertEqual(kinds["centre"].split()[3:], "mm in the frame of the files".split())
        self.assertLess(max(abs(float(x)) for x in kinds["centre"].split()[:3]), 1e-3)
        self.assertRegex(kinds["pose"], "^the ball turned by 30 degrees about 1 0 0 from where its files have it, and shifted by 0 0 0 mm$")
        limits = run(IMPINGE, "limits", self.ball, self.socket, "--side", "right", "--json", "--motions", "abduction", "--pose", "flexion=30")
        degrees, x, y, z = map(float, re.match("from there by every angle from 0 to (\\S+) degrees about (\\S+) (\\S+) (\\S+)$", kinds["motion"]).groups())
        self.assertAlmostEqual(degrees, json.loads(limits.stdout)["answer"]["limits"][0]["low_deg"] - 0.01, delta=1e-4)
        self.assertAlmostEqual(math.hypot(x, y, z), 1.0, delta=1e-6)
        self.assertAlmostEqual(abs(y), math.cos(math.radians(30)), delta=1e-6)  # the axis between is turned with flexion

    def test_other_formats(self):
        """The same joint as text: decimals as they are written, and as an OBJ."""
        points, corners = read_mesh(self.ball)
        xyz = "".join(f"property double {axis}\n" for axis in "xyz")
        text = f"ply\nformat ascii 1.0\nelement vertex {len(points)}\n{xyz}element face {len(corners)}\nproperty list uchar int vertex_indices\nend_header\n"
        text += "".join("{} {} {}\n".format(*p) for p in points) + "".join("3 {} {} {}\n".format(*f) for f in corners)
        (self.root / "ball_text.ply").write_text(text)
        obj = write_obj(self.root / "ball.obj", points, corners).read_text()
        for name in ("ball_text.ply", "ball.obj"):
            ball = self.root / name
            for pose, says in {"flexion=70": "clear", "flexion=120,internal_rotation=40": "contact"}.items():
                self.made("format", "--pose", pose, ball=ball)
                self.accepted("format", says, ball=ball)
            ball.write_text(text.replace("end_header\n", "end_header\nnan ") if name.endswith("ply") else obj + "f 1 2 0\n")
            self.refused((self.root / "format/certificate.txt").read_text().splitlines(), ball=ball)

    @staticmethod
    def word(lines: list[str], line: int, word: int, text: str) -> list[str]:
        """The lines with one word changed."""
        words = lines[line].split()
        words[word] = text
        return lines[:line] + [" ".join(words)] + lines[line + 1 :]

    def test_what_makes_it_false_is_refused(self):
        """Each plane and each sphere is moved so far that it cuts nothing; each turn out of its arc; each node left out or doubled."""
        for name, asked in {"pose": ["--pose", "flexion=60,internal_rotation=20"], "limit": LIMIT}.items():
            lines = self.made(name, *asked)
            self.accepted(name, "clear")
            cuts = range(9, len(lines) - 1)
            self.assertGreater(len(cuts), 4)
            for k in cuts[:: 1 if name == "pose" else 12]:
                kind, *words = lines[k].split()
                with self.subTest(name=name, line=k, kind=kind):
                    self.refused(lines[:k] + lines[k + 1 :])
                    self.refused(lines[:k] + [lines[k]] + lines[k:])
                    if kind == "plane":
                        for far in (10**9, -(10**9)):
                            self.refused(self.word(lines, k, 4, str(far)), "part is (not clear|missing)|more cuts")
                        self.refused(lines[:k] + ["plane 0 0 0 0"] + lines[k + 1 :], "part is (not clear|missing)")
                    elif kind == "sphere":
                        self.refused(self.word(lines, k, 1, str(10**9)), "part is (not clear|missing)|more cuts")
                        self.refused(self.word(lines, k, 1, "-" + words[0]), "a sphere is none")
                    elif kind == "turn":
                        self.refused(self.word(lines, k, 2, "-" + words[1]), "a half angle is none")
                        self.refused(lines[:k] + ["turn 0 1"] + lines[k + 1 :], "outside of its arc")
            for k in (4, 6):  # another rotation
                self.refused(self.word(self.word(lines, k, 1, "1"), k, 2, "-2"), "part is")
            self.refused(self.word(lines, 2, 3, "14"), "part is")  # another centre
            self.refused(self.word(lines, 3, 3, "5"), "part is|shifted")

    def test_a_motion_goes_no_farther_than_proven(self):
        lines = self.made("limit", *LIMIT)
        c, s = map(int, lines[7].split()[1:])
        for degrees in (0.1, 1.0, 20.0, 170.0):  # of half the angle
            turned = complex(c, s) * complex(math.cos(math.radians(degrees)), math.sin(math.radians(degrees)))
            self.refused(lines[:7] + [f"last {round(turned.real)} {round(turned.imag)}"] + lines[8:])
        self.refused(lines[:7] + [f"last {c} {-s}"] + lines[8:], "half angle")
        self.refused(lines[:7] + [f"last {-c} {-s}"] + lines[8:], "half angle")
        self.refused(lines[:7] + ["last 0 0"] + lines[8:], "half angle")
        self.refused(self.word(lines, 5, 1, "1"), "rotation")
        self.refused(self.word(lines, 0, 3, "contact"), "no contact of a pose")

    def test_what_is_no_certificate_is_refused(self):
        lines = self.made("head", "--pose", "flexion=60")
        for line, word, text, reason in [
            (0, 2, "1", "whole"), (0, 3, "blocked", "whole"), (0, 3, "contact", "no contact"), (1, 1, "2", "it is of"), (1, 2, "0", "it is of"),
            (2, 1, "nan", "no number"), (2, 1, "1e999999999", "no number"), (2, 1, "9" * 5000, "no number"), (2, 1, "1/0", ""),
            (2, 1, "4", "part is"), (3, 1, "0.000001", "shifted|part is"), (4, 1, "1.5", "no integers"), (5, 1, "2", "rotation"), (5, 1, "0", "rotation"),
            (7, 1, "0", "half angle"), (8, 1, "0", "unit"), (8, 1, "-1024", "unit"), (8, 1, "1", "part is"), (9, 0, "cone", "no cut"), (9, 1, "1e3", "no integers"),
        ]:
            with self.subTest(line=line, text=text[:20]):
                self.refused(self.word(lines, line, word, text), reason)
        self.refused(lines[:4] + ["outer 0 0 0 0"] + lines[5:], "rotation")
        other = self.made("other", "--pose", "flexion=120,internal_rotation=40")
        self.refused(lines[:4] + other[4:5] + lines[5:], "part is")  # of a pose with contact
        self.refused(lines[:1] + other[1:], "no cut|no integers")
        self.refused(lines[:-1], "whole")
        self.refused(lines[:9] + ["end"], "missing")
        self.refused(lines[:9] + ["-", "end"], "a part is not clear: it has [1-9][0-9]* faces of the ball and [1-9]")
        self.refused([*lines[:1], *lines[2:]], "head")
        self.refused([*lines[:-1], "-", "end"], "more cuts")
        for part in ("ball", "socket"):  # the ball as both, the socket as both, and exchanged
            self.refused(lines, ball=getattr(self, part), socket=getattr(self, part))
        self.refused(lines, ball=self.socket, socket=self.ball)
        self.refused(lines, ball=self.root / "none.ply")

    def test_a_vertex_that_is_moved_across_is_refused(self):
        lines = self.made("vertex", "--pose", "flexion=60")
        for part, factor in (("ball", 1.5), ("socket", 0.5), ("ball", float("nan")), ("socket", float("inf"))):
            data = bytearray(getattr(self, part).read_bytes())
            start = data.index(b"end_header\n") + len(b"end_header\n")
            head = data[:start]
            count = int(head.split(b"element vertex ")[1].split()[0])
            refused = 0
            for vertex in range(0, count, count // 8):  # where no other surface is, it may move
                at = start + 24 * vertex
                xyz = struct.unpack_from("<3d", data, at)
                changed = bytearray(data)
                struct.pack_into("<3d", changed, at, *(factor * x for x in xyz))
                moved = self.root / "moved.ply"
                moved.write_bytes(changed)
                (self.root / "same.txt").write_text("\n".join(lines) + "\n")
                files = {"ball": self.ball, "socket": self.socket, part: moved}
                done = run(sys.executable, CHECKER, self.root / "same.txt", files["ball"], files["socket"])
                refused += done.returncode == 1
                self.assertEqual(run(FAST, self.root / "same.txt", files["ball"], files["socket"]).returncode, done.returncode)
                self.assertEqual(done.stderr == "", done.returncode == 0)
            self.assertGreater(refused, 2, (part, factor))

    def test_two_faces_that_cross(self):
        lines = self.made("cross", "--pose", "flexion=120,internal_rotation=40")
        self.assertEqual(len(lines), 11)
        said = self.accepted("cross", "contact: face ")
        i, j = map(int, lines[9].split()[1:])
        self.assertIn(f"face {i} of the ball and face {j} of the socket have a common point\n", said)
        for changed in (f"cross {i + 50} {j}", f"cross {i} {j + 50}", f"cross {j} {i}", "cross 0 0"):
            self.refused(lines[:9] + [changed, "end"], "do not meet|out of range")
        for changed in (f"cross {i}", f"cross {i} {j} 0", f"cross -1 {j}", "inside 0", "touch 1 2", "cross"):
            self.refused(lines[:9] + [changed, "end"], "no contact of a pose")
        self.refused(lines[:9] + ["inside", "end"], "no piece of one body is inside")
        self.refused(lines[:9] + ["end"])
        self.refused(lines[:9] + lines[9:10] * 2 + ["end"], "no contact of a pose")
        self.refused(self.word(lines, 4, 1, "1073741824"), "do not meet")  # another rotation
        self.refused(self.word(lines, 3, 1, "40"), "do not meet")
        self.refused(self.word(lines, 7, 2, "1"), "no contact of a pose")
        self.refused(self.word(lines, 0, 3, "clear"), "no cut|no integers")

    def test_a_body_inside_the_other(self):
        """Octahedra: between the layers of a shell and in its hollow, in a closed socket round the centre and out of it, and in one that has lost a face."""
        corners = [(0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1)]
        faces = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1), (5, 2, 1), (5, 3, 2), (5, 4, 3), (5, 1, 4)]

        def write(name: str, *sizes: float, x=0.0, lost=0):
            """Layers, x mm beside the centre."""
            points = [[size * p[0] + x, size * p[1], size * p[2]] for size in sizes for p in corners]
            return write_obj(self.root / f"{name}.obj", points, [[i + 6 * k for i in f] for k in range(len(sizes)) for f in faces][lost:])

        small, large, shell, opened = write("small", 20.0), write("large", 30.0), write("shell", 25.0, 30.0), write("opened", 30.0, lost=1)
        beyond = write("beyond", 20.0, 40.0)
        core, bead, far = write("core", 5.0, x=9.0), write("bead", 0.5, x=27.5), write("far", 5.0, x=90.0)
        asked = ["--centre", "0,0,0"]
        for ball, socket, contact in ((small, large, False), (beyond, large, True), (large, core, True), (shell, core, False), (shell, bead, True),
                                      (small, shell, False), (shell, far, False), (opened, far, False)):
            with self.subTest(ball=ball.stem, socket=socket.stem):
                lines = self.made("inside", *asked, ball=ball, socket=socket)
                said = self.accepted("inside", "contact: a point" if contact else "clear: no two faces meet, and no piece", ball=ball, socket=socket)
                self.assertEqual("its outside is bone" in said, socket == large)
                if contact:
                    self.assertEqual(lines[9:], ["inside", "end"])
                else:
                    self.refused(self.word(lines[:9], 0, 3, "contact") + ["inside", "end"], "no piece of one body", ball=ball, socket=socket)
        lines = self.made("inside", *asked, ball=large, socket=core)
        self.refused(lines, "no piece of one body", ball=opened, socket=core)
        self.refused(self.word(lines, 3, 1, "100"), "no piece of one body", ball=large, socket=core)
        done = self.certify("none", *asked, ball=opened, socket=core)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr.splitlines()[-1], "no surfaces meet, but a bone is open, and no closed one tells what is inside$")

    def test_bone_beside_the_joint(self):
        lines = self.made("parts", "--pose", "flexion=60", *self.parts, **self.with_parts)
        self.assertEqual(lines[1], "files 3 2")
        self.accepted("parts", "clear", *self.parts, **self.with_parts)
        self.accepted("parts", "clear", "--socket-part", self.spine, "--ball-part", self.lesser, "--ball-part", self.greater, **self.with_parts)
        near = self.scaled(self.spine, 0.5)
        for reason, parts in [
            ("it is of", []), ("it is of", self.parts[:2] + self.parts[4:]), ("it is of", self.parts[:4]),
            ("it is of", ["--socket-part", self.greater, self.lesser, "--ball-part", self.spine]), ("it is of", [*self.parts, self.spine]),
            ("part is not clear", [*self.parts[:5], near]), ("part is not clear", ["--ball-part", self.with_parts["socket"], *self.parts[2:]]),
            ("greater_trochanter.ply: of which side", self.parts[1:]), ("none.ply", [*self.parts[:5], self.root / "none.ply"]),
        ]:
            with self.subTest(parts=parts):
                self.refused(lines, reason, *parts, **self.with_parts)
        exchanged = ["--ball-part", self.spine, "--socket-part", self.greater, self.lesser]
        self.refused(lines[:1] + ["files 2 3"] + lines[2:], "part is not clear", *exchanged, **self.with_parts)

    def scaled(self, part: Path, factor: float) -> Path:
        points, faces = read_mesh(part)
        return write_obj(self.root / f"scaled_{part.stem}.obj", [[factor * x for x in p] for p in points], faces)

    def test_bone_that_passes_behind_bone(self):
        """A trochanter farther out than the rim that it passes: no radius tells them apart, and no contact is one."""
        self.made("behind", "--pose", "abduction=45", *self.parts, **self.with_parts)
        self.accepted("behind", "clear", *self.parts, **self.with_parts)

    def test_a_limit_at_bone_beside_the_joint(self):
        limit = ["--motion", "internal_rotation", "--pose", "flexion=70"]
        self.made("spine", *limit, *self.parts, **self.with_parts)
        said = self.accepted("spine", "clear", *self.parts, **self.with_parts)
        lines = self.made("alone", *limit, **self.with_parts)
        alone = self.accepted("alone", "clear", **self.with_parts)
        ends = [float(one.split("from 0 to ")[1].split()[0]) for one in (said, alone)]
        self.assertLess(ends[0] + 0.5, ends[1])  # the spine stops it before the rim does
        self.refused(lines[:1] + ["files 3 2"] + lines[2:], "part is not clear", *self.parts, **self.with_parts)
        self.made("stopped", "--pose", f"flexion=70,internal_rotation={ends[0] + 0.3}", *self.parts, **self.with_parts)
        self.accepted("stopped", "contact: face ", *self.parts, **self.with_parts)

    def test_what_cannot_be_proven_is_one_line(self):
        near = self.root / "near"
        near.mkdir(exist_ok=True)
        corners = "0 0 1\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 -1\n"
        faces = "0 1 2,0 2 3,0 3 4,0 4 1,5 2 1,5 3 2,5 4 3,5 1 4".split(",")
        for name, radius in (("ball", 24.0), ("socket", 24.00001)):
            scaled = "".join(" ".join(str(radius * float(x)) for x in line.split()) + "\n" for line in corners.splitlines())
            (near / f"{name}.off").write_text(f"OFF\n6 8 0\n{scaled}" + "".join(f"3 {face}\n" for face in faces))
        done = self.certify("none", "--centre", "0,0,0", ball=near / "ball.off", socket=near / "socket.off")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr.splitlines()[-1], "^impinge: error: no certificate: the surfaces are too near to each other .*$")
        done = self.certify("none", "--motion", "internal_rotation", "--pose", "flexion=120,internal_rotation=40")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr.splitlines()[-1], "no certificate: the motion ends within 0.01 degrees of its start; begin at another pose$")
        marks = self.root / "marks.csv"
        places = {"asis_right": "120,60,120", "asis_left": "-120,60,120", "pubic_tubercle_right": "25,60,10", "pubic_tubercle_left": "-25,60,10"}
        marks.write_text("label,x,y,z\n" + "".join(f"{name},{place}\n" for name, place in places.items()))
        for words, reason in ((["--landmarks", marks], "as they lie in their files; leave them out"), (["--overlap", 1], "no option of impinge certify")):
            done = self.certify("none", *words)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr.splitlines()[-1], f"^impinge: error: {words[0]}: .*{reason}")
        self.assertFalse((self.root / "none").exists())

    @unittest.skipUnless(BONES, "no real joints: set IMPINGE_BONES")
    def test_real_joints(self):
        for ball in sorted(Path(BONES).glob("*/femoral_head.ply")):
            with self.subTest(ball.parent.name):
                files = {"ball": ball, "socket": ball.with_name("acetabulum_facing.ply")}
                for pose in ("flexion=0", "flexion=30,internal_rotation=5"):
                    says = self.made("bones", "--pose", pose, **files)[0].split()[-1]
                    self.accepted("bones", says, **files)

    @unittest.skipUnless(BONES, "no real joints: set IMPINGE_BONES")
    def test_whole_bones(self):
        """Poses before and behind the abduction at which another program, of the same centre, first found them to meet."""
        for name, side, axes, limit in (("cargen_left", "left", "RAS", 40.959), ("vsd_z013_right", "right", "LPS", 62.244)):
            folder = Path(BONES) / name
            if not folder.is_dir():
                continue
            files = {"ball": folder / "femur.ply", "socket": folder / "pelvis.ply"}
            centre = ",".join(map(str, json.loads((folder / "subject.json").read_text())["center_of_rotation_mm"]))
            found = []
            for degrees, says in ((limit - 0.02, "clear: no two faces meet, and no piece"), (limit + 0.02, "contact: face ")):
                with self.subTest(name=name, degrees=degrees):
                    lines = self.made("whole", "--side", side, "--axes", axes, "--centre", centre, "--pose", f"abduction={degrees}", **files)
                    said = self.accepted("whole", says, **files)
                    self.assertEqual(said.count("1 pieces, 1 of 1 files closed\n"), 2)
                    found.append(lines)
            self.refused(found[0][:4] + found[1][4:5] + found[0][5:], "part is not clear", **files)
            self.refused(found[1][:4] + found[0][4:5] + found[1][5:], "do not meet", **files)


if __name__ == "__main__":
    unittest.main()
