// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's tree of axis-aligned boxes with exact predicates and constructions in double: the oracles of other
// methods.
#pragma once

#include "methods/points.hpp"

namespace impinge::lab {

/// The first triangle that a ray from the centre meets. mesh in the centre frame; its triangles are copied.
/// Bytes are those of the heap, see heap_use.hpp.
PointQuery make_cgal_first_hit(const TriangleMesh& mesh);
/// Distance from the nearest point of the surface.
PointQuery make_cgal_closest(const TriangleMesh& mesh);

/// cgal_tree, the oracle of every timed method: the socket's tree asked for each triangle of the ball. It
/// answers as pairwise does in a fraction of the time. Meshes in their centre frames, mm; they are copied.
Touch make_cgal_tree(const TriangleMesh& ball, const TriangleMesh& socket);

}  // namespace impinge::lab
