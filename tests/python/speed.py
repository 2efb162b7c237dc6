#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""speed.py BUILD: what 10^4 poses cost from Python beside C++, in CPU time; build the targets impinge_python and
python_speed before. Rounds of both take turns, and the fastest of each counts."""
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

BUILD = Path(sys.argv[1])
sys.path.insert(0, str(BUILD / "python"))
import impinge  # noqa: E402


def milliseconds(work):
    before = time.process_time()
    work()
    return 1e3 * (time.process_time() - before)


def main():
    joint = impinge.Joint.from_hip("cam")
    poses = np.zeros((10_000, 3))
    poses[:, 0] = 0.012 * np.arange(10_000)
    out = tuple(np.zeros((len(poses), len(s.vertices)), np.float32) for s in (joint.ball, joint.socket))
    theirs, ours, fresh = [], [], []
    for _ in range(3):
        said = subprocess.run([BUILD / "tests/python/python_speed"], capture_output=True, text=True, check=True).stdout
        theirs += map(float, said.split())
        ours += [milliseconds(lambda: joint.gaps(poses, out=out)) for _ in range(5)]
        fresh += [milliseconds(lambda: joint.gaps(poses)) for _ in range(2)]
    print(f"C++ {min(theirs):.0f} ms, Python {min(ours):.0f} ms ({100 * (min(ours) / min(theirs) - 1):+.1f} %), "
          f"with new arrays {min(fresh):.0f} ms")


if __name__ == "__main__":
    main()
