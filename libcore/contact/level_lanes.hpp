// SPDX-License-Identifier: GPL-3.0-or-later
// Look-ups of the limits of moved caps, in loops without a branch that the compiler turns into vector
// instructions, for whoever includes them with its own; see contact/cap_limits.hpp.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "contact/moved_lanes.hpp"

namespace impinge::lanes {

/// A whole number of each node of a block.
using WholeLanes = std::array<std::int32_t, CapBlock::kLanes>;

/// Levels of the levels for caps of these angles.
inline WholeLanes levels_of(const CapLanes& angle, const CapLevels& levels, float alone) {
  WholeLanes level;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    const auto octave =
        static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(angle[k]) >> CapLimits::kQuarterOctave);
    const std::int32_t of_cap = smaller(larger(CapLimits::kWidest - octave, 0), levels.finest);
    level[k] = of_cap + (angle[k] <= alone ? 1 : 0);
  }
  return level;
}

/// The line nearest to a place on a grid of so many cells. Whatever the numbers are, NaN too, it is one of
/// them.
inline std::int32_t line(float place, float scale, std::int32_t cells) {
  const auto most = static_cast<float>(cells);
  const float at = place * scale + (0.5F * most + 0.5F);
  return static_cast<std::int32_t>(smaller(larger(at, 0.0F), most));
}

/// The entry nearest to the middle of each cap, as CapLimits::look_up() has it.
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

/// Reaches of levels, radians.
inline CapLanes reaches_of(const WholeLanes& level, const CapLevels& levels) {
  CapLanes reach;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    const std::int32_t end = CapLimits::kWidest + 1 - level[k];
    const auto of_cap = std::bit_cast<float>(static_cast<std::uint32_t>(end) << CapLimits::kQuarterOctave);
    reach[k] = level[k] == 0 ? HUGE_VALF : level[k] > levels.finest ? CapLimits::kAloneReach : of_cap;
  }
  return reach;
}

}  // namespace impinge::lanes
