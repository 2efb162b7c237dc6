// SPDX-License-Identifier: GPL-3.0-or-later
// Lower bounds on the gaps of the vertices of a cap in a pose, by Theorem 8 (caps).
//
// A scan takes a vertex v = s w (|w| = 1, low <= s <= high, w within `angle` of the axis a) to x = R v + t.
// With o = R^T t, T = |t|, b the angle between a and o, 1 / mean the mean of 1 / low and 1 / high, and
// spread = (high - low) / (2 high),
//   the directions of x and R (mean a) + t are within (angle low + T spread) / (low - T), if T < low,
//   |x|^2 = s^2 + 2 s (w . o) + T^2,  cos(b + angle) <= w . o / T <= cos(b - angle).
// A longer translation allows any direction. The limit of the other surface over that cap of directions
// (contact/cap_limits.hpp) then bounds the gap: S - |x| for the ball, |x| - B for the socket.
//
// Rounding, in floats, e = 2^-24. As terms may nearly cancel, slacks are shares of terms, never of a result.
//   direction  The middle is off by 11 e mean + 2 e T <= 24 e low and so turns by 1.5e-6 low / (low - T) at
//              most: a sixth of the kNodeSlack low / (low - T) that is in the angle. For its own rounding the
//              denominator has low less kNodeSlack of itself.
//   length     w . o is off by 5 e T, (T sin b)^2 by 16 e T^2, a quarter of the kSquareSlack T^2 that is
//              added. So T cos(b - angle) is too small by 12 e T at most, and by 8 e T more if a cap only
//              just holds the direction of o. In |x|^2 that is 40 e s T <= 20 e (s^2 + T^2). Squares and sums
//              add 13 e (s^2 + T^2): in all 2e-6 (s^2 + T^2), half of kSquareSlack.
// R must be orthogonal to 1e-7.
#pragma once

#include <array>
#include <cstdint>

#include "contact/cap_limits.hpp"
#include "contact/cap_tree.hpp"
#include "gap/surface.hpp"

namespace impinge {

inline constexpr float kSquareSlack = 4e-6F;  // share of the squared lengths that are summed

/// A pose as one of the scans sees it: it takes vertices v of one surface to x = R v + t in the frame of the
/// other. With o = R^T t, |x| = |v + o|.
struct CapMove {
  CapMove(Surface scanned, const Pose& pose);  // moves the vertices of `scanned`

  /// Where the pose takes a vertex, in the frame of the other surface, mm.
  Vec3 place(const Vec3& vertex) const { return to_other(scanned, pose, vertex); }

  Surface scanned;                               // whose vertices are moved
  Pose pose;                                     // of the ball in the socket
  std::array<std::array<float, 3>, 3> rotation;  // R, row by row
  std::array<float, 3> translation;              // t, mm
  std::array<float, 3> own;                      // o, mm
  float shift;                                   // T = |t|, mm
};

/// The nodes of a block, moved by a pose.
struct MovedCaps {
  CapLanes x, y, z;  // mm, a point in the direction of the middle of the cap
  CapLanes angle;    // radians; infinite or NaN if any direction is possible
  CapLanes length;   // mm; no vertex of the ball is farther from the centre, no vertex of the socket nearer
};

/// Bounds for the nodes of a block.
struct GapBounds {
  CapLanes gap;  // mm, no vertex has less; infinite if none meets the other surface
  /// mm, not a bound: the gap of a vertex in the middle of the cap, at the radius farther from contact. A
  /// touch is most likely where this is least.
  CapLanes likely;
  std::uint32_t open;  // a bit for each node, 1 if its bound is not above `enough`
};

/// Where the pose takes the caps of a block.
MovedCaps moved(const CapBlock& block, const CapMove& move);

/// Bounds for the nodes of a block. A node with a bound above `enough`, mm, need not be opened.
GapBounds gap_bounds(const CapBlock& block, const CapMove& move, const CapLimits& limits, float enough);

}  // namespace impinge
