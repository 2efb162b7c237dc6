// SPDX-License-Identifier: GPL-3.0-or-later
// Method vdb_grid: distances from the surface on the voxels near it, by OpenVDB, which keeps no others;
// interpolated trilinearly.
//
// Bound: that of distance_grid.hpp, sqrt(3)/2 of a voxel.
// Reach: stored distances end at the width w of the band. Those of the eight nodes of a cell differ by at
// most its diagonal, so that an answer below w less the diagonal has read no node beyond the band.
#pragma once

#include <memory>

#include "methods/radius_method.hpp"

namespace impinge::lab {

// How fine the voxels are, and how far from the surface they are kept.
struct VdbShape {
  double voxel_mm = 0.5;  // edge of a voxel
  double reach_mm = 5.0;  // distances up to here are answered
};

// mesh in the centre frame, open or closed; distances (mm) have no sign. NaN where the answer is above the
// reach. std::invalid_argument where voxel or reach is not above 0. Bytes are those of the grid.
std::unique_ptr<RadiusMethod> make_vdb_distances(const TriangleMesh& mesh, const VdbShape& shape);

double vdb_distance_bound(const VdbShape& shape);  // proven, mm: see above

}  // namespace impinge::lab
