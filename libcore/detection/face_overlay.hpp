// SPDX-License-Identifier: GPL-3.0-or-later
// One face of the ball over one face of the socket, as the centre sees them.
//
// Along a direction u the plane of a face has 1 / r = q.u, with one vector q for each face. So 1 / S - 1 / B
// is linear in u over the directions that both faces cover, a convex cone, and the ball reaches the socket (B
// >= S, 1 / S - 1 / B >= 0) somewhere in it exactly if it does so along one of its edges. Those are
// directions through
//   a corner of the ball's face over the socket's,
//   a corner of the socket's face over the ball's,
//   a crossing of an edge of one and an edge of the other.
// Each is decided by exact signs (sphere/plane_side.hpp).
#pragma once

#include <array>
#include <cstddef>

#include "sphere/orientation.hpp"
#include "sphere/plane_side.hpp"

namespace impinge {

// Corners in a centre frame, mm, and their orientation, which is not zero.
struct OverlayFace {
  std::array<Vec3, 3> corner;  // as the face has them
  int side = 0;                // orientation of the corners
};

// Which of the three directions above it is.
enum class OverlayKind { ball_corner, socket_corner, crossing };

// A direction at which the gap over two faces may be smallest.
struct OverlayPoint {
  OverlayKind kind = OverlayKind::crossing;  // says what `ball` and `socket` are
  int order = 0;  // +1 if the ball is beyond the socket there, 0 if they touch, -1 if the ball is nearer
  std::size_t ball = 0;    // corner, or side from this corner to the next
  std::size_t socket = 0;  // likewise of the socket's face
};

// Calls visit(point) for each of them until it returns true; returns whether it did.
template <class Visit>
bool visit_overlay(const OverlayFace& ball, const OverlayFace& socket, Visit&& visit) {
  const auto beyond = [](const OverlayFace& face, const Vec3& x) {
    return face.side * plane_side(face.corner[0], face.corner[1], face.corner[2], x);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& x = ball.corner[k];
    if (place_in_cone(socket.corner, socket.side, x) >= 0 &&
        visit(OverlayPoint{OverlayKind::ball_corner, beyond(socket, x), k, 0}))
      return true;
  }
  for (std::size_t l = 0; l < 3; ++l) {
    const Vec3& y = socket.corner[l];
    if (place_in_cone(ball.corner, ball.side, y) >= 0 &&
        visit(OverlayPoint{OverlayKind::socket_corner, -beyond(ball, y), 0, l}))
      return true;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) {
      const Crossing found =
          crossing(ball.corner[k], ball.corner[(k + 1) % 3], socket.corner[l], socket.corner[(l + 1) % 3]);
      if (found.crosses && visit(OverlayPoint{OverlayKind::crossing, found.order, k, l})) return true;
    }
  }
  return false;
}

// Is there a direction in which both faces lie and the ball's is as far from the centre as the socket's, or
// farther? Exact.
inline bool reaches(const OverlayFace& ball, const OverlayFace& socket) {
  return visit_overlay(ball, socket, [](const OverlayPoint& point) { return point.order >= 0; });
}

// Ball radius minus socket radius at that point, mm, in floating point: how deep the ball is in the socket.
double depth_at(const OverlayFace& ball, const OverlayFace& socket, const OverlayPoint& point);

}  // namespace impinge
