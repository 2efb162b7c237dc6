// SPDX-License-Identifier: GPL-3.0-or-later
// Finds where a pose takes the caps of a block (contact/gap_bounds.hpp) and which limits they have there
// (contact/cap_limits.hpp), in loops without branches that the compiler turns into vector instructions.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "contact/gap_bounds.hpp"

namespace impinge::lanes {

inline float larger(float a, float b) { return a > b ? a : b; }  // b if one is NaN
inline float smaller(float a, float b) { return a < b ? a : b; }
inline std::int32_t larger(std::int32_t a, std::int32_t b) { return a > b ? a : b; }   // of the two
inline std::int32_t smaller(std::int32_t a, std::int32_t b) { return a < b ? a : b; }  // of the two

/// Inner product of a vector with the axis of node k.
inline float dot(const std::array<float, 3>& by, const CapBlock& block, std::size_t k) {
  return by[0] * block.x[k] + by[1] * block.y[k] + by[2] * block.z[k];
}

/// Upper bound on w . o but for the rounding that gap_bounds.hpp counts: T cos(b - angle), or T if the cap
/// holds the direction of o. Sine and cosine are replaced by the first terms of their alternating series,
/// which bound them. T sin b is rounded upwards, as it loses all digits if o is along the axis.
inline float most_along(float along, float angle, float shift) {
  const float square = angle * angle;
  const float low = 1.0F - 0.5F * square;
  const float high = low + square * square * (1.0F / 24.0F);
  const float sine = angle * (1.0F - square * (1.0F / 6.0F) * (1.0F - square * (1.0F / 20.0F)));
  const float rest = larger(shift * shift - along * along, 0.0F);
  const float across = std::sqrt(rest + kSquareSlack * (shift * shift));
  const float edge = along * (along > 0.0F ? high : low) + across * sine;
  return along >= low * shift ? shift : smaller(edge, shift);
}

/// Bound on |x| of the vertices of a node, mm: an upper one for the ball, a lower one for the socket.
template <Surface kScanned>
inline float length_of(const CapBlock& block, const CapMove& move, std::size_t k) {
  const float shift = move.shift;
  const float square = shift * shift;
  const float along = dot(move.own, block, k);
  const float low = block.low[k];
  const float high = block.high[k];
  if constexpr (kScanned == Surface::ball) {
    const float twice = 2.0F * most_along(along, block.angle[k], shift);
    const float most = larger(low * (low + twice), high * (high + twice)) + square;
    return std::sqrt(larger(most + kSquareSlack * (high * high + square), 0.0F));
  } else {
    const float least_along = -most_along(-along, block.angle[k], shift);
    const float nearest = smaller(larger(-least_along, low), high);
    const float least = nearest * (nearest + 2.0F * least_along) + square;
    return std::sqrt(larger(least - kSquareSlack * (nearest * nearest + square), 0.0F));
  }
}

/// Radius of a cap that holds the directions of a node's vertices, radians; infinite or NaN if any is
/// possible.
inline float angle_of(const CapBlock& block, const CapMove& move, std::size_t k) {
  const float rest = larger(block.low[k] * (1.0F - static_cast<float>(kNodeSlack)) - move.shift, 0.0F);
  return (block.angle[k] * block.low[k] + move.shift * block.spread[k]) / rest;
}

/// The caps of a block, moved by the pose.
template <Surface kScanned>
inline MovedCaps moved_lanes(const CapBlock& block, const CapMove& move) {
  MovedCaps caps;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    caps.x[k] = block.mean[k] * dot(move.rotation[0], block, k) + move.translation[0];
    caps.y[k] = block.mean[k] * dot(move.rotation[1], block, k) + move.translation[1];
    caps.z[k] = block.mean[k] * dot(move.rotation[2], block, k) + move.translation[2];
    caps.angle[k] = angle_of(block, move, k);
    caps.length[k] = length_of<kScanned>(block, move, k);
  }
  return caps;
}

/// An integer for each node of a block.
using WholeLanes = std::array<std::int32_t, CapBlock::kLanes>;

/// The levels (cap_limits.hpp) that answer for caps of these angles.
inline WholeLanes levels_of(const CapLanes& angle, const CapLevels& levels) {
  WholeLanes level;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    const auto octave =
        static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(angle[k]) >> CapLimits::kQuarterOctave);
    const std::int32_t of_cap = smaller(larger(CapLimits::kWidest - octave, 0), levels.finest);
    level[k] = of_cap + (angle[k] <= CapLimits::kAloneReach ? 1 : 0);
  }
  return level;
}

/// The line nearest to a place on a grid of so many cells. It is a line of the grid even for NaN.
inline std::int32_t line(float place, float scale, std::int32_t cells) {
  const auto most = static_cast<float>(cells);
  const float at = place * scale + (0.5F * most + 0.5F);
  return static_cast<std::int32_t>(smaller(larger(at, 0.0F), most));
}

/// The entry nearest to the middle of each cap, as in CapLimits::look_up().
inline WholeLanes entries_of(const MovedCaps& caps, const WholeLanes& steps) {
  WholeLanes entry;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    const float x = std::abs(caps.x[k]);
    const float y = std::abs(caps.y[k]);
    const float z = std::abs(caps.z[k]);
    const bool on_x = (x >= y) & (x >= z);
    const bool on_y = y >= z;
    const float along = on_x ? caps.x[k] : on_y ? caps.y[k] : caps.z[k];
    const float a = on_x ? caps.y[k] : caps.x[k];
    const float b = (on_x | on_y) ? caps.z[k] : caps.y[k];
    const std::int32_t axis = on_x ? 0 : on_y ? 2 : 4;
    const std::int32_t face = axis + (along < 0.0F ? 1 : 0);
    const std::int32_t cells = steps[k] & CapLimits::kMostLines;
    const float scale = 0.5F * static_cast<float>(cells) *
                        (1.0F / larger(std::abs(along), std::numeric_limits<float>::min()));
    const std::int32_t row = face * (cells + 1) + line(b, scale, cells);
    const auto first =
        static_cast<std::int32_t>(static_cast<std::uint32_t>(steps[k]) >> CapLimits::kLineBits);
    entry[k] = first + row * (cells + 1) + line(a, scale, cells);
  }
  return entry;
}

}  // namespace impinge::lanes
