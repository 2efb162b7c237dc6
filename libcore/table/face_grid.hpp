// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of directions over which faces are sorted.
#pragma once

#include "mesh/triangle_mesh.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"

namespace impinge {

/// The grid whose cells are as large as the mean face, as seen from the centre; its entries stand between
/// half a degree and `coarsest_deg` degrees apart. std::invalid_argument for vertices that require_lengths()
/// refuses.
CubeGnomonic face_grid(const TriangleMesh& mesh, double coarsest_deg);

}  // namespace impinge
