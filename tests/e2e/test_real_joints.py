# SPDX-License-Identifier: GPL-3.0-or-later
"""experiments/real_joints/make.py on a small made-up original: what is cut, which side faces the centre, and what is refused. With
ORIGINALS, a folder of the published files, and IMPINGE_BONES, all joints: the very triangles.
"""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parents[2] / "experiments" / "real_joints"
sys.path.insert(0, str(FOLDER))
import make  # noqa: E402

CENTRE = np.array([5.0, 0.0, 0.0])


def triangles(path: Path) -> list[tuple[float, ...]]:
    """Of a PLY file, each from its least vertex on, in order."""
    head, _, body = path.read_bytes().partition(b"end_header\n")
    vertices, faces = (int(head.split(name)[1].split()[0]) for name in (b"element vertex", b"element face"))
    points = np.frombuffer(body, "<f4", 3 * vertices).reshape(-1, 3)
    corners = np.frombuffer(body, np.dtype([("n", "u1"), ("v", "<i4", 3)]), faces, 12 * vertices)["v"]
    found = []
    for corner in points[corners].tolist():
        least = corner.index(min(corner))
        found.append(tuple(value for point in corner[least:] + corner[:least] for value in point))
    return sorted(found)


def shell() -> np.ndarray:
    """A plate of 2 x 6 squares at x = 15, its front to the centre and its back at x = 17; corners of 48 triangles."""
    corners = []
    for x, front in ((15, True), (17, False)):
        for y in range(-1, 1):
            for z in range(-3, 3):
                a, b, c, d = ([x, y, z], [x, y + 1, z], [x, y + 1, z + 1], [x, y, z + 1])
                corners += [[a, d, c], [a, c, b]] if front else [[a, c, d], [a, b, c]]
    return np.array(corners, float)


class RealJoints(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.originals = Path(folder.name)
        path = self.originals / "a/b" / "plate.stl"
        path.parent.mkdir(parents=True)
        facets = ["facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in corner) + "endloop\nendfacet\n"
                  for corner in shell()]
        path.write_text("solid plate\n" + "".join(facets) + "endsolid plate\n")
        source = {"repository": "a/b", "commit": "c", "path": "plate.stl", "sha256": hashlib.sha256(path.read_bytes()).hexdigest()}
        self.path = path
        self.joint = {"center_of_rotation_mm": CENTRE.tolist(), "radius_mm": 5.0, "factor": 2.1, "originals": {
            "ball": {**source, "region": "head", "shift_mm": [0, 0, 100]}, "socket": {**source, "whole": "bone", "region": "cup"}}}

    def test_cut(self):
        """By the distances of centroids, counted here; the front alone faces the centre; vertices are shared."""
        found = make.meshes(self.joint, self.originals, False)
        self.assertEqual({name: len(mesh[1]) for name, mesh in found.items() if name == "bone"}, {"bone": 48})
        self.assertEqual(len(found["bone"][0]), 2 * 3 * 7)
        near = (np.linalg.norm(shell().mean(axis=1) - CENTRE, axis=1) <= 10.5).sum()
        self.assertEqual((len(found["cup"][1]), len(found["head"][1])), (near, 0))
        self.assertEqual(set(found["cup_facing"][0][:, 0]), {15.0})
        self.assertEqual(len(found["cup_facing"][1]), near)

    def test_the_largest_piece_faces(self):
        plates = [corners for corners in shell() if corners[0][0] == 15]
        plates = plates[:4] + plates[8:]  # a gap of two squares in one of the rows: still joined by the other
        mesh = make.welded((np.reshape(plates, (-1, 3)), np.arange(3 * len(plates)).reshape(-1, 3)))
        self.assertEqual(len(make.facing(mesh, CENTRE)[1]), 20)
        plates = plates[:2] + plates[6:8]
        mesh = make.welded((np.reshape(plates, (-1, 3)), np.arange(12).reshape(-1, 3)))
        self.assertEqual(sorted(np.bincount(make.pieces(mesh[1])).tolist())[-2:], [2, 2])

    def test_refused(self):
        """One line that names the file, why, and the cure."""
        self.path.write_text(self.path.read_text().replace("15", "16"))
        with self.assertRaisesRegex(make.Refused, r"plate.stl has the SHA-256 .* remove it and download https://raw.*/a/b/c/plate.stl"):
            make.meshes(self.joint, self.originals, False)
        self.path.unlink()
        for words, found in ((["cargen_left"], "lfemur.stl is not there: download https://"), (["nobody"], "there is no joint nobody")):
            done = subprocess.run([sys.executable, "-B", FOLDER / "make.py", "--originals", self.originals, "--out", self.originals / "out", *words],
                                  capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
            self.assertIn(found, done.stderr)

    def test_sources_are_complete(self):
        for name, joint in make.JOINTS.items():
            self.assertLessEqual({"side", "axes", "license", "attribution", "radius_mm"}, set(joint), name)
            for source in joint["originals"].values():
                self.assertEqual((len(source["commit"]), len(source["sha256"])), (40, 64), name)
                self.assertIn(f"`{source['sha256'][:12]}`", (FOLDER / "README.md").read_text())

    @unittest.skipUnless(os.environ.get("ORIGINALS") and os.environ.get("IMPINGE_BONES"), "ORIGINALS and IMPINGE_BONES name no folders")
    def test_the_very_triangles(self):
        """Those of the joints that were measured."""
        bones, compared = Path(os.environ["IMPINGE_BONES"]), 0
        subprocess.run([sys.executable, "-B", FOLDER / "make.py", "--originals", os.environ["ORIGINALS"], "--out", self.originals], check=True)
        for path in bones.glob("*/*.ply"):
            self.assertEqual(triangles(path), triangles(self.originals / path.relative_to(bones)), path)
            compared += 1
        self.assertGreater(compared, 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
