// SPDX-License-Identifier: GPL-3.0-or-later
// Ball or socket, and all that differs between them. This is the only place that has the sign of a gap:
//
//   gap(u) = S(u) - B(u)        socket radius minus ball radius along u, mm; impinged if <= 0
#pragma once

#include <array>
#include <string_view>

#include "files/fields.hpp"
#include "gap/pose.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "table/face_cap.hpp"
#include "table/layer.hpp"

namespace impinge {

/// The two surfaces of a joint. A scan looks up the vertices of one in the table of the other.
enum class Surface { ball, socket };
template <>
inline constexpr std::array<std::string_view, 2> words_of<Surface>{"ball", "socket"};
inline constexpr std::array kSurfaces{Surface::ball, Surface::socket};

/// The surface that it faces.
constexpr Surface other(Surface of) { return of == Surface::ball ? Surface::socket : Surface::ball; }

/// "ball" or "socket".
constexpr std::string_view name(Surface of) { return word_of(of); }

/// The mesh of a surface.
inline const TriangleMesh& mesh_of(const BallSocketPair& joint, Surface of) {
  return of == Surface::ball ? joint.ball : joint.socket;
}

/// The layer of a surface that faces the other surface.
constexpr Layer facing_layer(Surface of) { return of == Surface::ball ? Layer::farthest : Layer::nearest; }

/// Takes a point of surface `of` to the frame of the other surface, mm.
inline Vec3 to_other(Surface of, const Pose& pose, const Vec3& point) {
  return of == Surface::ball ? to_socket(pose, point) : to_ball(pose, point);
}

/// +1 for the ball, -1 for the socket: the gap of a vertex is sign * (radius of the other surface - length).
template <class Real>
constexpr Real gap_sign(Surface of) {
  return of == Surface::ball ? Real{1} : Real{-1};
}

/// Gap of a vertex of surface `of` at the distance `length` from the centre, where the other surface has this
/// radius, mm.
template <class Real>
constexpr Real signed_gap(Surface of, Real radius, Real length) {
  return of == Surface::ball ? radius - length : length - radius;
}

/// The range of the gap if the radius of the other surface lies in a range, mm.
inline RadiusRange signed_gap(Surface of, const RadiusRange& radius, double length) {
  if (of == Surface::ball) return {radius.low - length, radius.high - length};
  return {length - radius.high, length - radius.low};
}

}  // namespace impinge
