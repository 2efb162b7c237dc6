# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables, gaps and files that are no documents (test_documents.py), of the program `impinge`, the module of Python, and the page
(tests/joint3d/answers.js).

Python runs the code of the program on the same machine: its numbers are equal. The page's library is WebAssembly, and both
compute in IEEE 754 without fused sums. They differ in their libm (sines and cosines of poses and directions, one unit in the
last place), and in the order in which Eigen adds three products. Directions and places so differ by some 8 * 2^-53 radians; with
tan psi up to 1e3 and radii up to 150 mm a gap changes by at most 1.4e-10 mm. SMALL allows ten times that."""
import csv
import io
import json
import os
import re
import subprocess
import sys

import impinge
import numpy as np
import pytest
from shared import ROOT, asked, program, table

SMALL = 1.4e-9  # mm, mm^2, degrees
FINEST = np.degrees(1e-5)  # the last step towards an end that holds for every centre (limits/swept_parts.cpp)
POSE = {"flexion": 80, "abduction": -10, "internal_rotation": 20}
SCHEMES = ("rsid", "usid", "icosahedral_sine", "octahedral_equal_area", "fibonacci")  # rows, a curve, triangles, others
CUBE = {"scheme": "cube_gnomonic", "precision_deg": 1, "storage": "uint16"}  # that Python has too, interpolated as the page does it


def number(cell):
    return float(cell) if cell else None


def texts(rows, *keys):
    return [[row[key] for key in keys] for row in rows]


def rows_of(text):
    return list(csv.DictReader(io.StringIO(text)))


@pytest.fixture(name="joint", scope="module")
def read_joint(floats):
    return impinge.Joint.read(*floats, side="right")


@pytest.fixture(name="page", scope="module")
def ask_page(floats):
    if "JOINT3D_ENGINE" not in os.environ:
        pytest.skip("no page is built")
    pose = {"pose": POSE, "cartilage_mm": 4}
    wanted = {"ball": str(floats[0]), "socket": str(floats[1]), "side": "right", "pose": pose,
             "tables": [{"scheme": scheme, "precision_deg": 4, "storage": "double"} for scheme in SCHEMES] + [CUBE],
             "questions": [["report", {"asked": {"width": 0.4}, "ball": "ball.ply", "socket": "socket.ply", "program": "impinge", "viewer": "draw()"}]],
             "limits": {"translation": [0, 0, 0], "cartilage_mm": 4}}
    done = subprocess.run([os.environ["NODE"], ROOT / "tests/joint3d/answers.js", json.dumps(wanted)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def near(mine, theirs, relative=1e-9):
    return mine == pytest.approx(theirs, abs=SMALL, rel=relative, nan_ok=True)


def words(motion):
    return ",".join(f"{key}={value}" for key, value in motion.items())


@pytest.mark.parametrize("k", range(len(SCHEMES)))
def test_gaps_of_the_page(page, floats, tmp_path, k):
    """Of the same tables, so coarse that some vertices stay undecided."""
    summary = asked(floats, tmp_path, "gaps", "--pose", words(POSE), "--scheme", SCHEMES[k], "--precision", "4")
    found = page["tables"][k]
    theirs, mine = table(tmp_path, "gaps.csv"), rows_of(found["csv"])
    assert texts(mine, "surface", "vertex") == texts(theirs, "surface", "vertex") and len(mine) > 1000
    for key in ("x", "y", "z", "gap_mm"):
        assert near([number(row[key]) for row in mine], [number(row[key]) for row in theirs]), key
    smallest, verdicts = found["pose"]["smallest_gap"], found["verdicts"]
    assert [smallest[key] for key in ("surface", "vertex", "clock")] == [summary["smallest_gap"][key] for key in ("surface", "vertex", "clock")]
    assert near(smallest["gap_mm"], summary["smallest_gap"]["gap_mm"])
    bound = summary["error_bound"]
    for key in ("smallest_gap_between_mm", "largest_mm", "median_mm"):
        assert near(verdicts[key], bound[key]), key
    assert verdicts["largest_mm"] <= found["bound"]["bound_mm"]
    counts = [summary["radial_overlap"][surface]["undecided_by_bound"] for surface in ("ball", "socket")]
    assert verdicts["undecided"] == sum(counts) > 0


def test_gaps_of_the_tables_of_the_page(page, joint):
    """Bit for bit, in a pose whose rotation both libms make the same."""
    found = page["tables"][len(SCHEMES)]["pose"]
    for name, gap in zip(("ball", "socket"), joint.gaps(words(POSE), precision_deg=CUBE["precision_deg"])):
        mine = np.array(found[f"{name}_gap"], dtype=float)
        assert np.array_equal(mine, gap[0], equal_nan=True) and np.isfinite(mine).any(), name


def test_limits_of_the_page(page, floats, tmp_path):
    """The CSV that the page saves, row by row."""
    asked(floats, tmp_path, "limits", "--cartilage", "4")
    theirs, mine = table(tmp_path, "limits.csv"), rows_of(page["limits"])
    same = ("joint", "motion", "threshold_mm", "centre", "state", "clock", "what", "hangs_on_less_than_half_mm")
    assert list(mine[0]) == list(theirs[0]) and texts(mine, *same) == texts(theirs, *same)
    assert sum(bool(row["clock"]) and row["what"].startswith("rim and neck") for row in mine) > 20
    for one, other in zip(mine, theirs):
        # Both brackets hold the limit, so that they meet.
        low, high = (number(one[key]) for key in ("low_deg", "high_deg"))
        assert low <= number(other["high_deg"]) + SMALL and number(other["low_deg"]) <= high + SMALL, one
        assert one["state"] != "limited" or high - low < 1e-6, one
        for key, most in (("centre_low_deg", FINEST), ("centre_high_deg", 1e-6), ("play_low_deg", FINEST), ("play_high_deg", 1e-6), ("half_mm_gap_deg", 1e-6)):
            assert number(one[key]) == pytest.approx(number(other[key]), abs=most), (one, key)


def test_report_of_the_page(page, floats, tmp_path):
    """All that a reader reads, word for word, and the scene that the viewer draws, but for what made it."""
    asked(floats, tmp_path, "report", "--width", "0.4")
    theirs, mine = (tmp_path / "report.html").read_text(encoding="utf-8"), page["questions"][0]["html"]
    said, scene = (re.split(r"<script[^>]*>|</script>", html)[:2] for html in (theirs, mine))
    assert re.sub(r"impinge [\d.]+, commit [\w-]+", "impinge", said[0]) == scene[0]
    theirs, mine = (json.loads(one[1].replace("<\\/", "</")) for one in (said, scene))
    assert mine["joint"]["ball"] == theirs["joint"]["ball"] and list(mine["pose"]) == list(theirs["pose"])
    assert mine["pose"]["smallest_gap"]["gap_mm"] == pytest.approx(theirs["pose"]["smallest_gap"]["gap_mm"], abs=SMALL)


def test_refused_files(floats, tmp_path):
    broken = tmp_path / "broken.ply"
    broken.write_bytes(floats[0].read_bytes()[:900])
    for ball in (tmp_path / "missing.ply", broken):
        said = program("IMPINGE", "touch", ball, floats[1]).stderr
        with pytest.raises(impinge.FileError) as refused:
            impinge.Joint.read(ball, floats[1])
        assert said == f"impinge: error: {refused.value}\n"
