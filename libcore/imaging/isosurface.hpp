// SPDX-License-Identifier: GPL-3.0-or-later
// From an image to a mesh, by VTK's own filters, as a user of a segmentation program gets it.
#pragma once

#include <cstddef>
#include <string>

#include "imaging/voxel_image.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// The surface on which the image, linear between voxels, has this value (vtkFlyingEdges3D), normals towards
/// smaller values. Closed where the image is below the level at its border. std::invalid_argument for an
/// image whose values are not as many as its voxels.
TriangleMesh isosurface(const VoxelImage& image, double level);

/// Down to so many faces, where vtkQuadricDecimation gets there: it stops before it where no further step is
/// left to it. The mesh itself where it has no more.
TriangleMesh decimate(const TriangleMesh& mesh, std::size_t faces);

/// The library and its version, for the record of a result.
std::string isosurface_library();

}  // namespace impinge
