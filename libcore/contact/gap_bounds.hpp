// SPDX-License-Identifier: GPL-3.0-or-later
// Where a pose takes the vertices of a cap, and lower bounds on their gaps.
//
// A scan takes vertex v = s w (|w| = 1, low <= s <= high, w within `angle` of the axis a) to x = R v + t, and
// with o = R^T t to |x| = |v + o|. Let T = |t|.
//
// Direction, for T < low, k = low / (low - T): all |R w + t / s| >= 1 / k. The direction of x is that of R w
// + t / s. As 1 / s goes to 1 / mean it turns by k T per unit, along a way of spread / low at most; then, as
// w goes to a, by k per radian at most. So it is within
//   (angle low + T spread) / (low - T)   of that of   R (mean a) + t
// A longer translation allows any direction.
// Length. |x|^2 = s^2 + 2 s g + T^2, g = w.o, a parabola in s whose least is at -g, if that is a radius of
// the cap, and whose largest at low or high; it grows with g. b being the angle between a and o,
//   cos(b + angle) <= g / T <= cos(b - angle), 1 and -1 where the cap holds the direction of o and of -o:
// sums of cos b cos(angle) and sin b sin(angle), with bounds of the latter two by their series.
//
// With the limit of the other surface over that cap (contact/cap_limits.hpp) the gap, S - |x| for vertices of
// the ball and |x| - B for those of the socket, is bounded below. Theorem 8 (caps).
//
// Rounding. All is worked out in floats, e = 2^-24 of a result an operation, and what nearly cancels keeps
// the rounding of its terms: slacks are shares of the terms, never of a result.
// Direction. The middle, R in floats times a times mean, plus t, is off by 3 roundings of a product of three
// terms and 3 more a component, in all by 11 e mean + 2 e T, and mean <= 2 low, T < low: 24 e low =
// 1.5e-6 low. It is low - T or more long, so that it turns by 1.5e-6 low / (low - T) at most. The angle has
// kNodeSlack low / (low - T) in it, six times as much, and low less kNodeSlack of itself in the denominator
// for its own rounding.
// Length. a and o in floats and their product: w.o is off by 5 e T. (T sin b)^2 = T^2 - (T cos b)^2 is then
// off by 16 e T^2 at most, a quarter of the kSquareSlack T^2 that is added to it. So T cos(b - angle), which
// moves by no more than T cos b does unless the sine moves it, is below its bound but for 12 e T; a cap that
// only just holds the direction of o adds 8 e T. In |x|^2 that is 40 e s T <= 20 e (s^2 + T^2), and its own
// squares and sums add 13 e (s^2 + T^2) at most: 2e-6 (s^2 + T^2), half of kSquareSlack. R is orthogonal to
// 1e-7 in doubles, or the rest is not enough. Places of vertices in doubles are off by 2e-16 (s + T).
#pragma once

#include <array>
#include <cstdint>

#include "contact/cap_limits.hpp"
#include "contact/cap_tree.hpp"
#include "gap/surface.hpp"

namespace impinge {

inline constexpr float kSquareSlack = 4e-6F;  // of the squared lengths that are summed

/// A pose as one of the scans sees it. It takes vertices v of one surface to x = R v + t in the frame of the
/// other; o = R^T t, so that |x| = |v + o|.
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

/// The nodes of a block, moved by a pose.
struct MovedCaps {
  CapLanes x, y, z;  // mm: a point in the direction of the middle of the cap
  CapLanes angle;    // radians; infinite or NaN where any direction is possible
  CapLanes length;   // mm: no vertex of the ball is farther from the centre, none of the socket nearer
};

/// Bounds for the nodes of a block.
struct GapBounds {
  CapLanes gap;  // mm: no vertex has less; infinite where none meets the other surface
  /// mm, no bound: gap of a vertex in the middle of the cap, of the radius that is farther from contact. A
  /// touch is most likely where this is least.
  CapLanes likely;
  std::uint32_t open;  // a bit a node: its bound is not above `enough`
};

/// Where the pose takes the caps of a block.
MovedCaps moved(const CapBlock& block, const CapMove& move);

/// Bounds of the nodes of a block, worked out together. A node with a bound above `enough`, mm, need not be
/// opened.
GapBounds gap_bounds(const CapBlock& block, const CapMove& move, const CapLimits& limits, float enough);

}  // namespace impinge
