# SPDX-License-Identifier: GPL-3.0-or-later
"""Joints of files, arrays and parameters: frames, sides, landmarks; and schemes."""
import impinge
import numpy as np
import pytest
from shared import TURNS, marked, sphere, standing


def test_landmarks_say_how_the_pelvis_leans(files, tmp_path):
    centre = impinge.Joint.read(*files, side="right").centre
    places = standing(centre, 12)
    joint = impinge.Joint.read(*files, side="right", landmarks=marked(tmp_path / "points.csv", places))
    assert joint.landmarks["pelvic_tilt_deg"] == pytest.approx(12)
    assert impinge.Joint.read(*files, side="right").landmarks is None
    with pytest.raises(ValueError, match="landmarks: .*; leave them out"):
        joint.certify()
    swapped = marked(tmp_path / "swapped.csv", {**places, "asis_right": places["asis_left"], "asis_left": places["asis_right"]})
    with pytest.raises(RuntimeError, match="swapped.csv: the right landmarks .*; check the labels and the axes"):
        impinge.Joint.read(*files, side="right", landmarks=swapped)


def test_landmarks_give_joints_of_arrays_the_frames_that_they_give_those_of_files(files, tmp_path):
    read = impinge.Joint.read(*files, side="right")
    places = standing(read.centre, -7)
    femur = {"Medial epicondyle": read.centre + (-30, 40, -380), "lateral EPICONDYLE": tuple(read.centre + (40, 40, -380))}
    arrays = [(s.vertices + read.centre, s.faces) for s in (read.ball, read.socket)]
    for landmarks in (places, places | femur, {**places, **femur, "sacrum": (0, 0, 0)}):
        points = marked(tmp_path / "points.csv", landmarks)
        truth = impinge.Joint.read(*files, side="right", centre=read.centre, landmarks=points)
        assert truth.landmarks["pelvic_tilt_deg"] == pytest.approx(-7)
        for given in (landmarks, points, str(points)):
            joint = impinge.Joint.from_arrays(*arrays, side="right", centre=read.centre, landmarks=given)
            assert joint.landmarks == truth.landmarks
            assert np.allclose(joint.matrices(TURNS), truth.matrices(TURNS), atol=1e-9)
            assert joint.limits("flexion")["limits"][0]["low_deg"] == pytest.approx(truth.limits("flexion")["limits"][0]["low_deg"], abs=1e-3)
        assert impinge.Joint.read(*files, side="right", centre=read.centre, landmarks=landmarks).landmarks == truth.landmarks
    assert joint.landmarks["scanned_flexion_deg"] == pytest.approx(np.degrees(np.arctan2(40, 380)) - 7)
    for begins_at_the_scan in (np.eye(4), (1.0, 0.0, 0.0, 0.0)):
        with pytest.raises(ValueError, match="give angles, or leave the landmarks out"):
            joint.touch(begins_at_the_scan)


def test_arrays_without_faces_are_refused():
    with pytest.raises(ValueError, match="has no faces"):
        impinge.Joint.from_arrays((sphere(20.0)[0], np.zeros((0, 3), int)), sphere(25.0, open_above=10.0))


def test_headers_of_slicer_say_the_axes(files, tmp_path):
    heads = []
    for file in files:
        said = tmp_path / file.name
        said.write_bytes(file.read_bytes().replace(b"\ncomment SPACE=RAS", b"\ncomment SPACE=LPS"))
        heads.append(said)
    with pytest.warns(UserWarning, match="check axes= first"):  # the files of a right hip, turned by half a turn
        joint = impinge.Joint.read(*heads, side="right")
    truth = impinge.Joint.read(*files, side="right")
    assert (joint.axes, truth.axes) == ("LPS", "RAS")
    turned = np.diag([-1, -1, 1]) @ truth.matrices(TURNS)[:, :3, :3] @ np.diag([-1, -1, 1])
    assert np.allclose(joint.matrices(TURNS)[:, :3, :3], turned, atol=1e-12)
    assert np.array_equal(joint.ball.vertices, truth.ball.vertices)  # as they lie in the file
    with pytest.raises(impinge.FileError, match="LPS.*axes="):
        impinge.Joint.read(*heads, side="right", axes="RAS")
    with pytest.raises(impinge.FileError, match="SPACE=RAS.*SPACE=LPS"):
        impinge.Joint.read(*heads, side="right", socket_part=files[0])
    for axes, part in (("LPS", files[0]), ("RAS", heads[0])):
        with pytest.raises(impinge.FileError, match="leave axes= out"):
            impinge.Joint.from_arrays(*((mesh.vertices, mesh.faces) for mesh in (truth.ball, truth.socket)), axes=axes, ball_part=part)


def test_parameters_make_the_hip_that_they_say():
    assert "cam" in impinge.hip_presets()
    cam, changed = impinge.hip_parameters("cam"), impinge.Joint.from_hip("cam", faces=2000, head_radius=22)
    ranges = impinge.hip_parameter_ranges()
    assert set(cam) == {"side", *ranges} and cam["cam_height"] > 0
    assert all(least <= cam[name] <= most for name, (_, least, most) in ranges.items())
    assert np.quantile(np.linalg.norm(changed.ball.vertices, axis=1), 0.1) == pytest.approx(22, abs=0.2)


def test_a_side_is_asked_for_and_a_wrong_one_warned_of(files):
    joint = impinge.Joint.read(*files)
    assert joint.side is None and joint.gaps("flexion=10")[0].shape[0] == 1
    with pytest.raises(ValueError, match="give left or right with side="):
        joint.gaps([0, 10, 0])
    for ask in (joint.resect, joint.orient):
        with pytest.raises(ValueError, match="side: .* to know it; give left or right"):
            ask([0, 10, 0])
    with pytest.raises(ValueError, match="side: measures need to know it; give left or right"):
        joint.measure()
    assert joint.volume(width=0.5)["motions"] == []
    with pytest.warns(UserWarning, match="lies to the left of the ball, which no left socket does; check axes= first"):
        wrong = impinge.Joint.read(*files, side="left")
    assert any("check axes= first" in warning for warning in wrong.warnings)


@pytest.mark.parametrize("name", impinge.schemes())
def test_schemes_give_their_directions_and_stencils(name):
    scheme = impinge.Scheme(name, 5.0)
    entries = scheme.directions()
    assert entries.shape == (len(scheme), 3) and np.allclose(np.linalg.norm(entries, axis=1), 1)
    random = np.random.default_rng(1).normal(size=(500, 3))
    places, weights, cells = scheme.stencils(random)
    assert np.allclose(weights.sum(axis=1), 1) and weights.min() >= 0 and (weights[places < 0] == 0).all()
    assert places.max() < len(scheme) and 0 <= cells.min() and cells.max() < scheme.cells
    unit = random / np.linalg.norm(random, axis=1, keepdims=True)
    nearest = np.degrees(np.arccos(np.clip(unit @ entries.T, -1, 1).max(axis=1)))
    assert nearest.max() <= scheme.covering_radius_deg + 1e-6
    taps = np.einsum("ni,nki->nk", unit, entries[places])[weights > 0]
    assert np.degrees(np.arccos(np.clip(taps, -1, 1))).max() <= scheme.stencil_radius_deg + 1e-6
    assert scheme.name == name and scheme.label and scheme.citation


def test_pieces_centres_and_contact_are_warned_of(files):
    ball, socket = sphere(20), sphere(24, open_above=5)
    speck = sphere(0.5)[0] + (0, 0, 21.5), sphere(0.5)[1]
    both = np.concatenate([ball[0], speck[0]]), np.concatenate([ball[1], speck[1] + len(ball[0])])
    with pytest.warns(UserWarning, match=r'ball: has 2 pieces .* 40.0 and 1.0 mm across.*with keep="largest"'):
        impinge.Joint.from_arrays(both, socket, centre=(0, 0, 0))
    with pytest.warns(UserWarning, match="ball: 1 of its 2 pieces left out, 1.0 mm across"):
        joint = impinge.Joint.from_arrays(both, socket, centre=(0, 0, 0), keep="largest")
    assert len(joint.ball.faces) == len(ball[1]) and len(joint.warnings) == 1
    with pytest.raises(ValueError, match="keep: 'some' is no choice of pieces; give all or largest"):
        impinge.Joint.read(*files, keep="some")
    with pytest.warns(UserWarning, match=r"ball: the centre that was given, 0.000,0.000,6.000, is 6.0 mm from"):
        impinge.Joint.from_arrays(ball, socket, centre=(0, 0, 6))
    with pytest.warns(UserWarning, match=r"ball and socket touch as scanned, 0.\d+ mm deep"):
        joint = impinge.Joint.from_arrays(sphere(24.2), socket, centre=(0, 0, 0))
    assert joint.touch([0, 0, 0])[0]
    joint = impinge.Joint.from_arrays(sphere(24.2), socket, centre=(0, 0, 0), overlap_mm=0.5)
    assert not joint.touch([0, 0, 0])[0] and not joint.warnings
    assert joint.smallest_gap([0, 0, 0])["gap_mm"][0] == pytest.approx(0.3, abs=0.1)
    with pytest.raises(ValueError, match="overlap_mm: .*; leave it out"):
        joint.certify()
    with pytest.raises(ValueError, match="overlap_mm: is no length"):
        impinge.Joint.from_arrays(ball, socket, overlap_mm=-1)


def test_left_and_right_are_mirror_images():
    found = [impinge.Joint.from_hip("mixed", faces=900, side=side).limits("abduction")["limits"][0] for side in ("left", "right")]
    assert found[0]["low_deg"] == pytest.approx(found[1]["low_deg"], abs=1e-6)
    assert found[0]["clock"] == found[1]["clock"]
