// SPDX-License-Identifier: GPL-3.0-or-later
// The least and the largest error of look-ups in a region.
#pragma once

#include <algorithm>
#include <array>

namespace impinge::lab {

// Always contains 0, the error at an entry.
struct ErrorRange {
  double low = 0.0;   // the least
  double high = 0.0;  // the largest

  // Widened to hold an error.
  void include(double error) {
    low = std::min(low, error);
    high = std::max(high, error);
  }
  // Widened to hold those of another place.
  void include(const ErrorRange& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
  double middle() const { return 0.5 * (low + high); }  // subtracting this makes both ends equally large
};

// Range on [0, 1] of the quadratic with these values at 0, 1/2 and 1.
inline ErrorRange range_of_quadratic(const std::array<double, 3>& value) {
  ErrorRange range;
  for (const double v : value) range.include(v);
  const double slope = 4.0 * value[1] - 3.0 * value[0] - value[2];
  const double square = 2.0 * (value[0] - 2.0 * value[1] + value[2]);
  const double flat = -0.5 * slope / square;  // where the derivative is 0; no number along a line
  if (flat > 0.0 && flat < 1.0) range.include(value[0] + 0.5 * slope * flat);
  return range;
}

}  // namespace impinge::lab
