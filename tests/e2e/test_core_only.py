# SPDX-License-Identifier: GPL-3.0-or-later
"""The core of impinge builds with a compiler, CMake and Eigen alone: a small program that uses it is configured with
every other package hidden, built and run. SOURCE is the source folder, IMPINGE the whole program, to compare sizes.
"""

from __future__ import annotations

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ["SOURCE"])
HIDDEN = [
    "assimp",
    "benchmark",
    "CGAL",
    "CLI11",
    "embree",
    "fcl",
    "GSL",
    "GTest",
    "nlohmann_json",
    "OpenSSL",
    "pugixml",
    "Python3",
]
OTHERS = ["assimp", "CGAL", "gmp", "mpfr", "gsl", "fcl", "embree", "benchmark", "crypto", "pugixml"]  # libraries


def run(*command: str | Path) -> str:
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def stripped_bytes(program: Path, folder: Path) -> int:
    copy = folder / "stripped"
    run("strip", "-o", copy, program)
    return copy.stat().st_size


class CoreOnly(unittest.TestCase):
    def test_builds_and_answers_with_eigen_alone(self):
        with tempfile.TemporaryDirectory(prefix="impinge-core-only-") as name:
            folder = Path(name)
            options = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=TRUE" for package in HIDDEN]
            os.environ["CCACHE_BASEDIR"] = name  # a cache finds what was compiled, whatever the folder is called
            build = folder / "build"
            run(
                "cmake",
                "-S",
                SOURCE / "tests/data/core_only",
                "-B",
                build,
                "-G",
                "Ninja",
                f"-DIMPINGE={SOURCE}",
                "-DCMAKE_CXX_FLAGS=-O0 -g0",
                "-DCMAKE_UNITY_BUILD=ON",  # in half the time
                *options,
            )
            run("cmake", "--build", build, "--target", "core_only")
            program = build / "core_only"
            gap, first, second, radius = run(program).split()
            self.assertLess(abs(float(gap) - 0.5), 1.5)
            self.assertEqual((first, second), ("0", "1"))
            self.assertAlmostEqual(float(radius), 26.0, delta=0.05)
            needed = run("ldd", program)
            for library in OTHERS:
                self.assertNotIn(f"lib{library}", needed.lower())
            print(
                f"stripped: core only {stripped_bytes(program, folder)} bytes (not optimised), "
                f"impinge {stripped_bytes(Path(os.environ['IMPINGE']), folder)} bytes"
            )


if __name__ == "__main__":
    unittest.main()
