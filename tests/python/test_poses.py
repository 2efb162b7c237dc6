# SPDX-License-Identifier: GPL-3.0-or-later
"""Gaps, contact and the smallest gap of poses, as arrays."""
import signal
import threading
import time
import warnings

import impinge
import numpy as np
import pytest
from shared import TURNS, sphere


def test_gaps_are_those_of_each_pose_asked_alone(hip):
    matrices = hip.matrices(TURNS)
    for k, (pose, row) in enumerate(zip(TURNS, hip.smallest_gap(TURNS))):
        truth = hip.ask("gaps", pose=list(pose))["gap"]
        for gap, surface in zip(hip.gaps(matrices), ("ball", "socket")):
            assert np.isfinite(truth[surface]).sum() > 100
            assert gap[k] == pytest.approx(truth[surface], abs=1e-5, nan_ok=True)  # floats
        least = truth[("ball", "socket")[row["surface"]]][row["vertex"]]
        assert least == min(np.nanmin(gap) for gap in truth.values()) == pytest.approx(row["gap_mm"], abs=1e-9)
        assert row["bound_mm"] < 1e-9 and 0 <= row["clock"] < 12
    matrices[-1, :3, 3] += (0.4, -0.3, 0.2)
    shifted = hip.ask("poses", path="flexion=-20,abduction=20,internal_rotation=-30,tx=0.4,ty=-0.3,tz=0.2", outputs=["gap"])["rows"][0]
    assert min(np.nanmin(gap) for gap in hip.gaps(matrices[-1:])) == pytest.approx(shifted["smallest_gap_mm"], abs=1e-5)


def test_touch_agrees_with_the_gaps_of_vertices(hip):
    poses = np.column_stack([np.linspace(0, 130, 60), np.zeros(60), np.linspace(0, 40, 60)])
    touches = hip.touch(poses)
    gap = hip.smallest_gap(poses)["gap_mm"]
    assert touches[gap < -1e-6].all() and (gap < -1e-6).any()
    assert (gap[~touches] > -1e-6).all() and not touches.all()


def test_what_hangs_on_an_opening_is_masked():
    """A speck in a ball that is open above it may be in bone or not."""
    corners = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], dtype=float)
    speck = (corners + (0.0, 0.0, 12.0), np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]))
    joint = impinge.Joint.from_arrays(sphere(20.0, open_above=15.0), sphere(25.0, open_above=10.0), centre=(0, 0, 0), socket_part={"speck": speck})
    shifts = np.tile(np.eye(4), (3, 1, 1))
    shifts[:, 2, 3] = (0.0, 3.0, -7.0)
    assert joint.touch(shifts).tolist() == [None, True, True]
    assert joint.ask("touch")["contact"]["state"] == "unknown"
    rows = joint.ask("poses", path="tz=0..3/3")
    assert (rows["touching"], rows["unknown"]) == (1, 1)


def test_spheres_touch_where_their_shift_takes_up_the_space():
    joint = impinge.Joint.from_arrays(sphere(20.0), sphere(25.0, open_above=10.0), centre=(0, 0, 0))
    shifts = np.tile(np.eye(4), (4, 1, 1))
    shifts[:, 0, 3] = (0.0, 4.5, 5.3, 7.0)  # the polyhedra lie within 0.2 mm of the spheres
    assert joint.touch(shifts).tolist() == [False, False, True, True]
    assert abs(joint.smallest_gap(shifts[:1])["gap_mm"][0] - 5.0) < 0.3


def test_vertices_of_no_face_have_no_gap():
    vertices, faces = sphere(20.0)
    joint = impinge.Joint.from_arrays((np.vstack([vertices, (0.0, 0.0, -40.0)]), faces), sphere(25.0, open_above=10.0), centre=(0, 0, 0))
    for precision in (None, 1.0):
        ball, _ = joint.gaps((0, 0, 0), precision_deg=precision)
        assert len(ball[0]) == len(joint.ball.vertices) and np.isnan(ball[0][-1]) and np.nanmin(ball) > 4.0


def test_tables_come_near_the_faces(hip):
    ball, socket = hip.gaps(TURNS)
    for precision, most in ((0.25, 0.3), (1.0, 1.2)):
        for exact, table in zip((ball, socket), hip.gaps(TURNS, precision_deg=precision)):
            both = ~np.isnan(exact) & ~np.isnan(table)
            assert both.sum() > 0.5 * (~np.isnan(exact)).sum()
            assert np.quantile(abs(exact - table)[both], 0.9) < most
            assert (exact != table)[both].any()


def test_quaternions_have_w_first_and_turn_about_the_centre(hip):
    random = np.random.default_rng(3)
    given = random.normal(size=(6, 4))
    given /= np.linalg.norm(given, axis=1)[:, None]
    found = hip.matrices(given)
    points = random.normal(size=(10, 3)) * 30
    for (w, *v), matrix in zip(given, found):
        turned = points + 2 * np.cross(v, np.cross(v, points) + w * points)  # of vectors alone
        assert np.allclose((hip.centre + points) @ matrix[:3, :3].T + matrix[:3, 3], hip.centre + turned, atol=1e-12)
    assert np.array_equal(hip.matrices(given[:4, None]), found[:4]) and np.array_equal(hip.matrices(given[0]), found[:1])
    for lone in (3, 4):  # which has the shape of one matrix
        with pytest.raises(ValueError, match=r"matrix 0 .*; quaternions, 3 or 4, need the shape \(n, 1, 4\)"):
            hip.matrices(given[:lone])
    with pytest.raises(ValueError, match=r"shape \(3, 3\) that is a rotation would be read as three poses of angles"):
        hip.touch(found[0, :3, :3])
    with pytest.raises(ValueError, match="poses: quaternion 1 has not the length 1; give w, x, y, z of unit length"):
        hip.matrices([(1, 0, 0, 0), (0, 0, 0, 0)])


def test_arrays_are_shared_and_not_copied(hip):
    vertices = hip.ball.vertices
    assert np.shares_memory(vertices, hip.ball.vertices) and not vertices.flags.writeable
    assert hip.ball.faces.max() == len(vertices) - 1 and hip.ball.areas.shape == (len(vertices),)
    out = (np.empty((5, len(vertices)), np.float32), np.empty((5, len(hip.socket.vertices)), np.float32))
    found = hip.gaps(TURNS, out=out)
    assert found[0] is out[0] and found[1] is out[1]
    assert np.array_equal(out[0], hip.gaps(np.asfortranarray(TURNS))[0], equal_nan=True)
    kept = impinge.Joint.from_hip("normal", faces=500).ball.vertices  # the joint is gone, its vertices are not
    assert np.isfinite(kept).all() and np.linalg.norm(kept, axis=1).max() < 200


def test_a_shift_leaves_views_of_the_socket_as_they_are():
    joint = impinge.Joint.from_hip("normal", faces=900, side="right")
    views = [joint.socket.vertices, joint.socket.faces, joint.socket.areas]
    before = [view.copy() for view in views]
    joint.limits("flexion", translation=[0, 0, 1])
    again = [joint.socket.vertices, joint.socket.faces, joint.socket.areas]
    for view, then, now in zip(views, before, again):
        assert np.array_equal(view, then) and np.array_equal(now, then)


def interrupted_after(seconds, ask):
    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        with pytest.raises(KeyboardInterrupt):
            ask()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_other_threads_go_on_while_gaps_are_worked_out():
    joint = impinge.Joint.from_hip("cam", faces=12000)
    poses = np.zeros((4000, 3))
    joint.gaps(poses[:1])
    started, done = threading.Event(), threading.Event()

    def work():
        started.set()
        joint.gaps(poses, out=out)
        done.set()

    out = tuple(np.empty((len(poses), len(s.vertices)), np.float32) for s in (joint.ball, joint.socket))
    thread = threading.Thread(target=work)
    thread.start()
    started.wait()
    for _ in range(20):
        time.sleep(0.001)
        assert not done.is_set()
    thread.join()


@pytest.mark.parametrize("ask", [lambda joint: joint.touch(np.tile(TURNS, (4_000_000, 1))), lambda joint: joint.volume(width=1e-4)])
def test_an_interrupt_ends_a_long_question(hip, ask):
    interrupted_after(0.3, lambda: ask(hip))


def test_all_threads_get_the_answers_of_one(hip):
    truth = hip.gaps(TURNS)[0], hip.touch(TURNS), hip.smallest_gap(TURNS)
    joint = impinge.Joint.from_hip("cam", faces=900)
    wrong = []

    def ask():
        found = joint.gaps(TURNS)[0], joint.touch(TURNS), joint.smallest_gap(TURNS)
        wrong.extend(k for k in range(3) if found[k].tobytes() != truth[k].tobytes())

    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def test_matrices_that_no_joint_can_follow_are_warned_of(files):
    joint = impinge.Joint.read(*files, side="right", centre=impinge.Joint.read(*files).centre + (0, 0, 0.5))
    matrices = joint.matrices(TURNS)
    far = matrices.copy()
    far[2:, :3, 3] += (0, 400, 0)
    with pytest.warns(UserWarning, match="poses: 3 of 5 poses, first pose 2, move the centre of the ball as far as 400 mm"):
        joint.touch(far)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        joint.touch(matrices)


def test_a_gap_that_is_there_from_the_start_is_warned_of(hip):
    with pytest.warns(UserWarning, match="the smallest gap at the start is 3.* mm .*not above the 4 mm of cartilage_mm="):
        rows = hip.limits("flexion", cartilage_mm=4)["limits"]
    assert [row["state"] for row in rows if row["threshold_mm"] == 4] == ["blocked"]
