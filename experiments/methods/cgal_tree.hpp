// SPDX-License-Identifier: GPL-3.0-or-later
// Method cgal_tree: CGAL's tree of axis-aligned boxes over the socket, asked for each triangle of the ball.
// Exact predicates, so that it answers as pairwise does in a fraction of the time: the oracle of every timed
// method.
#pragma once

#include <memory>

#include "mesh/triangle_mesh.hpp"
#include "methods/touch_method.hpp"

namespace impinge::lab {

// Meshes in their centre frames, mm. The ball is copied.
std::unique_ptr<TouchMethod> make_cgal_tree(const TriangleMesh& ball, const TriangleMesh& socket);

}  // namespace impinge::lab
