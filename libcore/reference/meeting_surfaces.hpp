// SPDX-License-Identifier: GPL-3.0-or-later
// Do two surfaces meet? By CGAL's exact predicates on all pairs of faces, without a centre, directions or
// radii. And what that has to do with radial contact, the statements (1) and (2) of gap/overlay.hpp.
//
// Surfaces are as in gap/overlay.hpp, without faces that are edge-on. Those with a common point x are
// impinged: x is on or beyond the socket and on or within the ball. The converse needs more. Let the ball X
// be closed, star-shaped about its centre and in one piece, and the socket Y star-shaped about its own
// centre, in one piece, a manifold with or without a rim (the edges with one face). Let the shadow Y+ of the
// socket be {s y : y in Y, s >= 1}, and X- the body {x / s} of the ball with its centre. Then
//   (1)  exactly if X meets Y, or X meets the wall of the rim {s y : y in the rim, s >= 1}, or a point of X,
//        any one, is in Y+;
//   (2)  exactly if Y meets X, or a point of Y, any one, is in X-.
// Proof. Along the directions of Y its radius is continuous, since it is compact and met once by each ray. So
// a point of Y+ with s > 1 is an inner point of it unless its direction is on the border of these directions,
// which is in the rim: round any other point Y covers a whole neighbourhood. The border of Y+ is therefore in
// Y and the wall, and a connected X that meets neither is wholly in Y+ or wholly outside. (2) in the same
// way: X has no rim, so that the border of X- is X. The other direction is plain, as rim and wall belong to
// Y+.
//
// So a contact without a common point is exactly one where the surfaces have slipped past each other: the
// ball past the rim (it meets the wall), wholly beyond the socket, or round the socket as a whole. Without a
// translation (1) and (2) are one statement, and only the last of the three is left: turned from a pose that
// is clear, joints impinge first where the surfaces meet. Theorem 7 (slip).
#pragma once

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Have the surfaces a common point? Exact, of coordinates as they stand. Faces without area meet nothing.
bool surfaces_meet(const TriangleMesh& a, const TriangleMesh& b);

/// Does the segment from the centre to x meet the surface? Exact; x is then in the shadow of a star-shaped
/// one. Not the centre itself.
bool beyond_surface(const TriangleMesh& mesh, const Vec3& x);

/// Does the ray from x away from the centre meet a surface whose coordinates are not above `reach`, mm? Exact
/// likewise; not for the centre.
bool within_surface(const TriangleMesh& mesh, const Vec3& x, double reach);

/// The wall of the rim out to `reach` mm or more.
TriangleMesh rim_wall(const TriangleMesh& mesh, double reach);

}  // namespace impinge
