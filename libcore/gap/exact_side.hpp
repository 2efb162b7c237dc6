// SPDX-License-Identifier: GPL-3.0-or-later
// On which side of a surface a point lies along its ray from the centre, decided without rounding.
//
// What is exact. The input is the mesh and the point x as they stand in doubles: a vertex that a pose has
// moved is first rounded to doubles by to_socket() or to_ball(), and these doubles are the point. Whether
// the ray of x meets a face, boundary included, is a sign of orientation(), and whether x lies beyond the
// face is one of plane_side(): no rounding enters the answer, however close x is. Which faces count, and what
// a point at the centre means, is said in gap/overlay.hpp.
#pragma once

#include "mesh/triangle_mesh.hpp"
#include "table/face_index.hpp"
#include "table/near_faces.hpp"

namespace impinge {

// Is x on some face of the surface or beyond it? For a vertex of the ball, in the socket frame, this is a gap
// of zero or less. Never at the centre.
bool on_or_beyond(const TriangleMesh& surface, const FaceIndex& index, const Vec3& x);

// Is x on some face of the surface or on the near side of it? For a vertex of the socket, in the ball frame,
// this is a gap of zero or less. Always at the centre, if a face counts.
bool on_or_within(const TriangleMesh& surface, const FaceIndex& index, const Vec3& x);

// The same with an index that is made sooner and looks at fewer faces.
bool on_or_beyond(const NearFaces& surface, const Vec3& x);
bool on_or_within(const NearFaces& surface, const Vec3& x);  // Likewise.

}  // namespace impinge
