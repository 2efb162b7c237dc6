// SPDX-License-Identifier: GPL-3.0-or-later
// The two scans of Algorithm 2, with one signed gap for both.
//
//   gap(u) = S(u) - B(u)        socket radius minus ball radius along u, mm; <= 0 is impingement
//
// The thesis' test `d <= d_i` is right for ball vertices against the socket's table and wrong the other way
// round, and it keeps the distance of colliding vertices only. Here every vertex of both scans gets its
// signed gap. kNoSurface (NaN) where the other surface is not met: no surface there is never a hit.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>

#include "gap/pose.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {

// First scan: ball vertices (ball frame, mm) against the table of the socket. gap has the size of the
// vertices.
template <SamplingScheme S>
void scan_ball(const RadialTable<S>& socket, std::span<const Vec3> ball_vertices, const Pose& pose,
               std::span<double> gap) {
  assert(gap.size() == ball_vertices.size());
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const Vec3 x = to_socket(pose, ball_vertices[i]);
    gap[i] = socket.radius_at(x) - x.norm();
  }
}

// Second scan: socket vertices (socket frame, mm) against the table of the ball.
template <SamplingScheme S>
void scan_socket(const RadialTable<S>& ball, std::span<const Vec3> socket_vertices, const Pose& pose,
                 std::span<double> gap) {
  assert(gap.size() == socket_vertices.size());
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const Vec3 x = to_ball(pose, socket_vertices[i]);
    gap[i] = x.norm() - ball.radius_at(x);
  }
}

}  // namespace impinge
