# SPDX-License-Identifier: GPL-3.0-or-later
"""A program of somebody else finds the installed library and agrees with `impinge`. BUILD is a whole build, IMPINGE its program, HIP the folder of a
right hip.
"""

from __future__ import annotations

import json
import os
import re
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

    def test_a_program_finds_the_library_and_agrees_with_impinge(self):
        build = self.folder / "build"
        self.configure(CONSUMER, build)
        run("cmake", "--build", build)
        hip = Path(os.environ["HIP"])
        meshes = [hip / "ball.ply", hip / "socket.ply"]
        said = run(build / "consumer", *meshes).splitlines()
        motion, low, high = said[1].split()
        limits = run(os.environ["IMPINGE"], "limits", *meshes, "--side", "right", "--motions", motion, "--pose", "flexion=90", "--cartilage", "0", "--json")
        found = json.loads(limits)["answer"]["limits"][0]
        self.assertEqual((low, high), (f"{found['low_deg']:.3f}", f"{found['high_deg']:.3f}"))

        # Gaps are those of the faces, so that the first pose in which a vertex of the ball impinges is not before that limit.
        touching = int(re.search(r"in (\d+) of 500 poses", said[0]).group(1))
        self.assertLessEqual(touching, sum(0.1 * k >= found["low_deg"] for k in range(500)))
        self.assertGreater(touching, 100)

    def test_the_target_library_makes_all_that_is_installed(self):
        commands = run("ninja", "-C", os.environ["BUILD"], "-t", "commands", "library")
        made = {Path(word).name for word in commands.split() if word.endswith(".a")}
        installed = {file.name for file in self.prefix.rglob("*.a")}
        self.assertLessEqual({"libimpinge_sphere.a", "libimpinge_gap_simd.a"}, installed)
        self.assertLessEqual(installed, made)
        self.assertNotIn("libimpinge_harness.a", made)

    def test_a_clone_without_the_scripts_of_npm_builds_the_library(self):
        """Only what needs them asks for them, by the command that brings them."""
        clone, build = self.folder / "clone", self.folder / "cloned"
        left_out = shutil.ignore_patterns(".git", "build", "results", "node_modules")
        shutil.copytree(ROOT, clone, ignore=left_out)
        self.configure(clone, build)
        run("ninja", "-C", build, "-n", "library")
        said = run("ninja", "-C", build, clone / "analysis/node_modules/three/package.json", expected=1)
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
