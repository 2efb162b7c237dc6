# SPDX-License-Identifier: GPL-3.0-or-later
"""scene --certificate, and what check_certificate.py says of it: accepted as it is, refused after any change that makes it false.

SCENE and MAKE_PAIR name the two programs. With IMPINGE_BONES set, real joints are certified too.
"""

from __future__ import annotations

import os
import re
import struct
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from generated_pair import GeneratedPair, run  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
CHECKER = ROOT / "experiments" / "check_certificate.py"
BONES = os.environ.get("IMPINGE_BONES", "")
LIMIT = ["--question", "limit", "--motion", "internal_rotation", "--pose", "flexion=80"]


def read_mesh(file: Path) -> tuple[list, list]:
    """Points and faces of a PLY that make_pair wrote."""
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
            made = run(os.environ["MAKE_PAIR"], "--hip", *words, "--faces", "600", "--out", cls.root / name)
            assert made.returncode == 0, made.stderr
        cls.with_parts = {"ball": cls.root / "with/ball.ply", "socket": cls.root / "with/socket.ply"}
        cls.greater, cls.lesser, cls.spine = (cls.root / f"with/{name}.ply" for name in ("greater_trochanter", "lesser_trochanter", "aiis"))
        cls.parts = ["--ball-part", cls.greater, cls.lesser, "--socket-part", cls.spine]

    def scene(self, name: str, *words, ball=None, socket=None) -> subprocess.CompletedProcess:
        files = ["--ball", ball or self.ball, "--socket", socket or self.socket, "--out", self.root / "out"]
        return run(os.environ["SCENE"], *files, "--side", "right", "--certificate", self.root / name, *words)

    def made(self, name: str, *words, **files) -> list[str]:
        """The lines of a certificate."""
        done = self.scene(name, *words, **files)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f": {self.root / name}\n", done.stdout)
        return (self.root / name).read_text().splitlines()

    def accepted(self, name: str, says: str, *parts, ball=None, socket=None) -> str:
        done = run(sys.executable, CHECKER, self.root / name, ball or self.ball, socket or self.socket, *parts)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout.startswith(says), done.stdout)
        return done.stdout

    def refused(self, lines: list[str], reason="", *parts, ball=None, socket=None):
        changed = self.root / "changed.txt"
        changed.write_text("\n".join(lines) + "\n")
        done = run(sys.executable, CHECKER, changed, ball or self.ball, socket or self.socket, *parts)
        self.assertEqual((done.returncode, done.stdout), (1, ""), "accepted")
        self.assertRegex(done.stderr, f"^refused: .*{reason}.*\n$")

    def test_the_checker_is_short_and_stands_alone(self):
        lines = CHECKER.read_text().splitlines()
        self.assertLessEqual(len(lines), 200)
        imports = [line for line in lines if "import" in line.split()[:1] or line.startswith("from")]
        self.assertEqual(imports, ["import math", "import struct", "import sys", "from fractions import Fraction"])

    def test_poses(self):
        for number, (pose, says) in enumerate({
            "flexion=0": "clear", "flexion=90": "clear", "flexion=40,abduction=20,internal_rotation=10": "clear",
            "flexion=120,internal_rotation=40": "blocked", "abduction=80": "blocked",
        }.items()):
            with self.subTest(pose):
                self.made(f"pose_{number}.txt", "--question", "touch", "--pose", pose)
                self.accepted(f"pose_{number}.txt", says)

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
            self.made("format.txt", "--question", "touch", "--pose", "flexion=70", ball=ball)
            self.accepted("format.txt", "clear", ball=ball)
            ball.write_text(text.replace("end_header\n", "end_header\nnan ") if name.endswith("ply") else obj + "f 1 2 0\n")
            self.refused((self.root / "format.txt").read_text().splitlines(), ball=ball)

    def test_a_limit_has_a_chain(self):
        lines = self.made("limit.txt", *LIMIT)
        said = self.accepted("limit.txt", "clear")
        done = run(os.environ["SCENE"], "--ball", self.ball, "--socket", self.socket, "--out", self.root / "limit", "--side", "right", *LIMIT)
        low = float(done.stdout.split("between ")[1].split()[0])
        self.assertAlmostEqual(float(said.split("up to ")[1].split()[0]), low - 0.1, delta=1e-3)
        cells = [k for k, line in enumerate(lines) if line.startswith("cell")]
        self.assertGreater(len(cells), 2)
        self.refused(lines[: cells[1]] + lines[cells[2] :], "missing")
        self.refused(self.word(lines, cells[1], 8, "1/1000000"), "wider")
        last = lines[cells[-1]].split()
        self.refused(self.word(lines, cells[-1], 5, str(2 * int(last[5]))), "wider")
        self.refused(self.word(lines, cells[0], 2, "2") and self.word(lines, cells[0], 3, "1"), "missing")
        self.refused(self.word(lines, 4, 1, "1"), "axis")

    @staticmethod
    def word(lines: list[str], line: int, word: int, text: str) -> list[str]:
        """The lines with one word changed."""
        words = lines[line].split()
        words[word] = text
        return lines[:line] + [" ".join(words)] + lines[line + 1 :]

    def test_what_makes_it_false_is_refused(self):
        lines = self.made("clear.txt", "--question", "touch", "--pose", "flexion=60,internal_rotation=20")
        leaves = range(8, len(lines) - 1)
        self.accepted("clear.txt", "clear")
        refusals = {"beyond": 0, "within": 0}
        for leaf in leaves[::2]:  # no radius does where both surfaces are: far too small and far too large ones
            radius = int(lines[leaf].split()[4])
            for changed in (0, 100 * 2**20):
                name = self.root / "radius.txt"
                name.write_text("\n".join(self.word(lines, leaf, 4, str(changed))) + "\n")
                done = run(sys.executable, CHECKER, name, self.ball, self.socket)
                if radius > 0 and changed == 0:
                    self.assertIn("the ball reaches beyond", done.stderr)  # a leaf without a ball has the radius 0
                    refusals["beyond"] += 1
                elif done.returncode == 1:
                    self.assertIn("the socket is not beyond", done.stderr)
                    refusals["within"] += 1
        self.assertGreater(min(refusals.values()), 5)
        for leaf in list(leaves)[:: len(leaves) // 6]:
            self.refused(lines[:leaf] + lines[leaf + 1 :])  # dropped
            fewer = self.word(lines, 7, 9, str(len(leaves) - 1))
            self.refused(fewer[:leaf] + fewer[leaf + 1 :], "cover")
            more = self.word(lines, 7, 9, str(len(leaves) + 1))
            self.refused(more[:leaf] + more[leaf : leaf + 1] + more[leaf:], "twice")  # doubled
            face, level, i, j, radius = lines[leaf].split()
            moved = [face, level, str(int(i) ^ 1), j, radius]
            self.refused(lines[:leaf] + [" ".join(moved)] + lines[leaf + 1 :])
            part = " ".join([face, str(int(level) + 1), str(2 * int(i)), str(2 * int(j)), radius])
            self.refused(more[: leaf + 1] + [part] + more[leaf + 1 :], "cover")

    def test_what_is_no_certificate_is_refused(self):
        lines = self.made("head.txt", "--question", "touch", "--pose", "flexion=60")
        for line, word, text, reason in [
            (0, 2, "2", "whole"), (0, 3, "blocked", ""), (0, 3, "sure", "missing"),
            (1, 1, "nan", "no number"), (1, 1, "1e999999999", "no number"), (1, 1, "9" * 5000, "no number"), (1, 1, "1/0", ""),
            (1, 1, "4", ""), (2, 1, "0.000001", "a centre"), (2, 2, "-1/30000000", "a centre"), (2, 3, "5", ""), (3, 1, "0", ""), (3, 1, "1.5", "no integers"),
            (4, 1, "2", "axis"), (4, 1, "0", "axis"), (6, 1, "0", "unit"), (6, 1, "-1048576", "unit"), (6, 1, "1", ""),
            (7, 1, "hip", ""), (7, 2, "0", "missing"), (7, 5, "-1", ""), (7, 5, "1", "wider"), (7, 6, "-1", "wider"),
            (7, 8, "-1", "wider"), (7, 9, "0", "missing"), (7, 9, "100000", ""), (8, 0, "6", "cube"), (8, 0, "-1", "cube"),
            (8, 1, "41", "cube"), (8, 1, "-1", "cube"), (8, 2, "-1", "cube"), (8, 4, "-1", "cover"), (8, 4, "1e3", "no integers"),
        ]:
            with self.subTest(line=line, text=text[:20]):
                self.refused(self.word(lines, line, word, text), reason)
        other = self.made("other.txt", "--question", "touch", "--pose", "flexion=120,internal_rotation=40")
        self.refused(lines[:3] + other[3:4] + lines[4:], "leaf")  # of a pose with contact
        self.refused(lines[:1] + other[1:], "")
        self.refused(lines[:-1], "whole")
        self.refused(lines[:7] + ["end"])
        self.refused([*lines[:1], *lines[2:]], "head")
        self.refused([*lines[:-1], "1 2 3", "end"])
        for part in ("ball", "socket"):  # the ball as both, the socket as both, and exchanged
            self.refused(lines, ball=getattr(self, part), socket=getattr(self, part))
        self.refused(lines, ball=self.socket, socket=self.ball)
        self.refused(lines, ball=self.root / "none.ply")

    def test_a_vertex_that_is_moved_across_is_refused(self):
        lines = self.made("vertex.txt", "--question", "touch", "--pose", "flexion=60")
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
                self.assertEqual(done.stderr == "", done.returncode == 0)
            self.assertGreater(refused, 2, (part, factor))

    def test_a_witness(self):
        lines = self.made("witness.txt", "--question", "touch", "--pose", "flexion=120,internal_rotation=40")
        self.assertEqual(len(lines), 9)
        x, y, z = (int(word) for word in lines[7].split()[4:])
        for k, word in enumerate((x, y, z)):
            self.refused(self.word(lines, 7, 4 + k, str(-word if abs(word) == max(map(abs, (x, y, z))) else word + 3 * max(map(abs, (x, y, z))))))
        self.refused(self.word(self.word(self.word(lines, 7, 4, "0"), 7, 5, "0"), 7, 6, "0"), "meet")
        self.refused(self.word(lines, 3, 1, "1048576"))  # another rotation
        self.refused(self.word(lines, 0, 3, "clear"))

    def test_bone_beside_the_joint(self):
        lines = self.made("parts.txt", "--question", "touch", "--pose", "flexion=60", *self.parts, **self.with_parts)
        self.assertEqual(lines[1], "bodies 3 2")
        self.accepted("parts.txt", "clear", *self.parts, **self.with_parts)
        self.accepted("parts.txt", "clear", "--socket-part", self.spine, "--ball-part", self.lesser, "--ball-part", self.greater, **self.with_parts)
        near, far = self.scaled(self.spine, 0.5), self.scaled(self.greater, 2.0)
        for reason, parts in [
            ("it is of", []), ("it is of", self.parts[:2] + self.parts[3:]), ("it is of", self.parts[:3]),
            ("it is of", ["--socket-part", *self.parts[1:3], "--ball-part", self.spine]), ("it is of", [*self.parts, self.spine]),
            ("the socket is not beyond", [*self.parts[:4], near]), ("the ball reaches beyond", ["--ball-part", far, *self.parts[2:]]),
            ("greater_trochanter.ply: of which side", self.parts[1:]), ("none.ply", [*self.parts[:4], self.root / "none.ply"]),
        ]:
            with self.subTest(parts=parts):
                self.refused(lines, reason, *parts, **self.with_parts)
        exchanged = ["--ball-part", self.spine, "--socket-part", self.greater, self.lesser]
        self.refused(lines[:1] + ["bodies 2 3"] + lines[2:], "leaf", *exchanged, **self.with_parts)
        self.refused(lines[:1] + lines[2:], "it is of", *self.parts, **self.with_parts)
        self.refused(lines[:2] + lines[1:], "head", *self.parts, **self.with_parts)

    def scaled(self, part: Path, factor: float) -> Path:
        points, faces = read_mesh(part)
        return write_obj(self.root / f"scaled_{part.stem}.obj", [[factor * x for x in p] for p in points], faces)

    def test_a_limit_at_bone_beside_the_joint(self):
        limit = ["--question", "limit", "--motion", "internal_rotation", "--pose", "flexion=70"]
        self.made("spine.txt", *limit, *self.parts, **self.with_parts)
        said = self.accepted("spine.txt", "clear", *self.parts, **self.with_parts)
        lines = self.made("alone.txt", *limit, **self.with_parts)
        self.assertEqual([line for line in lines if line.startswith("bodies")], [])
        alone = self.accepted("alone.txt", "clear", **self.with_parts)
        ends = [float(one.split("up to ")[1].split()[0]) for one in (said, alone)]
        self.assertLess(ends[0] + 0.5, ends[1])  # the spine stops it before the rim does
        self.refused(lines[:1] + ["bodies 3 2"] + lines[1:], "leaf", *self.parts, **self.with_parts)

    def test_a_witness_is_of_the_main_surfaces(self):
        pose = ["--question", "touch", "--pose", "external_rotation=70"]
        lines = self.made("witness.txt", *pose, *self.parts, **self.with_parts)
        self.accepted("witness.txt", "blocked", *self.parts, **self.with_parts)
        self.assertEqual(lines[:1] + lines[2:], self.made("alone.txt", *pose, **self.with_parts))
        self.refused(lines, "it is of", **self.with_parts)
        # A trochanter behind a rim is no contact, and the ray that meets both is no witness. It is one of two meshes that hold all.
        pose = ["--question", "touch", "--pose", "abduction=45"]
        done = self.scene("none.txt", *pose, *self.parts, **self.with_parts)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr.splitlines()[-1], "no certificate for .*, the ball with its parts is not clearly nearer than the socket .*$")
        direction = re.search("direction ([-0-9.]+),([-0-9.]+),([-0-9.]+) from", done.stderr).groups()
        ray = "ray socket 1 0 " + " ".join(str(round(1e4 * float(x))) for x in direction)
        head = self.made("alone.txt", *pose, **self.with_parts)[1:7]
        lines = ["impinge certificate 1 blocked", *head, ray, "end"]
        self.refused(lines[:1] + ["bodies 3 2"] + lines[1:], "meet|nearer", *self.parts, **self.with_parts)
        whole = {}
        for side, files in {"ball": [self.with_parts["ball"], self.greater, self.lesser], "socket": [self.with_parts["socket"], self.spine]}.items():
            points, faces = [], []
            for file in files:
                more_points, more_faces = read_mesh(file)
                faces += [[i + len(points) for i in f] for f in more_faces]
                points += more_points
            whole[side] = write_obj(self.root / f"whole_{side}.obj", points, faces)
        (self.root / "whole.txt").write_text("\n".join(lines) + "\n")
        self.accepted("whole.txt", "blocked", **whole)

    def test_what_cannot_be_proven_is_one_line(self):
        near = self.root / "near"
        near.mkdir(exist_ok=True)
        corners = "0 0 1\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 -1\n"
        faces = "0 1 2,0 2 3,0 3 4,0 4 1,5 2 1,5 3 2,5 4 3,5 1 4".split(",")
        for name, radius in (("ball", 24.0), ("socket", 24.00001)):
            scaled = "".join(" ".join(str(radius * float(x)) for x in line.split()) + "\n" for line in corners.splitlines())
            (near / f"{name}.off").write_text(f"OFF\n6 8 0\n{scaled}" + "".join(f"3 {face}\n" for face in faces))
        done = self.scene("none.txt", "--centre", "0,0,0", "--question", "touch", ball=near / "ball.off", socket=near / "socket.off")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr.splitlines()[-1], f"^scene: error: option --certificate: no certificate for {self.root / 'none.txt'}, "
                         "the surfaces are too near to each other .*$")
        self.assertFalse((self.root / "none.txt").exists())
        done = self.scene("none.txt", "--question", "limit", "--motion", "flexion", "--pose", "flexion=180", ball=self.ball)
        self.assertEqual(done.returncode, 2)
        done = self.scene("none.txt", "--question", "limit", "--motion", "internal_rotation", "--pose", "flexion=120,internal_rotation=40")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr.splitlines()[-1], "the motion ends within 0.1 degrees of its start; begin at another pose$")
        done = self.scene("nowhere/none.txt", "--question", "touch")
        self.assertEqual(done.returncode, 1)
        self.assertIn(str(self.root / "nowhere/none.txt"), done.stderr)
        done = self.scene("pair/ball.ply", "--question", "touch")
        self.assertRegex(done.stderr, "would be replaced by the certificate; choose another file with --certificate\n$")

    @unittest.skipUnless(BONES, "no real joints: set IMPINGE_BONES")
    def test_real_joints(self):
        for ball in sorted(Path(BONES).glob("*/femoral_head.ply")):
            with self.subTest(ball.parent.name):
                files = {"ball": ball, "socket": ball.with_name("acetabulum_facing.ply")}
                for pose in ("flexion=0", "flexion=30,internal_rotation=5"):
                    says = self.made("bones.txt", "--question", "touch", "--pose", pose, **files)[0].split()[-1]
                    self.accepted("bones.txt", says, **files)


if __name__ == "__main__":
    unittest.main()
