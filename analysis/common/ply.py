# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a triangle mesh from PLY with every property of its vertices (VTK's own reader drops those it does
not know).
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

import common

TYPES = {  # of PLY that NumPy knows by another name
    "char": "int8",
    "uchar": "uint8",
    "short": "int16",
    "ushort": "uint16",
    "int": "int32",
    "uint": "uint32",
    "float": "float32",
    "double": "float64",
}


@dataclass(frozen=True)
class Mesh:
    """Vertices (n, 3) in mm, triangles (m, 3), and the other properties of the vertices by name."""

    vertices: np.ndarray
    triangles: np.ndarray
    properties: dict[str, np.ndarray]


def read(path: Path) -> Mesh:
    """Reads ASCII or binary PLY, little or big endian; faces must be triangles."""
    data = path.read_bytes()
    header, _, body = data.partition(b"end_header\n")
    lines = [line.split() for line in header.decode("ascii").splitlines()]
    style = next(line[1] for line in lines if line[0] == "format")
    order = ">" if style == "binary_big_endian" else "<"
    fields, face, counts, element = [], None, {}, ""

    def of_type(name: str) -> np.dtype:
        return np.dtype(TYPES.get(name, name)).newbyteorder(order)

    for line in lines:
        if line[0] == "element":
            element = line[1]
            counts[element] = int(line[2])
        elif line[0] == "property" and element == "vertex":
            fields.append((line[2], of_type(line[1])))
        elif line[0] == "property" and element == "face":
            face = [("count", of_type(line[2])), ("index", of_type(line[3]), 3)]
    if style == "ascii":
        vertices, triangles = _ascii(body, [name for name, _ in fields], counts)
    else:
        layout = np.dtype(fields)
        vertices = np.frombuffer(body, layout, counts["vertex"])
        triangles = np.frombuffer(body, np.dtype(face), counts["face"], layout.itemsize * counts["vertex"])
        if (triangles["count"] != 3).any():
            raise common.Refused(f"{path} has a face that is no triangle")
        triangles = triangles["index"]
    properties = {name: np.asarray(vertices[name], dtype=float) for name, _ in fields}
    points = np.column_stack([properties.pop(axis) for axis in "xyz"])
    return Mesh(points, np.asarray(triangles, dtype=np.int64), properties)


def _ascii(body: bytes, names: list[str], counts: dict[str, int]) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """The vertices' properties and the triangles, from lines of numbers."""
    lines = body.decode("ascii").splitlines()
    rows = np.array([line.split() for line in lines[: counts["vertex"]]], dtype=float)
    faces = np.array(
        [line.split() for line in lines[counts["vertex"] : counts["vertex"] + counts["face"]]], dtype=int
    )
    return {name: rows[:, i] for i, name in enumerate(names)}, faces[:, 1:4]
