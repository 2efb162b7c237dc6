// SPDX-License-Identifier: GPL-3.0-or-later
// From an image to a mesh, as a user of a segmentation program gets it: VTK's own filters, which
// isosurface.py calls. std::runtime_error where that fails.
#pragma once

#include <cstddef>

#include "imaging/ct_scan.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// The surface on which the image, linear between voxels, has the value `level` (vtkFlyingEdges3D); normals
// point to smaller values; frame of the image, mm. Closed if the image is below the level at its border.
// std::invalid_argument unless the image has one value for each voxel.
TriangleMesh isosurface(const VoxelImage& image, double level);

// Reduces a mesh to about `faces` faces by vtkQuadricDecimation, which may stop earlier. Returns the mesh
// itself if it has no more than that.
TriangleMesh decimate(const TriangleMesh& mesh, std::size_t faces);

}  // namespace impinge::lab
