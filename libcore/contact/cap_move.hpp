// SPDX-License-Identifier: GPL-3.0-or-later
// A pose as one of the scans sees it.
#pragma once

#include <array>

#include "gap/algorithm_2.hpp"
#include "gap/pose.hpp"

namespace impinge {

// It takes vertices v of one surface to x = R v + t in the frame of the other; o = R^T t, so that |x| = |v +
// o|.
struct CapMove {
  CapMove(ScannedSurface scanned, const Pose& pose);  // of the vertices of that surface

  // Where the pose has a vertex, in the frame of the other surface, mm.
  Vec3 place(const Vec3& vertex) const {
    return scanned == ScannedSurface::ball ? to_socket(pose, vertex) : to_ball(pose, vertex);
  }

  ScannedSurface scanned;                        // whose vertices are moved
  Pose pose;                                     // of the ball in the socket
  std::array<std::array<float, 3>, 3> rotation;  // R, row by row
  std::array<float, 3> translation;              // t, mm
  std::array<float, 3> own;                      // o, mm
  float shift;                                   // T = |t|, mm
};

// Gap of a vertex at that distance from the centre, whose radii of the other surface are beyond the limit,
// mm.
inline double gap_beyond(double limit, double length, ScannedSurface scanned) {
  return scanned == ScannedSurface::ball ? limit - length : length - limit;
}

}  // namespace impinge
