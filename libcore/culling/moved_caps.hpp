// SPDX-License-Identifier: GPL-3.0-or-later
// Where a pose takes the vertices of a cap, and what gaps they can have at least.
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
//   cos(b + angle) <= g / T <= cos(b - angle), and cos(b -+ angle) is within angle sin(b) + angle^2 / 2 of
//   cos b.
//
// With the limit of the other surface over that cap (culling/cap_limits.hpp) the gap, S - |x| for vertices of
// the ball and |x| - B for those of the socket, is bounded below. Rounding: all in floats, 6e-8 of high + T
// an operation, against kNodeSlack and kSquareSlack; R is orthogonal to 1e-7.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "culling/cap_limits.hpp"
#include "detection/algorithm_2.hpp"
#include "detection/pose.hpp"

namespace impinge {

inline constexpr float kSquareSlack = 4e-6F;  // of a squared length

// A pose as one of the scans sees it.
struct CapMove {
  CapMove(ScannedSurface scanned, const Pose& pose);  // of the vertices of that surface

  // Where the pose has a vertex, in the frame of the other surface, mm.
  Vec3 place(const Vec3& vertex) const {
    return scanned == ScannedSurface::ball ? to_socket(pose, vertex) : to_ball(pose, vertex);
  }

  ScannedSurface scanned;       // whose vertices are moved
  Pose pose;                    // of the ball in the socket
  Eigen::Matrix3f rotation;     // R
  Eigen::Vector3f translation;  // t
  Eigen::Vector3f own;          // o
  float shift;                  // T
};

// Of the nodes of a block.
struct MovedCaps {
  CapLanes x, y, z;  // mm; in the direction of the middle of the cap
  CapLanes angle;    // radians; infinite or NaN where any direction is possible
  CapLanes length;   // mm: no vertex of the ball is farther from the centre, none of the socket nearer
};

// Bounds on |x| of the vertices of each node, mm: the most for those of the ball, the least for the socket's.
inline CapLanes moved_length(const CapBlock& block, const CapMove& move) {
  const float shift = move.shift;
  const float square = shift * shift;
  const CapLanes along = block.x * move.own.x() + block.y * move.own.y() + block.z * move.own.z();
  const CapLanes across = (square - along * along).max(0.0F).sqrt();
  const CapLanes play = block.angle * (across + 0.5F * shift * block.angle);
  if (move.scanned == ScannedSurface::ball) {
    const CapLanes twice = 2.0F * (along + play).min(shift);
    const CapLanes most = (block.low * (block.low + twice)).max(block.high * (block.high + twice));
    return ((most + square) * (1.0F + kSquareSlack)).sqrt();
  }
  const CapLanes least_along = (along - play).max(-shift);
  const CapLanes nearest = (-least_along).max(block.low).min(block.high);
  const CapLanes least = nearest * (nearest + 2.0F * least_along) + square;
  return (least - kSquareSlack * (nearest * nearest + square)).max(0.0F).sqrt();
}

// Where the pose takes the caps of a block.
inline MovedCaps moved(const CapBlock& block, const CapMove& move) {
  const CapLanes rest = (block.low - static_cast<float>(kNodeSlack) * block.low - move.shift).max(0.0F);
  const auto& r = move.rotation;
  const auto middle = [&](Eigen::Index k) -> CapLanes {
    return block.mean * (r(k, 0) * block.x + r(k, 1) * block.y + r(k, 2) * block.z) + move.translation[k];
  };
  return {middle(0), middle(1), middle(2), (block.angle * block.low + move.shift * block.spread) / rest,
          moved_length(block, move)};
}

// No vertex of the node has a smaller gap.
struct GapBounds {
  std::array<float, CapBlock::kLanes> gap;  // mm, infinite where no vertex meets the other surface
  // Radians that the directions may turn by without changing that; infinite or NaN: by any angle.
  std::array<float, CapBlock::kLanes> spare;
};

// Gap of vertices at those distances from the centre, whose radii of the other surface are beyond the limit,
// mm.
template <class Number>
Number gap_beyond(Number limit, Number length, const CapMove& move) {
  return move.scanned == ScannedSurface::ball ? limit - length : length - limit;
}

// No closer than it takes to be above `enough`.
inline GapBounds gap_bounds(const CapBlock& block, const CapMove& move, const CapLimits& limits,
                            float enough) {
  const MovedCaps caps = moved(block, move);
  GapBounds bounds;
  for (std::size_t k = 0; k < block.nodes; ++k) {
    const auto lane = static_cast<Eigen::Index>(k);
    const float length = caps.length[lane];
    bounds.gap[k] = gap_beyond(limits.overall(), length, move);
    bounds.spare[k] = HUGE_VALF;
    if (bounds.gap[k] > enough) continue;
    const auto limit = limits.within({caps.x[lane], caps.y[lane], caps.z[lane]}, caps.angle[lane]);
    bounds.gap[k] = gap_beyond(limit.radius, length, move);
    bounds.spare[k] = limit.reach - caps.angle[lane];
  }
  return bounds;
}

// A bound for a single vertex, moved to x; in double, so that rounding does not matter.
inline double vertex_bound(const Vec3& x, const CapMove& move, const CapLimits& limits) {
  return gap_beyond(static_cast<double>(limits.beside(x)), x.norm(), move);
}

}  // namespace impinge
