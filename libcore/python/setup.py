# SPDX-License-Identifier: GPL-3.0-or-later
"""pip install --no-build-isolation ./libcore/python: CMake builds the module of this very clone and installs it into the
wheel. What it needs of Debian 12: experiments/packages, marked (python)."""
import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build" / "pip"  # beside the other builds: a compiler cache then finds their objects
WHEEL = BUILD / "wheel"  # so that the sources stay as they are


class CMakeBuild(build_ext):
    def build_extension(self, ext: Extension) -> None:
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        options = ["-DIMPINGE_PYTHON_ONLY=ON", "-DCMAKE_BUILD_TYPE=Release", f"-DPython3_EXECUTABLE={sys.executable}"]
        unity = ["-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=8"]
        subprocess.check_call(["cmake", "-G", "Ninja", "-S", ROOT, "-B", BUILD, *options, *unity])
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count())
        subprocess.check_call(["cmake", "--build", BUILD, "--target", "impinge_python", "--parallel", jobs])
        subprocess.check_call(["cmake", "--install", BUILD, "--component", "python", "--prefix", package.parent])


def numpy_that_works() -> str:
    """The NumPy that this pybind11 works with: NumPy 2 needs pybind11 2.12, and Debian 12 has 2.10."""
    header = Path("/usr/include/pybind11/detail/common.h")
    said = re.search(r"PYBIND11_VERSION_MINOR (\d+)", header.read_text(encoding="utf-8")) if header.exists() else None
    return "numpy<2" if said and int(said[1]) < 12 else "numpy"


WHEEL.mkdir(parents=True, exist_ok=True)
setup(
    install_requires=[numpy_that_works()],
    version=re.search(r"VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1),
    ext_modules=[Extension("impinge._impinge", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    options={"egg_info": {"egg_base": str(WHEEL)}, "build": {"build_base": str(WHEEL)}},
)
