# SPDX-License-Identifier: GPL-3.0-or-later
"""A program of somebody else finds the installed library and agrees with `scene`. BUILD is a whole build, MAKE_PAIR and SCENE are programs of it.
"""

from __future__ import annotations

import csv
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CONSUMER = ROOT / "tests/data/consumer"


def run(*command: str | Path, expected: int = 0) -> str:
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    assert done.returncode == expected, done.stdout + done.stderr
    return done.stdout + done.stderr


class Install(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="impinge-install-")
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        self.prefix = self.folder / "prefix"
        run("cmake", "--install", os.environ["BUILD"], "--prefix", self.prefix)

    def configure(self, source: Path, build: Path, expected: int = 0) -> str:
        command = ["cmake", "-S", source, "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}"]
        return run(*command, "-DCMAKE_BUILD_TYPE=Release", expected=expected)

    def test_a_program_finds_the_library_and_agrees_with_scene(self):
        build = self.folder / "build"
        self.configure(CONSUMER, build)
        run("cmake", "--build", build)
        pair = self.folder / "pair"
        run(os.environ["MAKE_PAIR"], "--faces", "3000", "--out", pair)
        ball, socket = pair / "ball.ply", pair / "socket.ply"
        gap = float(run(build / "consumer", ball, socket))
        out = self.folder / "out"
        asked = ["--centre", "0,0,0", "--surfaces", "ball", "--outputs", "gaps", "--precision", "0.1"]
        run(os.environ["SCENE"], "--ball", ball, "--socket", socket, *asked, "--out", out)
        with (out / "gaps.csv").open() as lines:
            gaps = [float(row["gap_mm"]) for row in csv.DictReader(lines) if row["gap_mm"]]
        self.assertAlmostEqual(gap, min(gaps), delta=0.05)

    def test_the_target_library_makes_all_that_is_installed(self):
        commands = run("ninja", "-C", os.environ["BUILD"], "-t", "commands", "library")
        made = {Path(word).name for word in commands.split() if word.endswith(".a")}
        installed = {file.name for file in self.prefix.rglob("*.a")}
        self.assertLessEqual({"libimpinge_sphere.a", "libimpinge_kernels.a"}, installed)
        self.assertLessEqual(installed, made)
        self.assertNotIn("libimpinge_harness.a", made)

    def test_a_clone_without_the_scripts_of_npm_builds_the_library(self):
        """Only what needs them asks for them, by the command that brings them."""
        clone, build = self.folder / "clone", self.folder / "cloned"
        left_out = shutil.ignore_patterns(".git", "build", "results", "node_modules")
        shutil.copytree(ROOT, clone, ignore=left_out)
        self.configure(clone, build)
        run("ninja", "-C", build, "-n", "library")
        for script in ("three/package.json", "plotly.js-basic-dist-min/plotly-basic.min.js"):
            said = run("ninja", "-C", build, clone / "analysis/node_modules" / script, expected=1)
            self.assertIn("npm ci --prefix analysis", said)

    def test_an_unknown_component_is_refused_by_name(self):
        source = self.folder / "source"
        source.mkdir()
        (source / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(p LANGUAGES CXX)\n"
            "find_package(impinge REQUIRED COMPONENTS teeth)\n"
        )
        message = self.configure(source, self.folder / "refused", expected=1)
        self.assertIn("no component 'teeth'", " ".join(message.split()))

    def test_no_file_names_the_machine_that_built_it(self):
        for file in self.prefix.rglob("*"):
            if file.suffix in (".cmake", ".hpp"):
                self.assertNotIn(os.environ["BUILD"], file.read_text(), file)


if __name__ == "__main__":
    unittest.main()
