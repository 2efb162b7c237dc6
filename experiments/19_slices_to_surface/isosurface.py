# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes as a user of a segmentation program gets them, by VTK's own filters; isosurface.cpp calls this.

isosurface.py surface IMAGE.mha LEVEL MESH.ply: where the image, linear between voxels, has the value LEVEL.
isosurface.py fewer MESH.ply FACES FEWER.ply: the mesh with about so many faces.
"""

import sys

from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkQuadricDecimation
from vtkmodules.vtkIOImage import vtkMetaImageReader
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter


def surface(level: float) -> vtkFlyingEdges3D:
    """Normals of its faces point to smaller values."""
    drawn = vtkFlyingEdges3D()
    drawn.SetValue(0, level)
    drawn.ComputeNormalsOff()
    drawn.ComputeScalarsOff()
    return drawn


def fewer(faces: float, of: int) -> vtkQuadricDecimation:
    """It may stop earlier."""
    reduced = vtkQuadricDecimation()
    reduced.SetTargetReduction(1.0 - faces / of)
    return reduced


def main(task: str, source: str, number: str, target: str) -> None:
    """Reads, filters, writes."""
    reader = vtkMetaImageReader() if task == "surface" else vtkPLYReader()
    reader.SetFileName(source)
    reader.Update()
    work = surface(float(number)) if task == "surface" else fewer(float(number), reader.GetOutput().GetNumberOfPolys())
    work.SetInputConnection(reader.GetOutputPort())
    writer = vtkPLYWriter()
    writer.SetFileName(target)
    writer.SetInputConnection(work.GetOutputPort())
    writer.Write()


main(*sys.argv[1:])
