# SPDX-License-Identifier: GPL-3.0-or-later
"""A joint that went through pickle, or to another process, answers as before."""
import multiprocessing
import pickle
import subprocess
import sys
import warnings

import impinge
import numpy as np
import pytest
from shared import ROOT, TURNS, marked, sphere, standing


def smallest(joint):
    return joint.smallest_gap(TURNS)["gap_mm"]


def arrays(**more):
    return impinge.Joint.from_arrays(sphere(20.0), sphere(25.0, open_above=10.0), side="right", **more)


def of_file(folder):
    return arrays(landmarks=marked(folder / "places.csv", standing(np.zeros(3), 8.0)), axes="RAS")


MADE = {
    "hip": lambda _files, _folder: impinge.Joint.from_hip("cam", faces=900, cam_height=3, side="left"),
    "files": lambda files, _folder: impinge.Joint.read(*files, side="right"),
    "arrays": lambda _files, _folder: arrays(axes="LPS", centre=(0.5, 0, 0), keep="largest", overlap_mm=0.25),
    "dict": lambda _files, _folder: arrays(landmarks=standing(np.zeros(3), -5.0)),
    "landmark file": lambda _files, folder: of_file(folder),
}


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize("made", MADE)
def test_a_joint_is_the_same_after_pickle(files, tmp_path, made):
    joint = MADE[made](files, tmp_path)
    kept = pickle.dumps(joint)
    (tmp_path / "places.csv").unlink(missing_ok=True)  # it may be read where there is none
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        again = pickle.loads(pickle.dumps(pickle.loads(kept)))  # twice
    for fact in ("side", "axes", "landmarks", "warnings", "fit"):
        assert getattr(again, fact) == getattr(joint, fact), fact
    assert np.array_equal(again.centre, joint.centre)
    for surface in ("ball", "socket"):
        for array in ("vertices", "faces", "areas"):
            assert np.array_equal(getattr(getattr(again, surface), array), getattr(getattr(joint, surface), array))
    assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(again.gaps(TURNS), joint.gaps(TURNS)))
    assert again.limits("flexion") == joint.limits("flexion")


def test_processes_answer_as_this_one(hip):
    joints = [hip, arrays()]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        for joint, there in zip(joints, pool.map(smallest, joints)):
            assert np.array_equal(smallest(joint), there, equal_nan=True)


@pytest.mark.parametrize("words", [[], ["dask"]])
def test_the_example_has_a_row_for_each_joint(words, tmp_path):
    if words:
        pytest.importorskip("distributed")
    done = subprocess.run([sys.executable, "-B", ROOT / "libcore/python/examples/many_joints.py", *words], capture_output=True, text=True, check=False, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    names = [line.split(":")[0] for line in done.stdout.splitlines()]
    assert len(names) == 10 and names[:7] == list(impinge.hip_presets())
