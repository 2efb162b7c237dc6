// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/helix_entries.hpp"

#include <cmath>
#include <stdexcept>

#include "curves/helix_length.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

constexpr double kSame = 1e-6;  // relative; rounding of two mismatches of one size

double place(const HelixEntries& entries, std::size_t i) {
  const double end = last_index(entries);
  if (i >= entries.count) throw std::invalid_argument("there is no such entry on the helix");
  return static_cast<double>(i) / end;
}

// T at phi = pi in units of what the look-up takes for the length of the curve.
double assumed_length(const HelixEntries& entries, HelixSpacing spacing) {
  return spacing == HelixSpacing::true_arc ? helix_total_length(entries.turns)
                                           : total_travelled_distance(entries.turns);
}

}  // namespace

double last_index(const HelixEntries& entries) {
  if (entries.count < 2) throw std::invalid_argument("a helix has at least 2 entries, one on each pole");
  return static_cast<double>(entries.count - 1);
}

HelixEntries thesis_entries(std::size_t turns) { return {static_cast<double>(turns), turns * turns}; }

double polar_angle_of_equal_travel(const HelixEntries& entries, std::size_t i) {
  return polar_angle_at_travelled_distance(entries.turns,
                                           place(entries, i) * total_travelled_distance(entries.turns));
}

double polar_angle_of_equal_arc(const HelixEntries& entries, std::size_t i) {
  return polar_angle_at_length(entries.turns, place(entries, i) * helix_total_length(entries.turns));
}

double index_mismatch(const HelixEntries& entries, HelixSpacing spacing, double phi) {
  const double assumed = travelled_distance(entries.turns, phi) / assumed_length(entries, spacing);
  const double true_place = helix_length(entries.turns, phi) / helix_total_length(entries.turns);
  return last_index(entries) * (assumed - true_place);
}

Mismatch largest_index_mismatch(const HelixEntries& entries, HelixSpacing spacing) {
  const double turns = entries.turns;
  const double c =
      total_travelled_distance(turns) * helix_total_length(turns) / assumed_length(entries, spacing);
  const double stationary = std::asin(1.0 / std::sqrt(0.25 * c * c - 4.0 * turns * turns));
  Mismatch largest;
  for (const double phi : {stationary, kPi - stationary, kPi}) {
    const double index = index_mismatch(entries, spacing, phi);
    if (std::abs(index) > std::abs(largest.index) * (1.0 + kSame)) largest = {phi, index};
  }
  return largest;
}

}  // namespace impinge
