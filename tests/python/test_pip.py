# SPDX-License-Identifier: GPL-3.0-or-later
"""`pip install --no-build-isolation ./libcore/python` in an environment that sees Debian's packages, from a clone, without
the network; and a wheel that carries its libraries."""
import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(os.environ["SOURCE"])


def run(*command, **keywords):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **keywords)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_pip_builds_and_installs_the_module(tmp_path):
    clone = tmp_path / "clone"
    shutil.copytree(ROOT, clone, ignore=shutil.ignore_patterns(".git", "build", "results", "node_modules"))
    run("git", "init", "--quiet", cwd=clone)
    run("git", "add", "--all", cwd=clone)
    staged = run("git", "status", "--porcelain", cwd=clone)
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    environment["CCACHE_BASEDIR"] = str(clone)
    run(sys.executable, "-m", "venv", "--system-site-packages", tmp_path / "venv")
    python = tmp_path / "venv/bin/python"
    run(python, "-m", "pip", "install", "--no-index", "--no-build-isolation", clone / "libcore/python", env=environment)
    assert run("git", "status", "--porcelain", cwd=clone) == staged  # nothing new, nothing changed
    carrying = run(sys.executable, clone / "libcore/python/make_wheel.py", tmp_path / "wheels", env=environment).strip()
    assert run("git", "status", "--porcelain", cwd=clone) == staged
    shutil.rmtree(clone)  # what was installed stands alone
    script = "import impinge; print(impinge.__file__, len(impinge.schemes()), impinge.Joint.from_hip(faces=500).touch([0, 0, 0]))"
    where, schemes, *touch = run(python, "-c", script, env=environment, cwd=tmp_path).split()
    assert str(tmp_path / "venv") in where and int(schemes) >= 13 and touch == ["[False]"]
    assert (Path(where).parent / "__init__.pyi").is_file() and (Path(where).parent / "py.typed").is_file()
    run(sys.executable, "-m", "venv", "--system-site-packages", tmp_path / "other")  # which has NumPy
    run(tmp_path / "other/bin/pip", "install", "--no-index", "--no-deps", carrying, env=environment)
    script = "import impinge; print(open('/proc/self/maps').read())"
    loaded = {Path(line.split()[-1]) for line in run(tmp_path / "other/bin/python", "-c", script, env=environment, cwd=tmp_path).splitlines() if ".so" in line}
    own = {path.name.split("-")[0] for path in loaded if tmp_path in path.parents}
    assert own > {"libassimp", "libpugixml", "libhwy", "libz"}
    assert not [path for path in loaded if path.name.startswith(("libassimp", "libpugixml", "libhwy", "libminizip", "libdraco")) and tmp_path not in path.parents]
