#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every file of libcore is reached: by a program of a user (impinge, Joint3D, the module of Python), or as an oracle
by the tests of another folder. What only an experiment asks for belongs to experiments/. That a page names a file does not
make it used."""
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIBRARY = ROOT / "libcore"
ORACLES = ("reference/", "table/pairwise.hpp")
PROGRAMS = ("experiments/impinge.cpp", "libcore/command/*.cpp", "analysis/joint3d/engine/*.?pp", "libcore/python/*.?pp")


def included(path):
    """The headers that a file includes, in their order."""
    return re.findall(r'^#\s*include "([^"]+)"', path.read_text(encoding="utf-8"), re.MULTILINE)


def reached(roots, files):
    """The files of the library among roots, those that they include, and so on; with a header, the sources that include it
    first, whose header it is."""
    sources = {}
    for name, path in files.items():
        if path.suffix == ".cpp":
            for header in included(path)[:1]:
                sources.setdefault(header, []).append(name)
    names = {str(path.relative_to(LIBRARY)) for path in roots if LIBRARY in path.parents}
    left = {header for path in roots for header in included(path)} | names
    seen = set()
    while left:
        name = left.pop()
        if name == "sphere/scheme_list.hpp":
            left |= {scheme for scheme in files if scheme.startswith("sphere/schemes/")} - seen
        if name in files and name not in seen:
            seen.add(name)
            left |= {*included(files[name]), *sources.get(name, [])} - seen
    return seen


def oracles(files):
    """The headers of ORACLES that a test of another folder of the library includes."""
    folders = {name.split("/")[0] for name in files}
    tests = [path for path in (ROOT / "tests").glob("*/*.?pp") if path.parent.name in folders]
    asked = {(header, path.parent.name) for path in tests for header in included(path) if header.startswith(ORACLES)}
    return {header for header, folder in asked if not header.startswith(f"{folder}/")}


class Library(unittest.TestCase):
    def setUp(self):
        paths = [path for path in LIBRARY.rglob("*.?pp") if path.suffix in (".cpp", ".hpp")]
        self.files = {str(path.relative_to(LIBRARY)): path for path in paths}
        programs = [path for pattern in PROGRAMS for path in ROOT.glob(pattern)]
        self.roots = programs + [self.files[name] for name in oracles(self.files)]

    def test_no_file_serves_an_experiment_alone(self):
        self.assertEqual(sorted(set(self.files) - reached(self.roots, self.files)), [])

    def test_a_file_that_nobody_includes_is_seen(self):
        self.files["gap/stray.hpp"] = LIBRARY / "gap/stray.hpp"
        self.assertNotIn("gap/stray.hpp", reached(self.roots, self.files))

    def test_the_library_includes_nothing_of_the_laboratory(self):
        rooms = {path.name for path in (ROOT / "experiments").iterdir() if path.is_dir()}
        strays = [name for name, path in self.files.items() if rooms & {one.split("/")[0] for one in included(path)}]
        self.assertEqual(strays, [])


if __name__ == "__main__":
    unittest.main()
