// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a mesh from an image as a user of a segmentation program would: with VTK's own filters, called by
// isosurface.py. Throws std::runtime_error if that fails.
#pragma once

#include <cstddef>

#include "imaging/ct_scan.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// The surface on which the image, linear between voxels, has the value `level` (vtkFlyingEdges3D), in the
// frame of the image, mm; normals point to smaller values. It is closed if the image is below the level at
// its border. Throws std::invalid_argument unless the image has one value for each voxel.
TriangleMesh isosurface(const VoxelImage& image, double level);

// Reduces a mesh to about `faces` faces by vtkQuadricDecimation, which may stop earlier. Returns a mesh that
// has no more faces unchanged.
TriangleMesh decimate(const TriangleMesh& mesh, std::size_t faces);

}  // namespace impinge::lab
