// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's tree of axis-aligned boxes, with exact predicates and constructions in double: the reference that
// other methods are checked against.
#pragma once

#include "methods/points.hpp"

namespace impinge::lab {

/// The first triangle that a ray from the centre meets, or, for the farthest layer, a ray to the centre from
/// beyond the surface. mesh in the centre frame; its triangles are copied. Bytes are those of the heap, see
/// heap_use.hpp.
PointQuery make_cgal_first_hit(const TriangleMesh& mesh, Layer layer = Layer::nearest);
/// Distance to the nearest point of the surface, mm, without a sign.
PointQuery make_cgal_closest(const TriangleMesh& mesh);

/// Method cgal_tree, the reference of every timed method: each triangle of the ball is tested against the
/// socket's tree. Same answers as method pairwise. Meshes in their centre frames, mm; they are copied.
Touch make_cgal_tree(const TriangleMesh& ball, const TriangleMesh& socket);

}  // namespace impinge::lab
