// SPDX-License-Identifier: GPL-3.0-or-later
// On which side of a surface a point lies along its ray from the centre, decided without rounding.
//
// What is exact. The input is the mesh and the point x as they stand in doubles: a vertex that a pose has
// moved is first rounded to doubles by to_socket() or to_ball(), and these doubles are the point. Whether
// the ray of x meets a face, boundary included, is a sign of orientation(), and whether x lies beyond the
// face is one of plane_side(): no rounding enters the answer, however close x is. Which faces count, and what
// a point at the centre means, is said in gap/overlay.hpp. Theorem 1 (signs).
#pragma once

#include "gap/surface.hpp"
#include "table/near_faces.hpp"

namespace impinge {

/// Is a vertex of that surface, which a pose has at x in the frame of the other one, impinged, with a gap of
/// zero or less? `faces` are those of the other surface. For one of the ball: is it on a face of the socket
/// or beyond; never at the centre. For one of the socket: is it on a face of the ball or before it; always at
/// the centre, if a face counts.
bool exactly_impinged(Surface of, const NearFaces& faces, const Vec3& x);

}  // namespace impinge
