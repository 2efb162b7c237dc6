// SPDX-License-Identifier: GPL-3.0-or-later
// Tables at the precisions that joints are worked with. Only the entries that some look-ups read are worked
// out, so that 0.1 degrees cost little more than 1. Each look-up has the bound of first order of
// its own place (table/error_bound.hpp).
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

// What the look-ups of one table came to.
struct WorkingTable {
  std::string name;  // SCHEME, of radii, or SCHEME_mesh_exact, of inverse depths
  double precision_deg = 0.0;
  double reach = 0.0;           // largest angle from a direction to an entry that its look-up reads, radians
  std::vector<double> answers;  // mm, NaN where the table says nothing
  std::vector<double> bounds;   // mm, on each answer; infinite where nothing is proven
};

// The thesis' two schemes, and two that are recommended (sphere/schemes/README.md), at both precisions: a
// walk along a rim in steps of a tenth of a degree costs others too much. mesh in the centre frame, nearest
// layer.
std::vector<WorkingTable> working_tables(const TriangleMesh& mesh, std::span<const Vec3> directions);

// Every scheme on an octahedron of that radius, whose entries are known in closed form, to be asked anywhere.
std::vector<StabilityMethod> working_octahedra(double radius);

}  // namespace impinge::lab
