# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the module share: programs, their files, and meshes. PYTHONPATH holds
the module; IMPINGE names the program, HIP the folder of a right hip, SOURCE the clone."""
import csv
import json
import os
import subprocess
from pathlib import Path

import numpy as np

ROOT = Path(os.environ["SOURCE"])
TURNS = np.array([[0, 0, 0], [90, 0, 20], [60, -20, 30], [110, 15, -10], [-20, 20, -30]], dtype=float)


def program(name, *words):
    return subprocess.run([os.environ[name], *map(str, words)], capture_output=True, text=True, check=False)


def asked(files, out, question, *words):
    """The answer of the program, about a right hip."""
    done = program("IMPINGE", question, *files, "--side", "right", "--out", out, *words)
    assert done.returncode == 0, done.stderr
    return written(out, "summary.json")["answer"]


def written(folder, name):
    return json.loads((folder / name).read_text(encoding="utf-8"))


def table(folder, name):
    with open(folder / name, encoding="utf-8") as file:
        return list(csv.DictReader(file))


STANDING = {"asis_right": (120, 60, 120), "asis_left": (-120, 60, 120), "pubic_tubercle_right": (25, 60, 10),
            "pubic_tubercle_left": (-25, 60, 10)}


def standing(centre, tilt_deg):
    """Landmarks of a pelvis about a joint's centre; its plane leans forward by the tilt, so that the ASIS lead."""
    tilt = np.radians(tilt_deg)
    lean = np.array([[1, 0, 0], [0, np.cos(tilt), np.sin(tilt)], [0, -np.sin(tilt), np.cos(tilt)]])
    return {name: tuple(map(float, lean @ x + centre)) for name, x in STANDING.items()}


def marked(path, places):
    path.write_text("label,x,y,z\n" + "".join(f"{name},{','.join(map(str, map(float, x)))}\n" for name, x in places.items()), encoding="utf-8")
    return path


def sphere(radius, open_above=None):
    """An icosphere; with open_above without the faces that reach higher."""
    g = (1 + 5**0.5) / 2
    points = [(a, b * g, 0) for a in (-1, 1) for b in (-1, 1)]
    points = np.array(points + [(z, x, y) for x, y, z in points] + [(y, z, x) for x, y, z in points], dtype=float)
    corners = [(i, j, k) for i in range(12) for j in range(i) for k in range(j)
               if all(abs(np.linalg.norm(points[a] - points[b]) - 2) < 1e-9 for a, b in ((i, j), (j, k), (i, k)))]
    triangles = points[np.array(corners)]
    for _ in range(3):
        middle = (triangles + np.roll(triangles, -1, axis=1)) / 2
        a, b, c = (np.stack([triangles[:, k], middle[:, k], middle[:, k - 1]], axis=1) for k in range(3))
        triangles = np.concatenate([a, b, c, middle])
    triangles *= radius / np.linalg.norm(triangles, axis=2, keepdims=True)
    inwards = np.einsum("ij,ij->i", np.cross(triangles[:, 0], triangles[:, 1]), triangles[:, 2]) < 0
    triangles[inwards] = triangles[inwards][:, ::-1]
    if open_above is not None:
        triangles = triangles[(triangles[:, :, 2] < open_above).all(axis=1)]
    return triangles.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)
