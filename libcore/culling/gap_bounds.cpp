// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over the lanes of a block without a branch in them, which the compiler turns into vector
// instructions.
#include "culling/gap_bounds.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "sphere/vector_clones.hpp"

namespace impinge {
namespace {

// The larger, and the smaller; of NaN the second.
inline float larger(float a, float b) { return a > b ? a : b; }
inline float smaller(float a, float b) { return a < b ? a : b; }
inline std::int32_t larger(std::int32_t a, std::int32_t b) { return a > b ? a : b; }
inline std::int32_t smaller(std::int32_t a, std::int32_t b) { return a < b ? a : b; }

inline float dot(const std::array<float, 3>& by, const CapBlock& block, std::size_t k) {
  return by[0] * block.x[k] + by[1] * block.y[k] + by[2] * block.z[k];
}

// Bounds on |x| of the vertices of a node, mm: the most for those of the ball, the least for the socket's.
template <ScannedSurface kScanned>
inline float length_of(const CapBlock& block, const CapMove& move, std::size_t k) {
  const float shift = move.shift;
  const float square = shift * shift;
  const float along = dot(move.own, block, k);
  const float across = std::sqrt(larger(square - along * along, 0.0F));
  const float play = block.angle[k] * (across + 0.5F * shift * block.angle[k]);
  const float low = block.low[k];
  const float high = block.high[k];
  if constexpr (kScanned == ScannedSurface::ball) {
    const float twice = 2.0F * smaller(along + play, shift);
    const float most = larger(low * (low + twice), high * (high + twice));
    return std::sqrt((most + square) * (1.0F + kSquareSlack));
  } else {
    const float least_along = larger(along - play, -shift);
    const float nearest = smaller(larger(-least_along, low), high);
    const float least = nearest * (nearest + 2.0F * least_along) + square;
    const float slack = kSquareSlack * (nearest * nearest + square);
    return std::sqrt(larger(least - slack, 0.0F));
  }
}

inline float angle_of(const CapBlock& block, const CapMove& move, std::size_t k) {
  const float rest = larger(block.low[k] * (1.0F - static_cast<float>(kNodeSlack)) - move.shift, 0.0F);
  return (block.angle[k] * block.low[k] + move.shift * block.spread[k]) / rest;
}

template <ScannedSurface kScanned>
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

using WholeLanes = std::array<std::int32_t, CapBlock::kLanes>;

// Levels of the ladder for caps of these angles.
inline WholeLanes levels_of(const CapLanes& angle, const CapLadder& ladder, float alone) {
  WholeLanes level;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    const auto octave =
        static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(angle[k]) >> CapLimits::kQuarterOctave);
    const std::int32_t of_cap = smaller(larger(CapLimits::kWidest - octave, 0), ladder.finest);
    level[k] = of_cap + (angle[k] <= alone ? 1 : 0);
  }
  return level;
}

// The line nearest to a place on a grid of so many cells. Whatever the numbers are, NaN too, it is one of
// them.
inline std::int32_t line(float place, float scale, std::int32_t cells) {
  const auto most = static_cast<float>(cells);
  const float at = place * scale + (0.5F * most + 0.5F);
  return static_cast<std::int32_t>(smaller(larger(at, 0.0F), most));
}

// The entry nearest to the middle of each cap, as CapLimits::look_up() has it.
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
    entry[k] = (steps[k] >> CapLimits::kLineBits) + row * (cells + 1) + line(a, scale, cells);
  }
  return entry;
}

// Reaches of levels, radians.
inline CapLanes reaches_of(const WholeLanes& level, const CapLadder& ladder) {
  CapLanes reach;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    const std::int32_t end = CapLimits::kWidest + 1 - level[k];
    const auto of_cap = std::bit_cast<float>(static_cast<std::uint32_t>(end) << CapLimits::kQuarterOctave);
    reach[k] = level[k] == 0 ? HUGE_VALF : level[k] > ladder.finest ? CapLimits::kAloneReach : of_cap;
  }
  return reach;
}

// What the caps have to spare. A limit that all directions have, if it is good enough, lasts whatever they turn
// by.
template <ScannedSurface kScanned>
inline void make_last(const MovedCaps& caps, const WholeLanes& level, const CapLadder& ladder, float enough,
                      GapBounds& __restrict bounds) {
  const CapLanes reach = reaches_of(level, ladder);
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    const float overall = kScanned == ScannedSurface::ball ? ladder.overall - caps.length[k]
                                                           : caps.length[k] - ladder.overall;
    const bool surely = overall > enough;
    bounds.gap[k] = surely ? overall : bounds.gap[k];
    bounds.spare[k] = surely ? HUGE_VALF : reach[k] - caps.angle[k];
  }
}

// The work on a block, once for each scan and kind of answer: what the other one needs is left out.
template <ScannedSurface kScanned, bool kLasting>
inline void bound_lanes(const CapBlock& block, const CapMove& move, const CapLadder& ladder, float enough,
                        GapBounds& __restrict bounds) {
  const MovedCaps caps = moved_lanes<kScanned>(block, move);
  const WholeLanes level = levels_of(caps.angle, ladder, kLasting ? -1.0F : CapLimits::kAloneReach);
  WholeLanes steps;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) steps[k] = ladder.steps[level[k]];
  const WholeLanes entry = entries_of(caps, steps);
  CapLanes limit;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) limit[k] = ladder.limits[entry[k]];
  constexpr bool kBall = kScanned == ScannedSurface::ball;
  WholeLanes open;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    const float gap = kBall ? limit[k] - caps.length[k] : caps.length[k] - limit[k];
    const float middle = dot(move.own, block, k) + (kBall ? block.low[k] : block.high[k]);
    bounds.gap[k] = gap;
    bounds.likely[k] = kBall ? limit[k] - middle : middle - limit[k];
    open[k] = gap > enough ? 0 : 1 << k;
  }
  if constexpr (kLasting) make_last<kScanned>(caps, level, ladder, enough, bounds);
  std::int32_t some = 0;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) some |= open[k];
  bounds.open = static_cast<std::uint32_t>(some) & ((1U << block.nodes) - 1U);
}

[[gnu::flatten]] IMPINGE_VECTOR_CLONES
void bound_ball(const CapBlock& block, const CapMove& move, const CapLadder& ladder, float enough,
                GapBounds& bounds) {
  bound_lanes<ScannedSurface::ball, false>(block, move, ladder, enough, bounds);
}

[[gnu::flatten]] IMPINGE_VECTOR_CLONES
void bound_socket(const CapBlock& block, const CapMove& move, const CapLadder& ladder, float enough,
                  GapBounds& bounds) {
  bound_lanes<ScannedSurface::socket, false>(block, move, ladder, enough, bounds);
}

[[gnu::flatten]] IMPINGE_VECTOR_CLONES
void bound_ball_lastingly(const CapBlock& block, const CapMove& move, const CapLadder& ladder, float enough,
                          GapBounds& bounds) {
  bound_lanes<ScannedSurface::ball, true>(block, move, ladder, enough, bounds);
}

[[gnu::flatten]] IMPINGE_VECTOR_CLONES
void bound_socket_lastingly(const CapBlock& block, const CapMove& move, const CapLadder& ladder, float enough,
                            GapBounds& bounds) {
  bound_lanes<ScannedSurface::socket, true>(block, move, ladder, enough, bounds);
}

}  // namespace

MovedCaps moved(const CapBlock& block, const CapMove& move) {
  return move.scanned == ScannedSurface::ball ? moved_lanes<ScannedSurface::ball>(block, move)
                                              : moved_lanes<ScannedSurface::socket>(block, move);
}

GapBounds gap_bounds(const CapBlock& block, const CapMove& move, const CapLimits& limits,
                     const GapsWanted& wanted) {
  GapBounds bounds;
  const bool ball = move.scanned == ScannedSurface::ball;
  const CapLadder ladder = limits.ladder();
  if (wanted.lasting) {
    (ball ? bound_ball_lastingly : bound_socket_lastingly)(block, move, ladder, wanted.enough, bounds);
  } else {
    (ball ? bound_ball : bound_socket)(block, move, ladder, wanted.enough, bounds);
  }
  return bounds;
}

}  // namespace impinge
