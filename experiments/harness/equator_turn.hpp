// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the entries that a helix has on its turns round the equator, along its directions. A turn is a range
// of 360 degrees of azimuth; several cross the equator. As the entries do not divide a turn exactly, turns
// that begin elsewhere hold one entry more or less.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sphere/direction.hpp"

namespace impinge::lab {

// The fewest and most entries of turns that cross the equator.
struct EquatorTurn {
  std::size_t least = 0;  // of the turn with the fewest
  std::size_t most = 0;   // of the turn with the most
};

// Entries whose azimuth, radians, is in [begin, begin + 2 pi). An entry that rounding has put just below an
// end counts as on it.
inline std::size_t entries_of_turn(const std::vector<double>& azimuths, double begin) {
  constexpr double kRounding = 1e-9;
  const auto first = std::ranges::lower_bound(azimuths, begin - kRounding);
  const auto last = std::ranges::lower_bound(azimuths, begin + 2.0 * kPi - kRounding);
  return static_cast<std::size_t>(last - first);
}

// For a scheme whose entries follow each other from the north to the south pole with growing azimuth, less
// than a turn apart.
template <class Helix>
EquatorTurn equator_turn(const Helix& scheme) {
  std::size_t north = 0;
  std::size_t first = scheme.size() - 1;  // entry on the equator or below it
  while (first - north > 1) {
    const std::size_t middle = north + (first - north) / 2;
    (scheme.direction(middle).z() > 0.0 ? north : first) = middle;
  }
  const auto azimuth = [&](std::size_t i) {
    const Vec3 u = scheme.direction(i);
    return std::atan2(u.y(), u.x());
  };
  const auto step_to = [&](std::size_t i) {
    const double step = std::remainder(azimuth(i) - azimuth(i - 1), 2.0 * kPi);
    return step < 0.0 ? step + 2.0 * kPi : step;
  };
  std::vector<double> azimuths{0.0};  // from entry `first`, more than a turn both ways
  for (std::size_t i = first; i > 0 && azimuths.back() > -5.0 * kPi; --i)
    azimuths.push_back(azimuths.back() - step_to(i));
  std::ranges::reverse(azimuths);
  for (std::size_t i = first + 1; i < scheme.size() && azimuths.back() < 5.0 * kPi; ++i)
    azimuths.push_back(azimuths.back() + step_to(i));

  const double above = scheme.direction(north).z();
  const double below = scheme.direction(first).z();
  const double equator = below / (above - below) * step_to(first);
  std::vector<double> begins;  // starts of turns at which the number of entries may change
  for (const double a : azimuths) begins.insert(begins.end(), {a, a - 2.0 * kPi});
  std::ranges::sort(begins);
  EquatorTurn turn{scheme.size(), 0};
  for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
    for (const double begin : {begins[k], 0.5 * (begins[k] + begins[k + 1])}) {
      if (begin > equator || begin < equator - 2.0 * kPi) continue;
      const std::size_t entries = entries_of_turn(azimuths, begin);
      turn = {std::min(turn.least, entries), std::max(turn.most, entries)};
    }
  }
  return turn;
}

}  // namespace impinge::lab
