// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a precision in degrees into the number of divisions of a grid, for all schemes that have one.
#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace impinge {

/// The largest n. With at most 20 n^2 / 2 entries that makes 2.5e18, which a std::size_t holds.
inline constexpr double kMostDivisions = 5e8;

/// The smallest n for which the entries on the equator are on average at most `degrees` apart, for a grid
/// that places n of them on `arc` degrees of it. Throws std::invalid_argument if there is none.
inline std::size_t equator_division(double degrees, double arc, std::string_view label) {
  const std::string start = "the precision of the scheme '" + std::string(label) + "' ";
  if (!(degrees > 0.0 && degrees <= 90.0))
    throw std::invalid_argument(start + "is above 0 and at most 90 degrees");
  constexpr double rounding = 1e-9;  // 90 / 0.05 is meant to be 1800
  const double divisions = std::ceil(arc / degrees * (1.0 - rounding));
  if (divisions > kMostDivisions) throw std::invalid_argument(start + "is at least 1.8e-7 degrees");
  return static_cast<std::size_t>(divisions);
}

}  // namespace impinge
