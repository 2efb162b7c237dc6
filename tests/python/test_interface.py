# SPDX-License-Identifier: GPL-3.0-or-later
"""What is refused, in which words; the stubs and the page of the program; the example."""
import ast
import inspect
import os
import re
import subprocess
import sys

import impinge
import numpy as np
import pytest
from shared import ROOT, TURNS, sphere


def marked(**landmarks):
    return impinge.Joint.from_arrays(sphere(20.0), sphere(25.0, open_above=10.0), centre=(0, 0, 0), landmarks=landmarks)


def beside(part=None, **more):
    return impinge.Joint.from_arrays(sphere(20.0), sphere(25.0, open_above=10.0), centre=(0, 0, 0), ball_part=part, **more)


REFUSED = [
    (ValueError, lambda j: impinge.Joint.from_hip("cam", side="up"), "side 'up' is neither left nor right"),
    (ValueError, lambda j: impinge.Joint.from_hip("flat"), "'flat'"),
    (ValueError, lambda j: impinge.Joint.from_hip(cam_heigth=3), "a hip has no parameter 'cam_heigth'; there are side, "),
    (ValueError, lambda j: impinge.Joint.from_hip(cam_height=99), "parameter cam_height = 99 is outside of what a hip"),
    (ValueError, lambda j: impinge.Joint.from_arrays(sphere(9), sphere(9, 1), axes="LAS"), "is left-handed and would mirror"),
    (RuntimeError, lambda j: impinge.Joint.from_arrays(sphere(9), sphere(9)), "check ball and socket"),
    (ValueError, lambda j: impinge.Joint.from_arrays(([1.0], [2]), sphere(9)), "ball: give vertices and faces as two arrays"),
    (impinge.FileError, lambda j: impinge.Joint.from_arrays((np.eye(3), [[0, 1, 3]]), sphere(9)), "is not there"),
    (ValueError, lambda j: marked(asis_right=(1, 2)), "landmarks: 'asis_right' is no place; give (x, y, z) in mm"),
    (ValueError, lambda j: marked(asis_right="here"), "landmarks: 'asis_right' is no place; give"),
    (ValueError, lambda j: marked(asis_right=(1, 2, np.nan)), "landmarks: the landmark asis_right has no place; give each once"),
    (ValueError, lambda j: marked(asis_right=(1, 2, 3), right_asis=(1, 2, 3)), "landmarks: the landmark right_asis is there twice"),
    (RuntimeError, lambda j: marked(asis_right=(1, 2, 3)), "landmarks: the landmark asis_left is missing; mark it"),
    (ValueError, lambda j: beside([1, 2]), "ball_part: is no bone; give a file, a list of files, or a dict of names, each with"),
    (ValueError, lambda j: beside({"stem": (np.eye(3), [1, 2])}), "stem: give vertices and faces as two arrays of three columns"),
    (impinge.FileError, lambda j: beside("no.ply"), "no.ply: "),
    (ValueError, lambda j: beside(cartilage_map=np.ones((2, 3))), "cartilage_map: give a file, or an array of shape (n, 4)"),
    (ValueError, lambda j: beside(cartilage_map=[[1, 0, 0, 2], [1, 0, 0, -2]]), "cartilage_map: row 1 has a negative thickness; give"),
    (ValueError, lambda j: beside(overlap_mm=1, ignore_rest_contact=True), "overlap_mm: ignore_rest_contact finds it; give one"),
    (ValueError, lambda j: j.ask("poses"), "poses: they are asked for by a file, or by a path of angles; give one of"),
    (ValueError, lambda j: j.gaps([[1.0, 2.0]]), "poses: an array of shape (1, 2) holds none; give angles in degrees"),
    (ValueError, lambda j: j.gaps([["a", "b", "c"]]), "poses: no array of numbers; give"),
    (ValueError, lambda j: j.touch([np.nan, 0, 0]), "poses: an angle is not within 180 degrees of 0"),
    (ValueError, lambda j: j.touch([181, 0, 0]), "poses: an angle is not within 180 degrees of 0"),
    (ValueError, lambda j: j.touch("bend=3"), "unknown motion 'bend'"),
    (ValueError, lambda j: j.touch(np.diag([-1.0, 1, 1, 1])), "poses: matrix 0 does not turn only"),
    (ValueError, lambda j: j.touch(np.full((1, 3, 4), np.nan)), "poses: matrix 0 does not turn only"),
    (ValueError, lambda j: j.touch(np.diag([1.0, 1, 1, 2])), "poses: matrix 0 has another last row than 0,0,0,1; quaternions, 3 or 4, need"),
    (ValueError, lambda j: j.gaps(TURNS, precision_deg=0), "precision"),
    (ValueError, lambda j: j.gaps(TURNS, out=(np.empty((5, 3), np.float32), None)), "out: give two writable float32 arrays"),
    (ValueError, lambda j: j.gaps(TURNS, out=(j.gaps(TURNS)[0].astype(float), None)), "out: give two writable float32"),
    (ValueError, lambda j: j.limits("bend"), "unknown motion 'bend'"),
    (ValueError, lambda j: j.limits("flexion", pose=[180, 0, 0]), "leaves no room for flexion"),
    (ValueError, lambda j: j.limits(cartilage_mm=-1), "cartilage_mm: -1 is out of range"),
    (ValueError, lambda j: j.volume(width=0), "width: 0 is out of range; give a number above 0, up to 1"),
    (ValueError, lambda j: j.volume(width=np.nan), "width: NaN is not finite; give a number"),
    (ValueError, lambda j: j.volume(gap_mm=-1), "gap_mm: -1 is out of range; give a number 0 or more"),
    (ValueError, lambda j: j.volume(centre_within_mm=np.inf), "centre_within_mm: Infinity is not finite"),
    (ValueError, lambda j: j.volume(play_mm=-1), "play_mm: -1 is out of range; give a number 0 or more"),
    (ValueError, lambda j: j.volume(centre_within_mm=1, play_mm=1), "every centre and play are two questions; ask for one of them"),
    (ValueError, lambda j: j.resect("flexion=0"), "require: a required motion turns something; give one, as flexion=90,"),
    (ValueError, lambda j: j.resect(), "require: a required motion turns something; give one"),
    (ValueError, lambda j: j.resect([[1, 2]]), "require: is not three angles in degrees"),
    (ValueError, lambda j: j.resect(np.empty((0, 3))), "require: a required motion turns something; give one"),
    (ValueError, lambda j: j.resect([200, 0, 0]), "require: an angle is not within 180 degrees of 0"),
    (ValueError, lambda j: j.resect({"bend": 3}), "there is no 'bend'; there are flexion, abduction, internal_rotation"),
    (ValueError, lambda j: j.resect(["flexion=20", "bend=2"]), "require: unknown motion 'bend'"),
    (ValueError, lambda j: j.resect("flexion=20", clearance_mm=0), "clearance_mm: 0 is out of range; give a number above 0"),
    (ValueError, lambda j: j.resect("flexion=20", neck_mm=-2), "neck_mm: -2 is out of range; give a number above 0"),
    (ValueError, lambda j: j.resect("flexion=20", cut="femur"), "cut: there is no 'femur'; there are ball, socket"),
    (RuntimeError, lambda j: j.resect("flexion=20", least=True), "the socket is no closed mesh of one orientation"),
    (RuntimeError, lambda j: j.resect("flexion=20", clearance_mm=5), "less than the clearance; give a smaller one"),
    (RuntimeError, lambda j: j.resect("flexion=90,internal_rotation=30", neck_mm=60), "or allow a thinner neck"),
    (RuntimeError, lambda j: j.resect("flexion=150,internal_rotation=90"), "the axis of the neck at ("),
    (ValueError, lambda j: j.orient("flexion=20", tilt_deg=91), "tilt_deg: 91 is out of range; give a number from -90 to 90"),
    (ValueError, lambda j: j.orient("flexion=20", resolution_deg=0), "resolution_deg: 0 is out of range; give a number from 0.01 to 90"),
    (ValueError, lambda j: j.certify(TURNS), "pose: "),
    (ValueError, lambda j: j.certify(motion="bend"), "unknown motion 'bend'"),
    (RuntimeError, lambda j: j.certify([130, 0, 40], motion="flexion"), "no certificate: the motion ends within 0.01 degrees"),
    (ValueError, lambda j: impinge.Scheme("rside"), "unknown scheme 'rside'; there are "),
    (ValueError, lambda j: impinge.Scheme("rsid", 0.7), "an RSID precision divides 180 degrees"),
    (ValueError, lambda j: impinge.Scheme("rsid").stencils([0, 0, 0]), "directions: a vector is zero"),
    (ValueError, lambda j: impinge.Scheme("rsid").stencils([0, 1]), "directions: an array of shape (2,)"),
]


@pytest.mark.parametrize("case", range(len(REFUSED)))
def test_what_cannot_be_used_is_refused_in_one_line(hip, case):
    kind, ask, text = REFUSED[case]
    with pytest.raises(kind) as refused:
        ask(hip)
    assert text in str(refused.value) and "\n" not in str(refused.value)


def test_a_required_pose_is_words_angles_or_a_dict(hip):
    said = hip.resect(["flexion=90,internal_rotation=25", "flexion=100"], clearance_mm=0.4)["volume_mm3"]
    assert hip.resect([[90, 0, 25], {"flexion": 100}], clearance_mm=0.4)["volume_mm3"] == said


def members(tree):
    """Public names of a stub, with those of its classes."""
    names = set()
    for node in tree.body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            names.add(node.name)
        if isinstance(node, ast.ClassDef):
            names |= {f"{node.name}.{part.name}" for part in node.body if isinstance(part, ast.FunctionDef)}
    return {name for name in names if "__" not in name}


def test_stubs_and_page_have_what_module_and_program_have():
    tree = ast.parse((ROOT / "libcore/python/impinge/__init__.pyi").read_text(encoding="utf-8"))
    dicts = {"TypedDict"}
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and node.bases and getattr(node.bases[0], "id", "") in dicts:
            dicts.add(node.name)
    module = set(impinge.__all__)
    for name in impinge.__all__:
        thing = getattr(impinge, name)
        if isinstance(thing, type) and thing.__module__ == "impinge._impinge":
            module |= {f"{name}.{part}" for part in vars(thing) if not part.startswith("_")}
    assert members(tree) - dicts == module
    for script in ("python/stubs.py", "command/reference.py"):
        done = subprocess.run([sys.executable, ROOT / "libcore" / script, os.environ["IMPINGE"]], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr


def test_help_says_what_each_member_is():
    """And of arrays their shape."""
    arrays = {"Joint.centre", "Joint.gaps", "Joint.touch", "Joint.smallest_gap", "Joint.matrices", "Surface.vertices", "Surface.faces",
              "Surface.areas", "Surface.clock", "Scheme.directions", "Scheme.stencils"}
    for name in impinge.__all__:
        thing = getattr(impinge, name)
        own = vars(thing) if isinstance(thing, type) and thing.__module__ == "impinge._impinge" else {}
        assert len(thing.__doc__) > 8, name
        for part in (part for part in own if not part.startswith("_")):
            said = getattr(thing, part).__doc__ or ""
            said = said.partition("\n\n")[2] if said.startswith(f"{part}(") else said  # below the signature
            assert len(said) > 8, f"{name}.{part}"
            assert f"{name}.{part}" not in arrays or "(n" in said or "shape" in said.lower(), f"{name}.{part}"


def test_the_example_draws_its_picture(files, tmp_path):
    for words in ([], [*files, "right"]):
        picture = tmp_path / f"{len(words)}.png"
        done = subprocess.run([sys.executable, "-B", ROOT / "libcore/python/examples/hip.py", *words, picture],
                              capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        assert picture.read_bytes().startswith(b"\x89PNG") and "free to" in done.stdout and "centre" in done.stdout
        assert "% are reached without contact" in done.stdout


def test_version_is_that_of_the_project():
    project = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    assert impinge.__version__ == re.search(r"^  VERSION ([\d.]+)$", project, re.MULTILINE)[1]


def test_ask_takes_questions_alone(hip):
    for name in ("landmarks", "ball", "gap", "_touch", "read", "__init__"):
        with pytest.raises(ValueError, match=f"^there is no question '{name}'; there are touch, gaps, limits, [a-z, ]*certify, report$"):
            hip.ask(name)
    assert hip.ask("limits", motions="flexion") == hip.limits("flexion")


def test_signatures_have_the_keywords_of_the_stubs(hip):
    tree = ast.parse((ROOT / "libcore/python/impinge/__init__.pyi").read_text(encoding="utf-8"))
    held = {node.name: node.body for node in tree.body if isinstance(node, ast.ClassDef)} | {"": tree.body}
    for name in ("", "Joint", "Scheme"):
        owner = getattr(impinge, name) if name else impinge
        for part in (part for part in held[name] if isinstance(part, ast.FunctionDef) and part.name[0] != "_"):
            if isinstance(getattr(owner, part.name), property):
                continue
            found, arguments = inspect.signature(getattr(owner, part.name)), part.args
            assert list(found.parameters) == [one.arg for one in (*arguments.args, *arguments.kwonlyargs, arguments.kwarg) if one], part.name
            for word, default in zip(arguments.kwonlyargs, arguments.kw_defaults):
                assert found.parameters[word.arg].default == ast.literal_eval(default), (part.name, word.arg)
    assert list(inspect.signature(hip.gaps).parameters) == ["poses", "precision_deg", "out"]
    assert inspect.signature(hip.volume).parameters["gap_mm"].default == 0
    assert hip.limits.__doc__.startswith("How far each motion goes")
