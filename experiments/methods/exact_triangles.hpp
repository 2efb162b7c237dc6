// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a mesh for CGAL: double coordinates, exact predicates.
#pragma once

#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "gap/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// What CGAL calls such numbers and their predicates.
using ExactPredicates = CGAL::Exact_predicates_inexact_constructions_kernel;

// Faces of the posed mesh in socket coordinates. Faces that are exactly degenerate have no interior to cross
// and are left out: CGAL's predicates do not take them.
std::vector<ExactPredicates::Triangle_3> exact_triangles(const TriangleMesh& mesh, const Pose& pose = {});

}  // namespace impinge::lab
