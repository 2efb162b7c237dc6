# SPDX-License-Identifier: GPL-3.0-or-later
"""The test set of turns: what it says is held against an oracle of its own, and ours misses nothing in it.

Oracle: two convex features are apart in a pose if and only if some of finitely many directions parts them, in fractions.
test_turns.py PAIRS MESHES [SEED]."""
import csv
import math
import os
import random
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

SOURCE, BUILD = Path(os.environ["SOURCE"]), Path(os.environ["BUILD"])
PAIRS, MESHES, SEED = (*(int(word) for word in sys.argv[1:4]), 7)[:3]
ROOMY = 1e-11  # of the radius: within it features touch in the pose of the answer, which is rounded


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def turned(x, w, s):
    """By 2 atan(|w| s), times 1 + |w|^2 s^2: the quaternion (1, s w)."""
    v = tuple(s * c for c in w)
    square, along, across = dot(v, v), dot(v, x), cross(v, x)
    return tuple((1 - square) * x[k] + 2 * along * v[k] + 2 * across[k] for k in range(3))


def directions(a, b):
    """One of them parts what is apart: normals of faces of the difference a - b, or, where it is flat, across these."""
    sides = [minus(of[k], of[k - 1]) for of in (a, b) for k in range(len(of)) if len(of) > 1]
    gap = minus(a[0], b[0])
    normals = [n for k, d in enumerate(sides) for e in sides[:k] if any(n := cross(d, e))]
    yield from normals
    yield gap
    for d in sides:
        yield d
        yield cross(d, cross(gap, d))
        for n in normals:
            yield cross(n, d)


def apart(a, b, roomy=0):
    """Is there a direction along which one is beyond the other, by more than `roomy` of a length of 32?"""
    for n in directions(a, b):
        one, other = [dot(n, x) for x in a], [dot(n, x) for x in b]
        between = max(min(one) - max(other), min(other) - max(one))
        if between > 0 and (not roomy or float(between) > 32 * roomy * math.sqrt(float(dot(n, n)))):
            return True
    return False


def posed(query, s):
    times = 1 + dot(query["axis"], query["axis"]) * s * s
    return [turned(x, query["axis"], s) for x in query["a"]], [tuple(times * c for c in x) for x in query["b"]]


def parameter(query, radians):
    return Fraction(math.tan(radians / 2) / math.sqrt(dot(query["axis"], query["axis"])))


def read(folder):
    with open(folder / "pairs.csv", newline="") as file:
        for row in csv.DictReader(file):
            points = {of: [tuple(Fraction(float(row[f"{of}{k}_{x}"])) for x in "xyz") for k in range(3) if row[f"{of}{k}_x"]]
                      for of in "ab"}
            yield {**row, **points, "axis": tuple(int(row[f"axis_{x}"]) for x in "xyz")}


class Turns(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = Path(cls.folder.name)
        cls.script = [sys.executable, "-B", str(SOURCE / "experiments/28_turns/turns.py")]
        subprocess.run([*cls.script, "make", cls.folder.name, "--seed", str(SEED), "--pairs", str(PAIRS),
                        "--meshes", str(MESHES)], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_nothing_is_before_and_something_is_there(self):
        dice = random.Random(SEED)
        for query in read(self.path):
            first = float(query["first_rad"] or query["largest_rad"])
            before = [first * (1 - 1e-9), first * (1 - 1e-4)] + [first * dice.random() for _ in range(4)]
            for radians in before if first > 0 else []:
                self.assertTrue(apart(*posed(query, parameter(query, radians))), (query["query"], radians))
            if query["first_rad"]:
                self.assertFalse(apart(*posed(query, parameter(query, first)), ROOMY), query["query"])

    def test_the_same_seed_makes_the_same_bytes(self):
        with tempfile.TemporaryDirectory() as again:
            subprocess.run([*self.script, "make", again, "--seed", str(SEED), "--pairs", "72", "--meshes", "9"], check=True)
            lines = (self.path / "pairs.csv").read_text().splitlines()
            self.assertEqual((Path(again) / "pairs.csv").read_text().splitlines(), lines[:73])
            for file in sorted((Path(again) / "meshes").iterdir()):
                self.assertEqual(file.read_bytes(), (self.path / "meshes" / file.name).read_bytes())

    def test_ours_misses_nothing(self):
        out = tempfile.mkdtemp(dir=self.folder.name)
        subprocess.run([BUILD / "experiments/28_turns", "--profile", "quick", "--out", out], check=True,
                       env={**os.environ, "IMPINGE_TURNS": self.folder.name})
        with open(Path(out) / "turns.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        ours = [row for row in rows if row["method"].startswith("turn_")]
        self.assertEqual(sum(int(row["queries"]) for row in ours), PAIRS + 2 * MESHES)
        for row in ours:
            self.assertEqual(row["missed"], "0", row)
            self.assertLess(float(row["largest_late_rad"]), 1e-7, row)
        exact = [row for row in rows if row["method"] == "cgal_exact"]  # of poses that are rounded
        self.assertGreater(len(exact), 0)
        for row in exact:
            self.assertEqual(row["early"], "0", row)
        self.assertGreater(sum(int(row["missed"]) for row in exact), 0, "steps miss grazes")

    def test_the_score_counts(self):
        queries = list(read(self.path))
        meet = [q for q in queries if q["first_rad"] and q["family"] == "plain"]
        never = [q for q in queries if q["family"] == "never"]
        answers = [(meet[0]["query"], ""), (meet[3]["query"], float(meet[3]["first_rad"]) + 1e-3),
                   (meet[6]["query"], float(meet[6]["first_rad"]) - 1e-3), (never[0]["query"], 1.0), (never[3]["query"], "")]
        file = self.path / "answers.csv"
        file.write_text("query,angle_rad\n" + "".join(f"{name},{radians}\n" for name, radians in answers))
        told = subprocess.run([*self.script, "score", self.folder.name, str(file)], check=True, capture_output=True, text=True)
        rows = {(row["kind"], row["family"]): row for row in csv.DictReader(told.stdout.splitlines())}
        plain, apart_always = rows["vertex_face", "plain"], rows["vertex_face", "never"]
        self.assertEqual([plain[name] for name in ("queries", "misses", "false_hits", "early")], ["3", "2", "0", "1"])
        self.assertEqual([apart_always[name] for name in ("queries", "misses", "false_hits")], ["2", "0", "1"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
