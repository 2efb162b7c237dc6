// SPDX-License-Identifier: GPL-3.0-or-later
// Decides without rounding on which side of a surface a point lies along its ray from the centre.
//
// The input is the mesh and the point x in doubles: a moved vertex is the doubles that to_socket() or
// to_ball() give. Whether the ray of x meets a face, boundary included, is a sign of orientation(); whether x
// lies beyond the face is a sign of plane_side(). Both are exact, however close x is: Theorem 1 (signs).
// Which faces count is said in gap/overlay.hpp.
#pragma once

#include "gap/surface.hpp"
#include "table/near_faces.hpp"

namespace impinge {

/// Is a vertex of surface `of`, which a pose has at x in the frame of the other surface, impinged, with a gap
/// of zero or less? `faces` are the faces of the other surface. A vertex of the ball is impinged on or beyond
/// a face of the socket, and never at the centre. A vertex of the socket is impinged on or within a face of
/// the ball, and always at the centre if a face counts.
bool exactly_impinged(Surface of, const NearFaces& faces, const Vec3& x);

}  // namespace impinge
