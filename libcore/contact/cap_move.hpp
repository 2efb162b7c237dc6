// SPDX-License-Identifier: GPL-3.0-or-later
// A pose as one of the scans sees it.
#pragma once

#include <array>

#include "gap/surface.hpp"

namespace impinge {

/// It takes vertices v of one surface to x = R v + t in the frame of the other; o = R^T t, so that |x| = |v +
/// o|.
struct CapMove {
  CapMove(Surface scanned, const Pose& pose);  // of the vertices of that surface

  /// Where the pose has a vertex, in the frame of the other surface, mm.
  Vec3 place(const Vec3& vertex) const { return to_other(scanned, pose, vertex); }

  Surface scanned;                               // whose vertices are moved
  Pose pose;                                     // of the ball in the socket
  std::array<std::array<float, 3>, 3> rotation;  // R, row by row
  std::array<float, 3> translation;              // t, mm
  std::array<float, 3> own;                      // o, mm
  float shift;                                   // T = |t|, mm
};

}  // namespace impinge
