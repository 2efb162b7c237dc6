# SPDX-License-Identifier: GPL-3.0-or-later
"""A scheme that lacks a member does not compile, and the compiler's message names the member.

Each variant is tests/data/example_scheme.hpp with one of the members that the concept asks for renamed.
CXX is the compiler, INCLUDES the folders to search, with colons between.
"""

from __future__ import annotations

import os
import re
import subprocess
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = (ROOT / "tests" / "data" / "example_scheme.hpp").read_text()
FOLDERS = [f"-I{folder}" for folder in os.environ["INCLUDES"].split(":")]


def required_members() -> list[str]:
    """Every S::member and scheme.member of the concept SamplingScheme."""
    text = (ROOT / "libcore" / "sphere" / "scheme.hpp").read_text()
    concept = re.search(r"concept SamplingScheme = .*?\n};", text, re.DOTALL)
    return list(dict.fromkeys(re.findall(r"\b(?:S::|scheme\.)(\w+)", concept[0])))


def without(member: str) -> str:
    """The example with the member renamed, but not the members of other classes that it uses."""
    return "".join(
        line if line.startswith("#") else re.sub(rf"(?<![\w.:]){member}\b", f"{member}_is_not_here", line)
        for line in EXAMPLE.splitlines(keepends=True)
    )


def compiler(*words) -> subprocess.CompletedProcess:
    command = [os.environ["CXX"], "-std=c++20", *FOLDERS, *map(str, words)]
    return subprocess.run(command, capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"})


def compiled(source: str, *words) -> subprocess.CompletedProcess:
    """The compiler's answer to a header, which is checked and not translated."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "scheme.hpp").write_text(source)
        main = Path(folder) / "main.cpp"
        main.write_text('#include "scheme.hpp"\n')
        return compiler("-fsyntax-only", *words, main)


class Concept(unittest.TestCase):
    """SamplingScheme, as the author of a scheme meets it."""

    @classmethod
    def setUpClass(cls):
        """What every scheme includes is read once for all that are refused."""
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.concept = Path(folder.name) / "concept.hpp"
        cls.concept.write_text('#include "sphere/scheme.hpp"\n')
        compiler("-x", "c++-header", cls.concept, "-o", f"{cls.concept}.gch").check_returncode()

    def refused(self, source: str, *named: str) -> None:
        """Fails at the concept, where it names what is wrong, and nowhere else."""
        done = compiled(source, "-include", self.concept)
        self.assertNotEqual(done.returncode, 0)
        errors = [line for line in done.stderr.splitlines() if "error:" in line]
        self.assertEqual(len(errors), 1, done.stderr)
        self.assertRegex(errors[0], "static assertion failed|static_assert failed")
        reasons = done.stderr.partition(errors[0])[2]
        for name in named:
            self.assertRegex(reasons, rf"(?<!\w){re.escape(name)}(?!\w)")

    def replaced(self, old: str, new: str) -> str:
        """The example with one line changed, which must be there."""
        self.assertIn(old, EXAMPLE)
        return EXAMPLE.replace(old, new)

    def test_complete(self):
        done = compiled(EXAMPLE)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_each_member_is_asked_for(self):
        members = required_members()
        self.assertGreaterEqual(len(members), 12)
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for member, _ in zip(members, pool.map(lambda m: self.refused(without(m), m), members)):
                print(f"{member}: asked for", flush=True)

    def test_member_of_another_type(self):
        old = "double stencil_radius() const"
        self.refused(self.replaced(old, "float stencil_radius() const"), "stencil_radius")

    def test_walker_that_visits_nothing(self):
        old = "  double stencil_radius() const"
        new = f"  Vec3 walker() const {{ return Vec3::Zero(); }}\n{old}"
        self.refused(self.replaced(old, new), "HasWalker")

    def test_not_comparable(self):
        old = "friend bool operator==(const ExampleScheme&, const ExampleScheme&) = default;"
        self.refused(self.replaced(old, ""), "==")


if __name__ == "__main__":
    unittest.main(verbosity=2)
