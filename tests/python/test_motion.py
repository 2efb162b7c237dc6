# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits, volume, cut and measures against NumPy and what is known of a hip."""
import impinge
import numpy as np
import pytest
from shared import sphere


def turn(motion, degrees):
    place = {"flexion": 0, "extension": 0, "abduction": 1, "adduction": 1}.get(motion, 2)
    angles = [0.0, 0.0, 0.0]
    angles[place] = -degrees if motion in ("extension", "adduction", "external_rotation") else degrees
    return angles


def test_a_limit_separates_poses_that_are_free_from_one_that_touches(hip):
    found = [limit for limit in hip.limits(pose=[0, 0, 0])["limits"] if limit["centre"] == "ball" and limit["threshold_mm"] == 0]
    assert [limit["motion"] for limit in found] == [
        "flexion", "extension", "abduction", "adduction", "internal_rotation", "external_rotation"]
    limited = [limit for limit in found if limit["state"] == "limited"]
    assert len(limited) > 3
    for limit in limited:
        assert not hip.touch(f"{limit['motion']}={limit['low_deg']}")[0]
        assert hip.touch(f"{limit['motion']}={limit['high_deg']}")[0]
        assert not hip.touch([turn(limit["motion"], share * limit["low_deg"]) for share in np.linspace(0, 1, 50)]).any()


def test_left_and_right_are_mirror_images():
    found = [impinge.Joint.from_hip("mixed", faces=900, side=side).limits("abduction")["limits"][0] for side in ("left", "right")]
    assert found[0]["low_deg"] == pytest.approx(found[1]["low_deg"], abs=1e-6)
    assert found[0]["clock"] == found[1]["clock"]


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
    blocked = joint.volume(gap_mm=5.2, width=0.001)  # more than the radii leave
    assert blocked["share_high"] < 1e-8 and blocked["neutral_blocked"] and blocked["motions"] == []


def test_the_cut_reaches_what_is_required(hip):
    ours = hip.resect(["flexion=90,internal_rotation=25", "flexion=100"], clearance_mm=0.4)
    cut = impinge.Joint.from_arrays((ours["vertices"], ours["faces"]), (hip.socket.vertices, hip.socket.faces), side=hip.side, centre=hip.centre)
    way = [[90, 0, angle] for angle in range(26)] + [[angle, 0, 0] for angle in range(101)]
    assert hip.touch(way).any() and not cut.touch(way).any()
    assert np.nanmin(cut.smallest_gap(way)["gap_mm"]) > 0.39
    assert ours["depth"].max() == pytest.approx(ours["depth_mm"][1], rel=0.1)
    assert hip.resect([[90, 0, 25], {"flexion": 100}], clearance_mm=0.4)["volume_mm3"] == ours["volume_mm3"]


def test_measures_are_those_of_the_parameters():
    ours = impinge.Joint.from_hip("cam", faces=4000).measure()["measures"]
    alpha = next(m for m in ours if m["measure"] == "alpha_at_3")
    assert (alpha["published_mean"], alpha["published_sd"], alpha["published_source"][:9]) == (40.9, 7.0, "Hack 2010")
    by_name = {m["measure"]: m["value"] for m in ours}
    made = impinge.hip_parameters("cam")
    assert by_name["head_radius"] == pytest.approx(made["head_radius"], abs=0.05)
    assert by_name["neck_shaft_angle"] == pytest.approx(made["neck_shaft_angle"], abs=0.5)


def test_a_shift_leaves_views_of_the_socket_as_they_are():
    joint = impinge.Joint.from_hip("normal", faces=900, side="right")
    views = [joint.socket.vertices, joint.socket.faces, joint.socket.areas]
    before = [view.copy() for view in views]
    joint.limits("flexion", translation=[0, 0, 1])
    again = [joint.socket.vertices, joint.socket.faces, joint.socket.areas]
    for view, then, now in zip(views, before, again):
        assert np.array_equal(view, then) and np.array_equal(now, then)
