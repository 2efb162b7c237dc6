# SPDX-License-Identifier: GPL-3.0-or-later
"""Each question asked three ways: the program `impinge`, the module of Python, and the page (tests/joint3d/answers.js) give the
same document, and that of the program is valid against its schema.

Python runs the code of the program on the same machine: its numbers are equal. The page's library is WebAssembly, where libm
and the order of three products differ: tests/python/test_same_answers.py says by how much."""
import json
import os
import pickle
import re
import subprocess

import impinge
import jsonschema
import numpy as np
import pytest
from shared import ROOT, marked, program, standing, table, written

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
    ("volume", {"width": 0.4, "play_mm": 0.5}, 1e-6),
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


# Of a joint with parts, landmarks and a map of cartilage: the question, what is asked, options that Python gives the joint.
OF_ALL = [
    ("touch", {"pose": "flexion=60,internal_rotation=20"}, []),
    ("gaps", {"pose": "flexion=60"}, ["cartilage_map"]),
    ("limits", {"motions": ["flexion", "abduction"], "cartilage_mm": "scan"}, []),
    ("limits", {"motions": ["internal_rotation"], "pose": "flexion=90", "translation": [0, 0, 0.2]}, []),
    ("poses", {"path": "flexion=0..120/30,internal_rotation=-20..20/20", "outputs": ["touch", "gap", "areas"], "cartilage_mm": 2}, []),
    ("volume", {"width": 0.8}, []),
    ("resect", {"require": ["flexion=30"], "cut": "socket", "rim_mm": 4, "clearance_mm": 0.05}, []),
    ("orient", {"require": ["flexion=20"], "resolution_deg": 6, "inclination_deg": 40, "anteversion_deg": 15}, []),
    ("measure", {}, []),
]


def ply(file):
    """Of a file of the program: its head, vertices and faces."""
    head, body = file.read_bytes().split(b"end_header\n", 1)
    ends = 24 * int(re.search(rb"element vertex (\d+)", head)[1])
    rows = np.frombuffer(body[ends:], [("corners", "u1"), ("of", "<u4", 3)])
    return head + b"end_header\n", np.frombuffer(body[:ends]).reshape(-1, 3), rows["of"]


@pytest.fixture(name="whole", scope="module")
def made_whole(tmp_path_factory):
    """Files of a hip with three parts, of its landmarks and of its cartilage; the ball overlaps the socket as scanned."""
    folder = tmp_path_factory.mktemp("whole")
    sizes = ("aiis_height=10", "greater_trochanter_width=30", "lesser_trochanter_height=8", "joint_space=0.5")
    done = program("IMPINGE", "hip", "cam", *(word for size in sizes for word in ("--set", size)), "--faces", 3000, "--out", folder)
    assert done.returncode == 0, done.stderr
    for file in folder.glob("*.ply"):  # in floats, which readers keep
        head, vertices, _ = ply(file)
        larger = 1.0 if file.stem in ("socket", "aiis") else 1.05
        file.write_bytes(head + (larger * vertices).astype("<f4").astype("<f8").tobytes() + file.read_bytes()[len(head) + vertices.nbytes :])
    places = standing(np.zeros(3), 6) | {"epicondyle_medial": (-30, 20, -380), "epicondyle_lateral": (40, 20, -380)}
    thickness = [(*x, 2 + 0.05 * x[0]) for x in 20 * np.concatenate([np.eye(3), -np.eye(3)])]
    table_of = "x,y,z,thickness_mm\n" + "".join(",".join(map(str, map(float, row))) + "\n" for row in thickness)
    (folder / "cartilage.csv").write_text(table_of, encoding="utf-8")
    return {"ball": folder / "ball.ply", "socket": folder / "socket.ply", "ball_part": [folder / "greater_trochanter.ply", folder / "lesser_trochanter.ply"],
            "socket_part": folder / "aiis.ply", "landmarks": marked(folder / "points.csv", places), "cartilage_map": folder / "cartilage.csv"}


def arrays_of(whole):
    """The same as arrays and dicts."""
    meshes = {key: {file.stem: ply(file)[1:] for file in np.atleast_1d(whole[key])} for key in ("ball", "socket", "ball_part", "socket_part")}
    places = {row["label"]: [float(row[axis]) for axis in "xyz"] for row in table(whole["landmarks"].parent, "points.csv")}
    return {**meshes, "ball": meshes["ball"]["ball"], "socket": meshes["socket"]["socket"], "landmarks": places,
            "cartilage_map": np.loadtxt(whole["cartilage_map"], delimiter=",", skiprows=1)}


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize("case", range(len(OF_ALL)))
def test_joints_with_all_that_the_program_takes(whole, case):
    question, request, more = OF_ALL[case]
    words = [str(word) for file in whole["ball_part"] for word in ("--ball-part", file)]
    words += ["--socket-part", whole["socket_part"], "--landmarks", whole["landmarks"], "--side", "right", "--centre", "0,0,0",
              "--keep", "largest", "--ignore-rest-contact", *(["--cartilage", whole["cartilage_map"]] if more else [])]
    asked = {**request, "translation": "0,0,0.2"} if "translation" in request else request
    done = program("IMPINGE", question, whole["ball"], whole["socket"], *words, "--json", *options(asked))
    assert done.returncode == 0, done.stderr
    document = json.loads(done.stdout)
    given = {key: value for key, value in whole.items() if key != "cartilage_map" or more}
    told = {"side": "right", "centre": (0, 0, 0), "keep": "largest", "ignore_rest_contact": True}
    joint = impinge.Joint.read(**given, **told)
    summary = {key: value for key, value in joint.summary.items() if key != "warnings"}  # which name keywords, not options
    assert summary == {key: document["joint"][key] for key in summary} and summary["overlap_mm"] > 0
    arrays = {key: value for key, value in arrays_of(whole).items() if key in given}
    for one in (joint, pickle.loads(pickle.dumps(joint)), impinge.Joint.from_arrays(**arrays, **told)):
        mine = dict(request, cartilage_mm=one.cartilage_of_scan()) if request.get("cartilage_mm") == "scan" else request
        ours = one.ask(question, **mine)
        assert different({key: ours[key] for key in document["answer"]}, document["answer"], 0.0) is None


def test_arrays_and_rows_beside_the_document(floats, tmp_path):
    pose, joint = "flexion=80,internal_rotation=20", impinge.Joint.read(*floats, side="right")
    assert program("IMPINGE", "gaps", *floats, "--side", "right", "--pose", pose, "--out", tmp_path).returncode == 0
    ours, rows = joint.ask("gaps", pose=pose), table(tmp_path, "distances.csv")
    for surface in ("ball", "socket"):
        theirs = [row for row in rows if row["surface"] == surface]
        assert np.array_equal(ours["gap"][surface], [float(row["gap_mm"] or "nan") for row in theirs], equal_nan=True)
        assert (ours["distance"][surface] == [[float(row["distance_lower_mm"]), float(row["distance_upper_mm"])] for row in theirs]).all()
    done = program("IMPINGE", "poses", *floats, "--side", "right", "--path", "flexion=0..120/30,tx=-1..1/1", "--outputs", "touch,gap,areas", "--out", tmp_path)
    assert done.returncode == 0, done.stderr
    poses = joint.ask("poses", path="flexion=0..120/30,tx=-1..1/1", outputs=["touch", "gap", "areas"])["rows"]
    for mine, theirs in zip(poses, table(tmp_path, "poses.csv"), strict=True):
        words = {True: "yes", False: "no", None: ""}
        assert list(mine) == list(theirs)
        assert {key: words[x] if x in (None, True, False) and key == "certified" else "" if x is None else x if isinstance(x, str) else float(x)
                for key, x in mine.items()} == {key: x if isinstance(mine[key], (str, bool, type(None))) else float(x) for key, x in theirs.items()}


def test_the_report_of_python_is_that_of_the_program(floats, tmp_path):
    asked = {"pose": "flexion=80", "width": 0.5, "cartilage_mm": 2}
    done = program("IMPINGE", "report", *floats, "--side", "right", "--out", tmp_path / "program", *options(asked))
    assert done.returncode == 0, done.stderr
    answer = impinge.Joint.read(*floats, side="right").report(tmp_path / "python", **asked)
    mine, theirs = (written(tmp_path / name, "summary.json") for name in ("python", "program"))
    assert {**mine, "times_ms": theirs["times_ms"]} == theirs and answer == theirs["answer"] and "report.html" in theirs["files"]
    for name in set(theirs["files"]) - {"summary.json"}:
        assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "program" / name).read_bytes(), name


@pytest.mark.parametrize("play_mm", [0, 0.5])
def test_cells_are_the_rows_of_volume(floats, tmp_path, play_mm):
    done = program("IMPINGE", "volume", *floats, "--width", 0.3, "--play", play_mm, "--out", tmp_path)
    assert done.returncode == 0, done.stderr
    rows, cells = table(tmp_path, "volume.csv"), impinge.Joint.read(*floats).volume(width=0.3, play_mm=play_mm)["cells"]
    for key in ("shift_x_mm", "shift_y_mm", "shift_z_mm"):
        told = [float(row.get(key) or "nan") for row in rows]
        assert np.array_equal(cells[key], told, equal_nan=True), key
        assert (np.isfinite(told) == (cells["state"] == 0 if play_mm else False)).all()
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
