// SPDX-License-Identifier: GPL-3.0-or-later
// The radii of a mesh along the directions of a Gauss grid.
#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "spectrum/gauss_grid.hpp"
#include "table/layer.hpp"

namespace impinge {

/// mesh in the centre frame; mm, kNoSurface where no face is met. Equal to RayCaster but for rounding, in a
/// time that grows with faces + directions and not with their product.
std::vector<double> grid_radii(const GaussGrid& grid, const TriangleMesh& mesh, Layer layer);

}  // namespace impinge
