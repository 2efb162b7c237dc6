// SPDX-License-Identifier: GPL-3.0-or-later
// Tables at the precisions that are used for joints. Only entries that some look-ups read are worked out, so
// 0.1 degrees cost little more than 1. Each look-up has the first-order bound of its own place
// (table/error_bound.hpp).
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "methods/points.hpp"
#include "stress/methods.hpp"

namespace impinge::lab {

inline constexpr std::array kWorkingPrecisions{1.0, 0.1};  // degrees

// The results of one table's look-ups.
struct WorkingTable {
  std::string name;  // SCHEME for radii, SCHEME_mesh_exact for inverse depths
  double precision_deg = 0.0;
  double reach = 0.0;           // largest angle from a direction to an entry that its look-up reads, radians
  std::vector<double> answers;  // mm, NaN where the table has no answer
  std::vector<double> bounds;   // mm, for each answer; infinite where nothing is proven
};

// The thesis' two schemes and two recommended ones (sphere/schemes/README.md) at both precisions; others take
// too long for a walk along a rim in steps of a tenth of a degree. `mesh` is in the centre frame, nearest
// layer.
std::vector<WorkingTable> working_tables(const TriangleMesh& mesh, std::span<const Vec3> directions);

// Every scheme on an octahedron of this radius, whose entries are known in closed form in any direction.
std::vector<StabilityMethod> working_octahedra(double radius);

}  // namespace impinge::lab
