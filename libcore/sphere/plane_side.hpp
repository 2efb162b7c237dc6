// SPDX-License-Identifier: GPL-3.0-or-later
// Decides exactly on which side of the plane of a face a point lies, and which of two crossing edges is
// farther from the centre. Both are the same sign of four points. Theorem 1 (signs).
#pragma once

#include "sphere/direction.hpp"

namespace impinge {

/// Sign of det(b - a, c - a, d - a) = det(b, c, d) - det(a, c, d) + det(a, b, d) - det(a, b, c): +1, 0 or -1,
/// exact for finite input whose components differ by less than a factor of about 2^300. It is +1 if d lies on
/// the side from which a, b, c run clockwise. For the centre (d = 0) it is -orientation(a, b, c), so that
///   orientation(a, b, c) * plane_side(a, b, c, d)
/// is +1 beyond the plane of the face, 0 on it and -1 on the side of the centre.
int plane_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Two segments a - b and c - d as the centre sees them.
struct Crossing {
  /// Does some ray from the centre meet both, ends included? False if all lie in one plane with the centre.
  bool crosses = false;
  int order = 0;  // +1 if it meets a - b beyond c - d, 0 if they meet each other, -1 if a - b is nearer
};

/// How the segments a - b and c - d cross, by exact signs. The numbers
///   k = (det(b, c, d), -det(a, c, d), det(a, b, d), -det(a, b, c))
/// make k1 a + k2 b + k3 c + k4 d = 0. The segments cross where k1 and k2 have one sign and k3 and k4 the
/// other. The point of a - b is then s times the point of c - d, and the sum of all k, plane_side(a, b, c,
/// d), has the sign of (1 - s) k1.
Crossing crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace impinge
