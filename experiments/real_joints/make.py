#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the folders of the real joints from the originals that others published. README.md says where these come from.

Each joint of joints.json is cut about its centre: triangles of the ball and of the socket whose centroid lies within `factor`
head radii, and of the socket those in one piece that face the centre. No mesh is moved, but where joints.json says so.
Packages: python3-numpy, python3-vtk9; python3-scipy for vsd_z013_right.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import sys
import urllib.request
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

JOINTS = json.loads((Path(__file__).resolve().parent / "joints.json").read_text())
URL = "https://raw.githubusercontent.com/{repository}/{commit}/{path}"
Mesh = tuple[np.ndarray, np.ndarray]  # vertices, mm, and triangles


class Refused(Exception):
    """A refusal: which file, why, and what to do."""


def original(source: dict, folder: Path, download: bool) -> Path:
    """The path of a published file; it must have the bytes that joints.json vouches for."""
    path = folder / source["repository"] / source["path"]
    if not path.is_file():
        url = URL.format(**source)
        if not download:
            raise Refused(f"{path} is not there: download {url}, or give --download")
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            with urllib.request.urlopen(url) as answer:  # noqa: S310
                path.write_bytes(answer.read())
        except OSError as error:
            raise Refused(f"{url}: {error}") from None
    found = hashlib.sha256(path.read_bytes()).hexdigest()
    if found != source["sha256"]:
        raise Refused(f"{path} has the SHA-256 {found}, not {source['sha256']}: remove it and download {URL.format(**source)}")
    return path


def read(path: Path, bone: str | None) -> Mesh:
    """Reads STL or VTP, or the named bone of a MAT file."""
    if path.suffix == ".mat":
        from scipy.io import loadmat

        (mesh,) = [b.mesh for b in loadmat(path, squeeze_me=True, struct_as_record=False)["B"] if b.name == bone]
        return np.asarray(mesh.vertices, float), np.asarray(mesh.faces, int) - 1
    reader = vtk.vtkXMLPolyDataReader() if path.suffix == ".vtp" else vtk.vtkSTLReader()
    reader.SetFileName(str(path))
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(reader.GetOutputPort())
    triangles.Update()
    return arrays(triangles.GetOutput())


def arrays(data: vtk.vtkPolyData) -> Mesh:
    """The arrays of VTK's mesh."""
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float), vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def welded(mesh: Mesh) -> Mesh:
    """Joins vertices that are equal in single precision; removes faces that become empty and vertices without faces."""
    vertices, faces = mesh
    vertices, index = np.unique(vertices.astype(np.float32), axis=0, return_inverse=True)
    return compact((vertices, index.reshape(-1)[faces]))


def compact(mesh: Mesh, kept: np.ndarray | None = None) -> Mesh:
    """The kept faces that have an area, and the vertices that they use."""
    vertices, faces = mesh
    faces = faces if kept is None else faces[kept]
    faces = faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]
    used, index = np.unique(faces, return_inverse=True)
    return vertices[used], index.reshape(-1, 3)


def near(mesh: Mesh, centre: np.ndarray, radius: float) -> Mesh:
    """Faces whose centroid lies within the radius of the centre."""
    centroids = mesh[0][mesh[1]].mean(axis=1)
    return compact(mesh, np.linalg.norm(centroids - centre, axis=1) <= radius)


def facing(mesh: Mesh, centre: np.ndarray) -> Mesh:
    """The largest piece of the faces whose normals point to the centre."""
    a, b, c = (mesh[0][mesh[1]].astype(float) - centre).transpose(1, 0, 2)
    mesh = compact(mesh, np.einsum("ij,ij->i", np.cross(b - a, c - a), a) < 0)
    piece = pieces(mesh[1])
    return compact(mesh, piece == np.bincount(piece).argmax())


def pieces(faces: np.ndarray) -> np.ndarray:
    """For each face the number of its piece; faces with a common vertex are in one piece."""
    piece = np.arange(faces.max() + 1)
    while True:
        before = piece.copy()
        np.minimum.at(piece, faces, piece[faces].min(axis=1, keepdims=True).repeat(3, axis=1))
        piece = piece[piece]
        if (piece == before).all():
            return piece[faces[:, 0]]


def reduced(mesh: Mesh, most: int) -> Mesh:
    """The mesh with so many faces, by quadric error metrics."""
    data = vtk.vtkPolyData()
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(mesh[0], deep=True))
    cells = vtk.vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(mesh[1].reshape(-1).astype(np.int64), deep=True))
    data.SetPoints(points)
    data.SetPolys(cells)
    fewer = vtk.vtkQuadricDecimation()
    fewer.SetInputData(data)
    fewer.SetTargetReduction(1 - most / len(mesh[1]))
    fewer.Update()
    return welded(arrays(fewer.GetOutput()))


def write(path: Path, mesh: Mesh) -> None:
    """Writes binary PLY in millimetres."""
    vertices, faces = mesh
    head = (
        "ply\nformat binary_little_endian 1.0\ncomment units mm\n"
        f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    records = np.zeros(len(faces), np.dtype([("n", "u1"), ("v", "<i4", 3)]))
    records["n"], records["v"] = 3, faces
    path.write_bytes(head.encode() + vertices.astype("<f4").tobytes() + records.tobytes())


def meshes(joint: dict, originals: Path, download: bool) -> dict[str, Mesh]:
    """The meshes of a joint, by file name."""
    centre = np.array(joint["center_of_rotation_mm"])
    reach = joint["factor"] * joint["radius_mm"] if joint["factor"] else np.inf
    found = {}
    for role, source in joint["originals"].items():
        vertices, faces = read(original(source, originals, download), source.get("bone"))
        whole = welded((source.get("scale", 1) * vertices + source.get("shift_mm", [0, 0, 0]), faces))
        if "whole" in source:
            found[source["whole"]] = whole
        if role in ("ball", "socket"):
            cut = near(whole, centre, reach)
            most = source.get("most_triangles")
            found[source["region"]] = reduced(cut, most) if most and len(cut[1]) > most else cut
    socket = joint["originals"]["socket"]["region"]
    return {**found, f"{socket}_facing": facing(found[socket], centre)}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("joints", nargs="*", metavar="JOINT", help=f"of {', '.join(JOINTS)}; default: all")
    parser.add_argument("--originals", type=Path, required=True, help="folder of the originals, as OWNER/NAME/PATH")
    parser.add_argument("--download", action="store_true", help="fetch originals that are not there")
    parser.add_argument("--out", type=Path, required=True, help="where the folders of the joints are made, for --bones")
    options = parser.parse_args()
    try:
        for name in options.joints or JOINTS:
            if name not in JOINTS:
                raise Refused(f"there is no joint {name}: give one of {', '.join(JOINTS)}")
            joint, folder = JOINTS[name], options.out / name
            made = meshes(joint, options.originals, options.download)
            folder.mkdir(parents=True, exist_ok=True)
            for file, mesh in made.items():
                write(folder / f"{file}.ply", mesh)
            (folder / "subject.json").write_text(json.dumps({"subject": name, "units": "mm", **joint}, indent=1) + "\n")
            print(f"{folder}: " + ", ".join(f"{file} {len(mesh[1]):,}" for file, mesh in made.items()))
    except Refused as refusal:
        print(f"make.py: {refusal}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
