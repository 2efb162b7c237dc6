// SPDX-License-Identifier: GPL-3.0-or-later
// Method pairwise: every triangle of the ball against every triangle of the socket, the O(n^2) baseline of
// the thesis (Tables 4 and 9), with CGAL's triangle test (Guigue and Devillers 2003) on exact predicates.
//
// What is counted: placing the ball and all pairs of a pose that is free. A pose that touches stops at the
// first pair that meets. Nothing is culled.
#pragma once

#include <memory>

#include "mesh/triangle_mesh.hpp"
#include "methods/touch_method.hpp"

namespace impinge::lab {

// Meshes in their centre frames, mm. The ball is copied.
std::unique_ptr<TouchMethod> make_pairwise(const TriangleMesh& ball, const TriangleMesh& socket);

}  // namespace impinge::lab
