# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits, volume, cut, orientation, measures and certificates: against NumPy and against `scene`."""
import csv
import json
import subprocess
import sys

import impinge
import numpy as np
import pytest
from shared import ROOT, program, scene, sphere, table, written


def turn(motion, degrees):
    place = {"flexion": 0, "extension": 0, "abduction": 1, "adduction": 1}.get(motion, 2)
    angles = [0.0, 0.0, 0.0]
    angles[place] = -degrees if motion in ("extension", "adduction", "external_rotation") else degrees
    return angles


def test_a_limit_separates_poses_that_are_free_from_one_that_touches(hip):
    found = [limit for limit in hip.limits() if limit["centre"] == "ball" and limit["threshold_mm"] == 0]
    assert [limit["motion"] for limit in found] == [
        "flexion", "extension", "abduction", "adduction", "internal_rotation", "external_rotation"]
    limited = [limit for limit in found if limit["state"] == "limited"]
    assert len(limited) > 3
    for limit in limited:
        assert not hip.touch(f"{limit['motion']}={limit['low_deg']}")[0]
        assert hip.touch(f"{limit['motion']}={limit['high_deg']}")[0]
        assert not hip.touch([turn(limit["motion"], share * limit["low_deg"]) for share in np.linspace(0, 1, 50)]).any()


def test_left_and_right_are_mirror_images():
    found = [impinge.Joint.from_hip("mixed", faces=900, side=side).limits("abduction")[0] for side in ("left", "right")]
    assert found[0]["low_deg"] == pytest.approx(found[1]["low_deg"], abs=1e-6)
    assert found[0]["clock"] == pytest.approx(found[1]["clock"], abs=1e-6)


def test_gaps_and_limits_are_those_of_the_program(files, tmp_path):
    ball, socket = files
    joint = impinge.Joint.read(ball, str(socket), side="right")
    meshes = ["--ball", ball, "--socket", socket, "--side", "right"]
    done = program("SCENE", *meshes, "--pose", "flexion=80,abduction=-10", "--out", tmp_path)
    assert done.returncode == 0, done.stderr
    with open(tmp_path / "gaps.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for name, gap in zip(("ball", "socket"), joint.gaps([80, -10, 0])):
        theirs = np.array([float(row["gap_mm"] or "nan") for row in rows if row["surface"] == name])
        assert theirs.shape == gap[0].shape
        both = ~np.isnan(theirs) & ~np.isnan(gap[0])
        assert both.sum() > 100 and (np.isnan(theirs) != np.isnan(gap[0])).sum() <= 2
        assert abs(theirs - gap[0])[both].max() < 2e-3
    program("SCENE", *meshes, "--question", "limit", "--motion", "flexion", "--out", tmp_path)
    contact = json.loads((tmp_path / "summary.json").read_text(encoding="utf-8"))["contact"]
    ours = [limit for limit in joint.limits("flexion") if limit["threshold_mm"] == 0]
    assert len(contact) == len(ours)
    for theirs, limit in zip(contact, ours):
        for key in ("centre", "state", "low_deg", "high_deg", "centre_low_deg", "half_mm_gap_deg", "leaves_ball_mesh_deg"):
            assert theirs[key] == limit[key], key


def test_the_volume_is_that_of_the_program(files, tmp_path):
    scene(files, tmp_path, "--question", "volume", "--width", "0.3", "--gap", "0.2")
    theirs, ours = written(tmp_path, "volume.json"), impinge.Joint.read(*files, side="right").volume(width=0.3, gap_mm=0.2)
    for key in ("share_low", "share_high", "reachable_low", "reachable_high", "neutral_blocked", "unknown", "open", "cells_asked"):
        assert ours[key] == theirs[key], key
    assert [(m["motion"], m["low_deg"], m["high_deg"]) for m in ours["motions"]] == [
        (m["motion"], m["low_deg"], m["high_deg"]) for m in theirs["motions"]]
    rows, cells = table(tmp_path, "volume.csv"), ours["cells"]
    assert len(rows) == len(cells) > 500
    for key in ("level", "cell", "w", "x", "y", "z", "radius_deg", "share"):
        assert (cells[key] == [float(row[key]) for row in rows]).all(), key
    assert [("free", "blocked", "unknown", "open")[k] for k in cells["state"]] == [row["state"] for row in rows]
    assert [{1: "yes", 0: "no", -1: ""}[k] for k in cells["reachable"]] == [row["reachable"] for row in rows]


def turned_by(q):
    """The rotation of a quaternion w, x, y, z."""
    w, v = q[0] / np.linalg.norm(q), q[1:] / np.linalg.norm(q)
    cross = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return np.eye(3) + 2 * w * cross + 2 * cross @ cross


def test_cells_hold_what_they_say(hip):
    cells = hip.volume(width=0.2)["cells"]
    assert cells["share"].sum() == pytest.approx(1, abs=1e-9)
    random = np.random.default_rng(2)
    for state, touches in ((0, False), (1, True)):
        some = random.choice(cells[cells["state"] == state], 150)
        poses = np.tile(np.eye(4), (len(some), 1, 1))
        for pose, cell in zip(poses, some):  # anywhere in the cell: along the sides of its cube
            q = np.array([cell[key] for key in "wxyz"])
            side = np.arange(4) != cell["cell"] // 8 ** cell["level"]
            q[side] += random.uniform(-1, 1, 3) / 2.0 ** cell["level"]
            pose[:3, :3] = turned_by(q)
        assert (hip.touch(poses) == touches).all()


def test_a_ball_in_a_wider_cup_turns_freely():
    joint = impinge.Joint.from_arrays(sphere(20.0), sphere(25.0, open_above=10.0), centre=(0, 0, 0))
    found = joint.volume()
    assert found["share_low"] > 1 - 1e-8 and found["reachable_low"] > 1 - 1e-8 and found["open"] == found["unknown"] == 0
    blocked = joint.volume(gap_mm=5.2)  # more than the radii leave
    assert blocked["share_high"] < 1e-8 and blocked["neutral_blocked"] and blocked["motions"] == []


def test_the_cut_is_that_of_the_program_and_reaches_what_is_required(files, tmp_path):
    asked = ["flexion=90,internal_rotation=25", "flexion=100"]
    scene(files, tmp_path, "--question", "resection", "--require", asked[0], "--require", asked[1], "--clearance", "0.4")
    joint, theirs = impinge.Joint.read(*files, side="right"), written(tmp_path, "resection.json")
    ours = joint.resection(asked, clearance_mm=0.4)
    for key in ("volume_mm3", "area_mm2", "depth_mm"):
        assert list(ours[key]) == theirs[key], key
    assert dict(zip("xyz", ours["deepest"])) == theirs["deepest"] and ours["mesh_volume_mm3"] == theirs["mesh_volume_mm3"]
    assert ours["neck"] == theirs["neck"]
    for leg, other in zip(ours["legs"], theirs["legs"]):
        assert {**leg, "start": dict(zip(("flexion", "abduction", "internal_rotation"), leg["start"]))} == other
    cut = impinge.Joint.from_arrays(
        (ours["vertices"], ours["faces"]), (joint.socket.vertices + joint.centre, joint.socket.faces), side="right",
        centre=joint.centre)
    way = [[90, 0, angle] for angle in range(26)] + [[angle, 0, 0] for angle in range(101)]
    assert joint.touch(way).any() and not cut.touch(way).any()
    assert np.nanmin(cut.smallest_gap(way)["gap_mm"]) > 0.39
    assert ours["depth"].max() == pytest.approx(ours["depth_mm"][1], rel=0.1)
    assert joint.resection([[90, 0, 25], [100, 0, 0]], clearance_mm=0.4)["volume_mm3"] == ours["volume_mm3"]


def test_the_map_of_orientations_is_that_of_the_program(files, tmp_path):
    scene(files, tmp_path, "--question", "orientation", "--require", "flexion=30", "--tilt", "5")
    theirs = written(tmp_path, "orientation.json")
    ours = impinge.Joint.read(*files, side="right").orientation_map([30, 0, 0], tilt_deg=5)
    assert ours["as_scanned"] == theirs["as_scanned"] and ours["area_deg2"] == theirs["area_deg2"]
    rows, squares = table(tmp_path, "orientation.csv"), ours["squares"]
    assert len(rows) == len(squares) > 20
    for key in ("inclination_deg", "anteversion_deg", "half_width_deg"):
        assert (squares[key] == [float(row[key]) for row in rows]).all(), key
    assert [("free", "blocked", "unknown", "open")[k] for k in squares["state"]] == [row["state"] for row in rows]
    assert [ours["legs"][k] if k >= 0 else "" for k in squares["leg"]] == [row["motion"] for row in rows]
    assert ((squares["leg"] < 0) == (squares["state"] == 0)).all()


def test_measures_are_those_of_the_program_and_of_the_parameters(files, tmp_path):
    scene(files, tmp_path, "--question", "measures")
    joint, rows = impinge.Joint.read(*files, side="right"), table(tmp_path, "measures.csv")
    ours = joint.measures()
    assert [m["measure"] for m in ours] == [row["measure"] for row in rows]
    for measure, row in zip(ours, rows):
        assert (measure["unit"], measure["state"]) == (row["unit"], row["state"])
        for key in ("value", "uncertainty", *(f"published_{part}" for part in ("mean", "sd", "median", "lower_quartile", "upper_quartile"))):
            assert measure[key] == (float(row[key]) if row[key] else None)
        for key in ("published_of", "published_source"):
            assert measure[key] == (row[key] or None)
    alpha = next(m for m in ours if m["measure"] == "alpha_at_3")
    assert (alpha["published_mean"], alpha["published_sd"], alpha["published_source"][:9]) == (40.9, 7.0, "Hack 2010")
    by_name = {m["measure"]: m["value"] for m in impinge.Joint.from_hip("cam", faces=4000).measures()}
    made = impinge.hip_parameters("cam")
    assert by_name["head_radius"] == pytest.approx(made["head_radius"], abs=0.05)
    assert by_name["neck_shaft_angle"] == pytest.approx(made["neck_shaft_angle"], abs=0.5)


def test_certificates_are_those_of_the_program_and_are_accepted(files, tmp_path):
    joint = impinge.Joint.read(*files, side="right")
    for pose, motion, words, says in (
            ("flexion=80", None, ["--question", "touch"], "clear: "),
            ("flexion=120,internal_rotation=40", None, ["--question", "touch"], "blocked: "),
            ("flexion=80", "internal_rotation", ["--question", "limit", "--motion", "internal_rotation"], "clear: ")):
        file = tmp_path / "theirs.txt"
        scene(files, tmp_path, "--pose", pose, "--certificate", file, *words)
        text = joint.certificate(pose, motion=motion)
        assert text == file.read_text(encoding="utf-8")
        (tmp_path / "ours.txt").write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, ROOT / "experiments/check_certificate.py", tmp_path / "ours.txt", *files],
                              capture_output=True, text=True, check=False)
        assert done.returncode == 0 and done.stdout.startswith(says), done.stderr + done.stdout
    assert joint.certificate(joint.matrices("flexion=80")) == joint.certificate("flexion=80")
