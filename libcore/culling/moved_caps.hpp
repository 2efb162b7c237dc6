// SPDX-License-Identifier: GPL-3.0-or-later
// Where a pose takes the vertices of a cap, and what gaps they can have at least.
//
// A scan takes vertex v = s w (|w| = 1, low <= s <= high, w within `angle` of the axis a) to x = R v + t, and
// with o = R^T t to |x| = |v + o|. Let T = |t| < low and k = low / (low - T), so that |R w + t / s| >= 1 / k
// for all.
//
// Direction. That of x is that of R w + t / s. As 1 / s goes to 1 / mean it turns by k T per unit, along a
// way of spread / low at most; then, as w goes to a, by k per radian at most. So it is within
//   (angle low + T spread) / (low - T)   of that of   R (mean a) + t
// Length. |x|^2 = s^2 + 2 s (w.o) + T^2 grows with s, since w.o >= -T > -s. b being the angle between a and
// o,
//   cos(b + angle) <= w.o / T <= cos(b - angle), and cos(b -+ angle) is within angle sin(b) + angle^2 / 2 of
//   cos b.
// A translation as long as that allows any direction: T >= low leaves | |v| - T | <= |x| <= |v| + T.
//
// With the limit of the other surface over that cap (culling/cap_limits.hpp) the gap, S - |x| for vertices of
// the ball and |x| - B for those of the socket, is bounded below. R is orthogonal to 1e-8, which kNodeSlack
// covers.
#pragma once

#include <algorithm>
#include <cmath>

#include "culling/cap_limits.hpp"
#include "detection/algorithm_2.hpp"
#include "detection/pose.hpp"

namespace impinge {

// A pose as one of the scans sees it.
struct CapMove {
  CapMove(ScannedSurface scanned, const Pose& pose);

  Vec3 place(const Vec3& vertex) const {
    return scanned == ScannedSurface::ball ? to_socket(pose, vertex) : to_ball(pose, vertex);
  }

  ScannedSurface scanned;
  Pose pose;
  Eigen::Matrix3d rotation;  // R
  Vec3 translation;          // t
  Vec3 own;                  // o
  double shift;              // T
};

struct MovedCap {
  Vec3 middle;   // mm; its direction is that of the cap
  double angle;  // radians, infinite where any direction is possible
  double least;  // mm, of the vertices' distances from the centre
  double most;
};

inline MovedCap moved(const CapNode& node, const CapMove& move) {
  const double low = node.low;
  const double high = node.high;
  const double rest = low - move.shift;
  if (!(rest > kNodeSlack * low))
    return {Vec3::Zero(), kInfinity, std::max({0.0, rest, move.shift - high}), high + move.shift};
  const double wide = node.angle;
  const Vec3 axis = node.axis.cast<double>();
  const double along = axis.dot(move.own);
  const double across = std::sqrt(std::max(0.0, move.shift * move.shift - along * along));
  const double play = wide * (across + 0.5 * wide * move.shift);
  const double square = move.shift * move.shift;
  const double least = low * (low + 2.0 * std::max(along - play, -move.shift)) + square;
  const double most = high * (high + 2.0 * std::min(along + play, move.shift)) + square;
  return {move.rotation * (static_cast<double>(node.mean) * axis) + move.translation,
          (wide * low + move.shift * node.spread) / rest, std::sqrt(std::max(0.0, least)), std::sqrt(most)};
}

// No vertex of the cap has a smaller gap.
struct GapBound {
  double gap;    // mm, infinite where no vertex meets the other surface
  double spare;  // radians that the directions may turn by without changing that
};

inline GapBound gap_bound(const CapNode& node, const CapMove& move, const CapLimits& limits) {
  const MovedCap cap = moved(node, move);
  const CapLimits::Limit limit = limits.within(cap.middle, cap.angle);
  const double spare = limit.reach == kInfinity ? kInfinity : limit.reach - cap.angle;
  if (move.scanned == ScannedSurface::ball) return {limit.radius - cap.most, spare};
  return {limit.radius < 0.0 ? kInfinity : cap.least - limit.radius, spare};
}

// The same for a single vertex, moved to x.
inline double vertex_bound(const Vec3& x, const CapMove& move, const CapLimits& limits) {
  const double limit = limits.beside(x);
  if (move.scanned == ScannedSurface::ball) return limit - x.norm();
  return limit < 0.0 ? kInfinity : x.norm() - limit;
}

}  // namespace impinge
