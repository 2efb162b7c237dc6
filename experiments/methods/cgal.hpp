// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's tree of boxes along the axes, with exact predicates and constructions in double: the reference for
// other methods.
#pragma once

#include "methods/points.hpp"

namespace impinge::lab {

/// The first triangle that a ray from the centre meets; for the farthest layer, a ray from beyond the surface
/// to the centre. The mesh is in the centre frame; its triangles are copied. Bytes: heap_use.hpp.
PointQuery make_cgal_first_hit(const TriangleMesh& mesh, Layer layer = Layer::nearest);
/// Distance to the nearest point of the surface, mm, without a sign.
PointQuery make_cgal_closest(const TriangleMesh& mesh);

/// Method cgal_tree, the reference of every timed method: tests each triangle of the ball against the
/// socket's tree. It gives the same answers as method pairwise. Meshes in centre frames, mm, are copied.
Touch make_cgal_tree(const TriangleMesh& ball, const TriangleMesh& socket);

}  // namespace impinge::lab
