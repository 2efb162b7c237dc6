# SPDX-License-Identifier: GPL-3.0-or-later
"""Each question asked three ways: the program `impinge`, the module of Python, and the page (tests/joint3d/answers.js) give the
same document, and that of the program is valid against its schema.

Python runs the code of the program on the same machine: its numbers are equal. The page's library is WebAssembly, where libm
and the order of three products differ: tests/python/test_same_answers.py says by how much."""
import json
import os
import subprocess

import impinge
import jsonschema
import numpy as np
import pytest
from shared import ROOT, program, table, written

SMALL = 1.4e-9  # mm, mm^2, degrees
FINEST = 6e-4  # degrees, the last step towards an end that holds for every centre (limits/swept_parts.cpp)
# The question, what is asked, and how much the numbers of the page may differ.
QUESTIONS = [
    ("measure", {}, 1e-6),
    ("limits", {}, FINEST),
    ("limits", {"motions": ["flexion", "fadir"], "rim": True}, FINEST),
    ("limits", {"motions": ["flexion", "abduction"], "pose": "internal_rotation=5", "cartilage_mm": 2}, FINEST),
    ("certify", {"pose": "flexion=80"}, 1e-6),
    ("certify", {"pose": "flexion=80", "motion": "internal_rotation"}, 1e-6),
    ("touch", {"pose": "flexion=80,adduction=10,internal_rotation=20"}, SMALL),
    ("gaps", {"pose": "flexion=80,adduction=10,internal_rotation=20"}, SMALL),
    ("gaps", {"pose": "flexion=80", "surfaces": "ball", "outputs": "gaps", "scheme": "rsid", "precision_deg": 2}, SMALL),
    ("volume", {"width": 0.3, "gap_mm": 0.2}, 1e-6),
    ("resect", {"require": ["flexion=90,internal_rotation=25", "flexion=100"], "clearance_mm": 0.4}, 1e-5),
    ("orient", {"require": ["flexion=30"], "tilt_deg": 5, "resolution_deg": 0.75}, 1e-8),
]
BYTES = {"table_bytes", "left_out"}  # of memory: a pointer of the page is half as long
# They hang on which of two faces of one size is split first, which the last bit decides: relative.
SPLIT = {"volume_mm3", "area_mm2", "mesh_volume_mm3"}


def options(request):
    """The request as a person types it: clearance_mm is --clearance."""
    words = []
    for name, value in request.items():
        option = "--" + name.removesuffix("_mm").removesuffix("_deg").replace("_", "-")
        for one in value if isinstance(value, list) else [value]:
            words += [option] if one is True else [option, str(one)]
    return words


def different(mine, ours, allowed, where=""):
    """The first place at which two documents differ; None where they are the same."""
    if isinstance(ours, dict) and isinstance(mine, dict):
        if list(mine) != list(ours):
            return f"{where}: {list(mine)} {list(ours)}"
        pairs = [(mine[key], ours[key], f"{where}/{key}") for key in ours]
    elif isinstance(ours, list) and isinstance(mine, list) and len(mine) == len(ours):
        pairs = [(a, b, f"{where}/{k}") for k, (a, b) in enumerate(zip(mine, ours))]
    elif isinstance(ours, float) and isinstance(mine, (int, float)):
        most = 1e-4 * abs(ours) if allowed and SPLIT & set(where.split("/")) else allowed
        return None if abs(mine - ours) <= most else f"{where}: {mine} {ours}"
    else:
        return None if mine == ours else f"{where}: {mine} {ours}"
    return next((found for pair in pairs if (found := different(pair[0], pair[1], allowed, pair[2]))), None)


def answered(files, question, request):
    done = program("IMPINGE", question, *files, "--side", "right", "--json", *options(request))
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.mark.parametrize("question,request_", [(name, asked) for name, asked, _ in QUESTIONS])
def test_the_program_and_python(floats, question, request_):
    document = answered(floats, question, request_)
    jsonschema.validate(document, json.loads(program("IMPINGE", question, "--schema").stdout))
    ours = impinge.Joint.read(*floats, side="right").ask(question, **request_)
    assert different({key: ours[key] for key in document["answer"]}, document["answer"], 0.0) is None


def test_cells_are_the_rows_of_volume(floats, tmp_path):
    done = program("IMPINGE", "volume", *floats, "--width", 0.3, "--out", tmp_path)
    assert done.returncode == 0, done.stderr
    rows, cells = table(tmp_path, "volume.csv"), impinge.Joint.read(*floats).volume(width=0.3)["cells"]
    assert len(rows) == len(cells) > 500
    for key in ("level", "cell", "w", "x", "y", "z", "radius_deg", "share"):
        assert (cells[key] == [float(row[key]) for row in rows]).all(), key
    assert [("free", "blocked", "unknown", "open")[k] for k in cells["state"]] == [row["state"] for row in rows]
    assert [{1: "yes", 0: "no", -1: ""}[k] for k in cells["reachable"]] == [row["reachable"] for row in rows]


def test_the_page(floats):
    if "JOINT3D_ENGINE" not in os.environ:
        pytest.skip("no page is built")
    asked = {"ball": str(floats[0]), "socket": str(floats[1]), "side": "right", "questions": [[name, request] for name, request, _ in QUESTIONS]}
    done = subprocess.run([os.environ["NODE"], str(ROOT / "tests/joint3d/answers.js"), json.dumps(asked)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    page = {}
    for (question, request, allowed), mine in zip(QUESTIONS, json.loads(done.stdout)["questions"], strict=True):
        ours = answered(floats, question, request)["answer"]
        same = [key for key in ours if key not in BYTES]
        assert different({key: mine[key] for key in same}, {key: ours[key] for key in same}, allowed) is None
        page[question] = mine
    joint = impinge.Joint.read(*floats, side="right")
    cut, turned = (joint.ask(question, **request) for question, request, _ in QUESTIONS if question in ("resect", "orient"))
    assert max(page["resect"]["depth"]) == pytest.approx(cut["depth"].max(), abs=1e-5)
    fields = ["inclination_deg", "anteversion_deg", "half_width_deg", "state", "leg"]
    squares = np.array([list(row) for row in turned["squares"][fields].tolist()])
    assert np.reshape(page["orient"]["squares"], (-1, len(fields))) == pytest.approx(squares, abs=1e-8)


def test_arrays_of_python_are_files_of_the_program(floats, tmp_path):
    asked = {question: request for question, request, _ in QUESTIONS}
    joint = impinge.Joint.read(*floats, side="right")
    for question in ("resect", "orient"):
        done = program("IMPINGE", question, *floats, "--side", "right", "--out", tmp_path, *options(asked[question]))
        assert done.returncode == 0 and "nothing in this may guide the treatment" in done.stdout, done.stderr
    turned, rows = joint.orient(**asked["orient"]), table(tmp_path, "orientation.csv")
    squares = turned["squares"]
    assert len(rows) == len(squares) == turned["map"]["squares"] > 20
    for key in ("inclination_deg", "anteversion_deg", "half_width_deg"):
        assert (squares[key] == [float(row[key]) for row in rows]).all(), key
    assert [("free", "blocked", "unknown", "open")[k] for k in squares["state"]] == [row["state"] for row in rows]
    assert [turned["legs"][k] if k >= 0 else "" for k in squares["leg"]] == [row["motion"] for row in rows]
    cut, left = joint.resect(**asked["resect"]), impinge.Joint.read(tmp_path / "resected_ball.ply", floats[1], centre=joint.centre).ball
    assert left.vertices + joint.centre == pytest.approx(cut["vertices"], abs=2e-6) and (left.faces == cut["faces"]).all()
    assert written(tmp_path, "orientation.json") == written(tmp_path, "summary.json")["answer"]
