# SPDX-License-Identifier: GPL-3.0-or-later
"""Every bad input that we could think of, given to `impinge`, each with the whole message that must come.

A refusal is exit code 1 (a file) or 2 (an option), one line on stderr, nothing on stdout, and no output file,
or an older set of five that stays as it was. IMPINGE names the program.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import resource
import shutil
import signal
import struct
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from bad_meshes import MESHES  # noqa: E402
from bad_options import OPTIONS  # noqa: E402
from generated_pair import IMPINGE, GeneratedPair, run  # noqa: E402

FIVE = ["ball.ply", "socket.ply", "gaps.csv", "distances.csv", "summary.json"]  # in the order of writing
NOBODY = 65534
ROOT = Path(__file__).resolve().parents[2]
SCHEMES = ", ".join(sorted(file.stem for file in (ROOT / "libcore" / "sphere" / "schemes").glob("*.hpp")))
PAGE = 4096


def scaled(mesh: bytes, factor: float) -> bytes:
    """Our binary PLY with every coordinate times the factor."""
    header, body = mesh.split(b"end_header\n", 1)
    count = int(header.split(b"element vertex ")[1].split()[0])
    numbers = struct.unpack_from(f"<{3 * count}d", body)
    return (
        header
        + b"end_header\n"
        + struct.pack(f"<{3 * count}d", *(factor * x for x in numbers))
        + body[24 * count :]
    )


def bytes_of(folder: Path) -> dict[str, str]:
    """Names and hashes of all files there, hidden and temporary ones too."""
    return {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in folder.iterdir()}


class BadInput(GeneratedPair):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.root.chmod(0o755)  # for a child that is nobody
        cls.program = cls.root / "impinge"
        shutil.copy(IMPINGE, cls.program)

    def gaps(self, *more, ball=None, socket=None, out=None, **keywords) -> subprocess.CompletedProcess:
        files = ball or self.ball, socket or self.socket, "--out", out or self.root / "out"
        return run(self.program, "gaps", *files, "--precision", 5, *more, **keywords)

    def refused(self, done: subprocess.CompletedProcess, code: int, message: str):
        self.assertEqual(done.stderr, f"impinge: error: {message}\n")
        self.assertEqual((done.returncode, done.stdout), (code, ""))
        out = self.root / "out"
        self.assertFalse(out.is_dir() and any(out.iterdir()), "there is output")

    def test_meshes(self):
        """As the ball and as the socket."""
        self.assertGreaterEqual(len(MESHES), 60)
        for name, content, message in MESHES:
            path = self.root / name
            path.write_bytes(content)
            for part in ("ball", "socket"):
                with self.subTest(name, part=part):
                    self.refused(self.gaps(**{part: path}), 1, f"{path}: {message}")
            path.unlink()

    def test_parts(self):
        """Bone beside ball or socket is read as they are, and is no place for the output."""
        name, content, message = MESHES[0]
        bad = self.root / name
        bad.write_bytes(content)
        for option, mesh in (("--ball-part", self.ball), ("--socket-part", self.socket)):
            with self.subTest(option):
                self.refused(self.gaps(option, self.ball, option, bad), 1, f"{bad}: {message}")
                none = self.root / "none.ply"
                self.refused(self.gaps(option, none), 1, f"{none}: there is no such file; check the path")
                part = self.root / "taken" / "ball.ply"
                part.parent.mkdir()
                shutil.copy(mesh, part)
                cure = "would be replaced by the output; choose another folder with --out"
                self.refused(self.gaps(option, part, out=part.parent), 1, f"{part}: {cure}")
                shutil.rmtree(part.parent)
        bad.unlink()

    def test_options(self):
        """Behind the command and its files."""
        for (command, *words), message in OPTIONS:
            files = () if command == "hip" else (self.ball, self.socket)
            with self.subTest([command, *words]):
                done = run(self.program, command, *files, "--out", self.root / "out", *words)
                self.refused(done, 2, message.replace("{schemes}", SCHEMES))

    def test_words_that_are_missing_or_wrong(self):
        """A command, a mesh; and an empty one, as a script types it whose variable is not set."""
        commands = "there are gaps, touch, poses, limits, volume, resect, orient, measure, certify, report, check, hip, cohort; see impinge --help"
        see = "; see impinge touch --help"
        meshes = "two meshes are needed, BALL and SOCKET"
        for words, message in [
            (["scene"], f"impinge: there is no 'scene'; {commands}"),
            (["limt", self.ball], f"impinge: there is no 'limt'; did you mean limits? T{commands[1:]}"),
            (["--quiet", "touch"], "--quiet: give it behind impinge touch" + see),
            (["touch"], meshes + see),
            (["touch", self.ball], meshes + see),
            (["touch", "", self.socket], "BALL: is empty; give it a value or leave it out" + see),
            (["touch", self.ball, self.socket, "--out", ""], "--out: is empty; give it a value or leave it out" + see),
            (["touch", "--joints", "."], "--joints requires --out" + see),
        ]:
            with self.subTest(words):
                self.refused(run(self.program, *words), 2, message)

    def test_files_that_say_something_of_the_joint(self):
        """Descriptions, landmarks, poses and thicknesses: each with its name, and what is wrong in it."""
        none = self.root / "none.json"
        missing = "there is no such file; check the path"
        for option, text, message in [
            ("--config", "[]", "is no JSON object; write one, as {\"side\": \"left\"}"),
            ("--config", '{"sid": "left"}', "sid: is no key; did you mean side?"),
            ("--config", '{"side": "up"}', "side: there is no 'up'; there are left, right"),
            ("--config", '{"landmarks": []}', "landmarks: are one file; name it"),
            ("--config", '{"cartilage": 3}', "cartilage: is no key; did you mean cartilage_mm?"),
            ("--config", '{"center_of_rotation": [0, 0, 0]}', "center_of_rotation: is no key; did you mean center_of_rotation_mm?"),
            ("--config", '{"centre_mm": [0, 0, 0]}', "centre_mm: is no key; did you mean centre?"),
            ("--config", '{"overlap_mm": 1}', "overlap_mm: is no key; it is an option of the command line"),
            ("--config", '{"keep": "largest"}', "keep: is no key; it is an option of the command line"),
            ("--config", '{"ignore_rest_contact": true}', "ignore_rest_contact: is no key; it is an option of the command line"),
            ("--config", '{"unit": "m"}', 'unit: is "m"; give all lengths in mm'),
            ("--config", '{"units": "cm"}', 'units: is "cm"; give all lengths in mm'),
            ("--config", '{"colour": "red"}',
             "colour: is no key; there are center_of_rotation_mm, centre, side, axes, radius_mm, cartilage_mm, landmarks, ball_part, socket_part"),
            ("--config", '{"axes": "LPS (ITK)"}', "axis code 'LPS (ITK)' does not have three letters; name where +x, +y and +z point with one letter each of "
             "R/L, A/P and S/I, as RAS or LPS"),
            ("--landmarks", "label,x,y,z\n", "the landmark asis_right is missing; mark it"),
            ("--cartilage", "x,y,z,thickness_mm\n", "holds no point; give a CSV with the header x,y,z,thickness_mm and four numbers a line, in mm"),
        ]:
            with self.subTest(option, text=text):
                file = self.root / "said.csv"
                file.write_text(text)
                self.refused(self.gaps(option, file), 1, f"{file}: {message}")
                if option != "--cartilage":
                    self.refused(self.gaps(option, none), 1, f"{none}: {missing}")
        poses = self.root / "two.csv"
        poses.write_text("flexion,abduction\n0,0\n0,10\n")
        for file, message in ((none, missing), (poses, "has angles that turn opposite ways on the two sides; say which with --side left or right")):
            done = run(self.program, "poses", self.ball, self.socket, "--poses", file, "--out", self.root / "out")
            self.refused(done, 1, f"{file}: {message}")

    def test_places_without_a_mesh(self):
        """What the name of a mesh may lead to."""
        root = self.root / "places"
        root.mkdir()
        (root / "folder.ply").mkdir()
        (root / "nowhere.ply").symlink_to("none.ply")
        (root / "loop.ply").symlink_to("pool.ply")
        (root / "pool.ply").symlink_to("loop.ply")
        (root / "device.stl").symlink_to("/dev/zero")
        os.mkfifo(root / "pipe.off")
        with (root / "sparse.stl").open("wb") as file:
            file.truncate(2**32 + 1)
        for name, message in [
            ("none.ply", "there is no such file; check the path"),
            ("none/none.ply", "there is no such file; check the path"),
            ("nowhere.ply", "there is no such file; check the path"),
            ("folder.ply", "is a folder; name a file in it"),
            ("device.stl", "is not a regular file; name a file on the disk"),
            ("pipe.off", "is not a regular file; name a file on the disk"),
            ("loop.ply", "cannot be looked up, Too many levels of symbolic links; check the path"),
            ("n" * 300 + ".ply", "cannot be looked up, File name too long; check the path"),
            (
                "sparse.stl",
                "has 4294967297 bytes, more than the 4294967296 that are read; "
                "check that it is a mesh, or reduce its triangles",
            ),
        ]:
            for part in ("ball", "socket"):
                with self.subTest(name[:20], part=part):
                    self.refused(self.gaps(**{part: root / name}), 1, f"{root / name}: {message}")

    def as_nobody(self) -> dict:
        """Root may do everything: its child becomes somebody else."""
        return {"preexec_fn": lambda: os.setuid(NOBODY)} if os.getuid() == 0 else {}

    def test_permissions(self):
        """Of a mesh, of its folder, of the folder of the results."""
        root = self.root / "closed"
        created = "the folder cannot be created"
        for folder in ("files", "shut", "kept"):
            (root / folder).mkdir(parents=True)
        for copy in (root / "files" / "a.ply", root / "shut" / "a.ply"):
            shutil.copy(self.ball, copy)
        (root / "files" / "a.ply").chmod(0)
        (root / "shut").chmod(0)
        (root / "kept").chmod(0o555)
        try:
            for keywords, message in [
                (
                    {"ball": root / "files" / "a.ply"},
                    f"{root}/files/a.ply: cannot be opened, Permission denied; check its permissions",
                ),
                (
                    {"socket": root / "shut" / "a.ply"},
                    f"{root}/shut/a.ply: cannot be looked up, Permission denied; check the path",
                ),
                (
                    {"out": root / "kept"},
                    f"{root}/kept/probe: cannot be written, Permission denied; "
                    "check that its folder exists, may be written to and has room",
                ),
                (
                    {"out": root / "kept" / "new"},
                    f"{root}/kept/new: {created}, Permission denied; choose another folder",
                ),
            ]:
                with self.subTest(message):
                    (self.root / "out").mkdir(exist_ok=True)
                    (self.root / "out").chmod(0o777)
                    self.refused(self.gaps(**keywords, **self.as_nobody()), 1, message)
        finally:
            (root / "shut").chmod(0o700)

    def test_places_for_the_results(self):
        """A file, below a file, a loop, and a folder in the place of a file."""
        loop = self.root / "loop"
        created = "the folder cannot be created"
        loop.symlink_to(loop)
        taken = self.root / "taken"
        (taken / "summary.json").mkdir(parents=True)
        for out, message in [
            (self.ball, f"{created}, Not a directory; choose another folder"),
            (self.ball / "o", f"{created}, Not a directory; choose another folder"),
            (loop, f"{created}, Too many levels of symbolic links; choose another folder"),
            (taken, "is a folder; choose another name"),
            (self.ball.parent, "would be replaced by the output; choose another folder with --out"),
        ]:
            with self.subTest(out):
                at = {taken: taken / "summary.json", self.ball.parent: self.ball}.get(out, out)
                self.refused(self.gaps(out=out), 1, f"{at}: {message}")
        self.assertEqual([path.name for path in taken.iterdir()], ["summary.json"])
        self.assertEqual(sorted(path.name for path in self.ball.parent.iterdir()), ["ball.ply", "socket.ply"])

    def test_joints_that_are_none(self):
        """Two good meshes that do not belong together, or are in another unit of length."""
        root = self.root / "units"
        root.mkdir()
        ball, socket = self.ball.read_bytes(), self.socket.read_bytes()
        for name, mesh, factor in [
            ("ball_m.ply", ball, 1e-3),
            ("socket_m.ply", socket, 1e-3),
            ("ball_cm.ply", ball, 0.1),
            ("ball_um.ply", ball, 1e3),
        ]:
            (root / name).write_bytes(scaled(mesh, factor))
        os.link(self.ball, root / "again.ply")
        for name, corners in {
            "triangle": "0 0 1\n1 0 1\n0 1 1\n",
            "far": "9000 0 0\n9001 0 0\n9000 1 0\n",  # fills less of the view than a cell of the grid that measures it
            "flat": "30 0 0\n31 0 0\n30 1 0\n",  # its plane holds the centre
        }.items():
            (root / f"{name}.off").write_text(f"OFF\n3 1 0\n{corners}3 0 1 2\n")
        advice = "check that both meshes are in mm and in one frame"
        apart = "mm from the centre of rotation, and the ball {}; " + advice
        same = "is the mesh of the ball and of the socket; check BALL and SOCKET"
        points = "a sphere is fitted to at least four points; give the centre with --centre X,Y,Z"
        for keywords, message in [
            (
                {"ball": root / "ball_m.ply"},
                f"{self.socket}: lies 26 to 26 {apart.format('0.022 to 0.025 mm')}",
            ),
            (
                {"ball": root / "ball_cm.ply"},
                f"{self.socket}: lies 26 to 26 {apart.format('2.2 to 2.5 mm')}",
            ),
            (
                {"ball": root / "ball_um.ply"},
                f"{self.socket}: lies 26 to 26 {apart.format('2.2e+04 to 2.5e+04 mm')}",
            ),
            (
                {"socket": root / "socket_m.ply"},
                f"{root}/socket_m.ply: lies 0.026 to 0.026 {apart.format('22 to 25 mm')}",
            ),
            ({"ball": root / "triangle.off"}, f"{root}/triangle.off: {points}"),
            (
                {"socket": root / "triangle.off"},
                f"{root}/triangle.off: lies 1 to 1.41 {apart.format('22 to 25 mm')}",
            ),
            ({"socket": self.ball}, f"{self.ball}: {same}"),
            ({"socket": root / "again.ply"}, f"{root}/again.ply: {same}"),
        ]:
            with self.subTest(message):
                self.refused(self.gaps(**keywords), 1, message)
        nowhere = "no direction from the centre 0.000,0.000,0.000 meets the socket; check that both meshes are in one frame and in mm"
        outside = "fills only 0 % of the view from the centre {}; give a centre inside with --centre X,Y,Z, or check that the files are not swapped and in mm"
        for centre, keywords, message in [
            ("0,0,0", {"socket": root / "far.off"}, f"{root}/far.off: {nowhere}"),
            ("0,0,0", {"socket": root / "flat.off"}, f"{root}/flat.off: {nowhere}"),
            ("300,0,0", {}, f"{self.ball}: " + outside.format("300.000,0.000,0.000, which lies outside of the ball")),
            ("0,0,0", {"ball": root / "flat.off"}, f"{root}/flat.off: " + outside.format("0.000,0.000,0.000, and no sphere fits it")),
        ]:
            with self.subTest(message):
                self.refused(self.gaps("--centre", centre, **keywords), 1, message)

    def test_two_meshes_in_another_unit(self):
        """Nothing is wrong with them but their size: no joint has that in m, a small animal's may have that in cm."""
        for unit, factor, radius in (("m", 1e-3, "0.022"), ("cm", 0.1, "2.19")):
            with self.subTest(unit):
                for name in ("ball", "socket"):
                    (self.root / f"{name}_in_{unit}.ply").write_bytes(
                        scaled((self.root / "pair" / f"{name}.ply").read_bytes(), factor)
                    )
                out = self.root / f"in_{unit}"
                both = {name: self.root / f"{name}_in_{unit}.ply" for name in ("ball", "socket")}
                done = self.gaps(**both, out=out)
                if unit == "m":
                    scale = "lengths are read as mm: scale both meshes by 1000 if they are in metres"
                    self.refused(done, 1, f"{both['ball']}: has a radius of {radius} mm, which no joint has; {scale}")
                    continue
                self.assertEqual(done.returncode, 0, done.stderr)
                warning = (
                    f"{both['ball']}: has a radius of {radius} mm, and a human joint 5 to 50; "
                    "lengths are read as mm, scale both meshes if theirs are in another unit"
                )
                self.assertEqual(done.stderr, f"impinge: warning: {warning}\n")
                self.assertEqual(json.loads((out / "summary.json").read_text())["joint"]["warnings"], [warning])

    def test_names_of_any_bytes(self):
        """A name that is no UTF-8, or has a line end, is a name; the summary is UTF-8 all the same."""
        for name in (b"b\xff\xfe.ply", b"line\nend.ply"):
            with self.subTest(name):
                path = os.fsencode(self.root) + b"/" + name
                shutil.copy(self.ball, path)
                out = self.root / "names"
                done = self.gaps(ball=path, out=out)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertTrue(
                    json.loads((out / "summary.json").read_text())["joint"]["ball"]["mesh"].endswith(".ply")
                )
                os.truncate(path, 100)
                refusal = self.gaps(ball=path)
                self.assertEqual((refusal.returncode, refusal.stderr.count("\n")), (1, 1))

    def older_set(self, out: Path, *options) -> dict[str, str]:
        """A complete run before the one that fails."""
        done = self.gaps(*options, out=out)
        self.assertEqual(done.returncode, 0, done.stderr)
        files = bytes_of(out)
        self.assertEqual(sorted(files), sorted(FIVE))
        return files

    def test_a_limit_on_files_leaves_the_older_five(self):
        """Whichever is the first that is too large for RLIMIT_FSIZE: nothing of the new run stays."""
        sizes = {file.name: file.stat().st_size for file in self.sized().iterdir()}
        out = self.root / "limited"
        older = self.older_set(out, "--pose", "flexion=5")
        met = set()
        for size in sorted(sizes.values()):

            def limited(
                limit=size - 1,
            ):  # with the signal ignored the limit is an error of write(), as on a full disk
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)

            name = next(name for name in FIVE if sizes[name] >= size)
            met.add(name)
            for place in (out, self.root / "out"):  # refused() looks at the second, which is empty
                with self.subTest(name, size=size, place=place.name):
                    done = self.gaps(out=place, preexec_fn=limited)
                    advice = "check that its folder exists, may be written to and has room"
                    self.refused(done, 1, f"{place}/{name}: cannot be written, File too large; {advice}")
                    self.assertEqual(bytes_of(out), older)
        self.assertGreaterEqual(len(met), 2)
        self.assertEqual(self.gaps(out=out).returncode, 0)
        self.assertNotEqual(bytes_of(out), older)

    def sized(self) -> Path:
        """A folder with the five files."""
        out = self.root / "sized"
        if not out.exists():
            self.older_set(out)
        return out

    @contextlib.contextmanager
    def disk(self, size: int):
        """A small one of its own; needs root."""
        place = self.root / "disk"
        place.mkdir(exist_ok=True)
        mounted = run("mount", "-t", "tmpfs", "-o", f"size={size},mode=755", "impinge-test", place)
        if mounted.returncode != 0:
            self.skipTest(f"no small disk: {mounted.stderr.strip()}")
        try:
            yield place
        finally:
            run("umount", place)

    def test_a_full_disk_leaves_the_older_five_or_the_newer(self):
        """Disks with room for the older files alone, for all, and between."""
        whole = sum(-(-file.stat().st_size // PAGE) * PAGE for file in self.sized().iterdir())
        ends = set()
        for size in range(whole + 8 * PAGE, 2 * whole + 16 * PAGE, max(PAGE, whole // 12 // PAGE * PAGE)):
            with self.subTest(size=size), self.disk(size) as place:
                out = place / "out"
                older = self.older_set(out, "--pose", "flexion=5")
                done = self.gaps(out=out)
                if done.returncode == 0:
                    self.assertEqual(sorted(bytes_of(out)), sorted(FIVE))
                    self.assertNotEqual(bytes_of(out), older)
                else:
                    self.assertRegex(
                        done.stderr, r"\Aimpinge: error: .*cannot be written, No space left on device; .*\n\Z"
                    )
                    self.assertEqual(bytes_of(out), older)
                ends.add(done.returncode)
        self.assertEqual(ends, {0, 1})


if __name__ == "__main__":
    unittest.main()
