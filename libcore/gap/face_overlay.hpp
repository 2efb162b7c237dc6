// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether a face X of the ball reaches a face Y of the socket, as the centre of one of them sees
// them: is there x = s y with x in X, y in Y, s >= 1? By Theorem 6 (overlay) it is enough to look along the
// directions of
//   a corner of the ball's face over the socket's,
//   a corner of the socket's face over the ball's,
//   a crossing of an edge of one and an edge of the other,
// by exact signs (sphere/plane_side.hpp). The face at rest is never edge-on (gap/overlay.hpp). A face that a
// pose makes edge-on for this centre counts with its sides.
#pragma once

#include <array>
#include <cstddef>

#include "files/fields.hpp"
#include "sphere/orientation.hpp"
#include "sphere/plane_side.hpp"

namespace impinge {

/// A face in a centre frame, mm.
struct OverlayFace {
  std::array<Vec3, 3> corner;  // in the order of the face
  int side = 0;                // orientation of the corners; 0 only if a pose has moved the face
};

/// Is the centre in this edge-on face, boundary included? Exact.
bool holds_centre(const OverlayFace& face);

/// The kinds of direction above; `centre` if the face of the socket holds the centre.
enum class OverlayKind { ball_corner, socket_corner, crossing, centre };
template <>
inline constexpr std::array<std::string_view, 4> words_of<OverlayKind>{
    "ball vertex", "socket vertex", "crossing of edges", "centre of the ball"};

/// A direction at which the gap over two faces may be smallest.
struct OverlayPoint {
  OverlayKind kind = OverlayKind::crossing;  // says what `ball` and `socket` are
  int order = 0;  // +1 if the ball is beyond the socket there, 0 if they touch, -1 if the ball is nearer
  std::size_t ball = 0;    // corner of the ball's face, or the side from this corner to the next
  std::size_t socket = 0;  // corner or side of the socket's face
};

/// Calls visit(point) for each such direction until visit returns true; returns whether it did. The `side` of
/// the face at rest must not be 0.
template <class Visit>
bool visit_overlay(const OverlayFace& ball, const OverlayFace& socket, Visit&& visit) {
  const auto beyond = [](const OverlayFace& face, const Vec3& x) {
    return face.side * plane_side(face.corner[0], face.corner[1], face.corner[2], x);
  };
  const auto over = [](const Vec3& x, const OverlayFace& face) {
    return face.side != 0 && place_in_cone(face.corner, face.side, x) >= 0;
  };
  if (socket.side == 0 && holds_centre(socket) && visit(OverlayPoint{OverlayKind::centre, 1, 0, 0}))
    return true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& x = ball.corner[k];
    if (over(x, socket) && visit(OverlayPoint{OverlayKind::ball_corner, beyond(socket, x), k, 0}))
      return true;
  }
  for (std::size_t l = 0; l < 3; ++l) {
    const Vec3& y = socket.corner[l];
    if (over(y, ball) && visit(OverlayPoint{OverlayKind::socket_corner, -beyond(ball, y), 0, l})) return true;
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

/// Does the ball's face reach the socket's? Exact.
inline bool reaches(const OverlayFace& ball, const OverlayFace& socket) {
  return visit_overlay(ball, socket, [](const OverlayPoint& point) { return point.order >= 0; });
}

/// Ball radius minus socket radius in this direction, mm, in floating point: how deep the ball is in the
/// socket. For `centre`, the distance of the farthest corner of the ball's face.
double depth_at(const OverlayFace& ball, const OverlayFace& socket, const OverlayPoint& point);

}  // namespace impinge
