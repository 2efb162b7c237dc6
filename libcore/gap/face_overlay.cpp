// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/face_overlay.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include "sphere/triangle_cone.hpp"

namespace impinge {
namespace {

TriangleCone cone_of(const OverlayFace& face) { return {face.corner[0], face.corner[1], face.corner[2]}; }

double det(const Vec3& a, const Vec3& b, const Vec3& c) { return a.dot(b.cross(c)); }

// Distance of the point where the plane through the centre, c and d meets a - b.
double distance_at(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double at_a = std::abs(det(b, c, d));
  const double at_b = std::abs(det(a, c, d));
  const double share = at_a + at_b > 0.0 ? at_b / (at_a + at_b) : 0.0;
  return (a + share * (b - a)).norm();
}

}  // namespace

// The centre, in the plane of a triangle, is within it if it is on the same side of all sides: a x b, b x c
// and c x a point one way, by orientation() of their components. All three vanish if the corners are on one
// line with the centre; then it must lie between two of them.
bool holds_centre(const OverlayFace& face) {
  const auto& c = face.corner;
  bool on_line = true;
  bool aside = false;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 unit = Vec3::Unit(axis);
    const auto [least, most] = std::minmax(
        {orientation(c[0], c[1], unit), orientation(c[1], c[2], unit), orientation(c[2], c[0], unit)});
    if (least < 0 && most > 0) return false;
    on_line = on_line && least == 0 && most == 0;
    const auto [low, high] = std::minmax({c[0][axis], c[1][axis], c[2][axis]});
    aside = aside || low > 0.0 || high < 0.0;
  }
  return !on_line || !aside;
}

double depth_at(const OverlayFace& ball, const OverlayFace& socket, const OverlayPoint& point) {
  const Vec3& a = ball.corner[point.ball];
  const Vec3& c = socket.corner[point.socket];
  switch (point.kind) {
    case OverlayKind::ball_corner:
      return a.norm() - cone_of(socket).radius(a.normalized());
    case OverlayKind::socket_corner:
      return cone_of(ball).radius(c.normalized()) - c.norm();
    case OverlayKind::centre:
      return std::max({ball.corner[0].norm(), ball.corner[1].norm(), ball.corner[2].norm()});
    case OverlayKind::crossing:
      break;
  }
  const Vec3& b = ball.corner[(point.ball + 1) % 3];
  const Vec3& d = socket.corner[(point.socket + 1) % 3];
  return distance_at(a, b, c, d) - distance_at(c, d, a, b);
}

}  // namespace impinge
