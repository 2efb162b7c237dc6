// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether two surfaces meet, by CGAL's exact predicates on all pairs of faces, without a centre,
// directions or radii; and says how that is related to the statements (1) and (2) of gap/overlay.hpp.
//
// Surfaces with a common point are impinged. For the converse let the ball X be closed, connected and
// star-shaped, and the socket Y a connected, star-shaped manifold with or without a rim (the edges with one
// face), each about its own centre. By Theorem 7 (slip)
//   (1)  holds exactly if X meets Y, or X meets the wall of the rim {s y : y in the rim, s >= 1}, or a point
//        of X, any one, is in the shadow {s y : y in Y, s >= 1};
//   (2)  holds exactly if Y meets X, or a point of Y, any one, is in the body {x / s : x in X, s >= 1}.
// So a contact without a common point is one where the surfaces have slipped past each other: the ball past
// the rim, wholly beyond the socket, or round the socket as a whole. Without a translation (1) and (2) are
// one statement, and only the last of these is left: turned from a pose that is clear, joints impinge first
// where the surfaces meet.
#pragma once

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Do the surfaces have a common point? Exact for the coordinates as they are. Faces without area meet
/// nothing.
bool surfaces_meet(const TriangleMesh& a, const TriangleMesh& b);

/// Does the segment from the centre to x meet the surface? Exact. Then x is in the shadow, if the surface is
/// star-shaped. x must not be the centre.
bool beyond_surface(const TriangleMesh& mesh, const Vec3& x);

/// Does the ray from x away from the centre meet the surface, whose coordinates are not above `reach`, mm?
/// Exact. x must not be the centre.
bool within_surface(const TriangleMesh& mesh, const Vec3& x, double reach);

/// The wall of the rim out to `reach` mm or more.
TriangleMesh rim_wall(const TriangleMesh& mesh, double reach);

}  // namespace impinge
