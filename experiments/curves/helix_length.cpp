// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/helix_length.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "curves/gsl.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

void require_turns(double turns) {
  if (!(turns >= 2.0 && std::isfinite(turns))) {
    throw std::invalid_argument("a spherical helix has at least 2 turns, and finitely many");
  }
}

void require_polar_angle(double phi) {
  if (!(phi >= 0.0 && phi <= kPi)) {
    throw std::invalid_argument("a polar angle of the helix is in [0, pi] radians");
  }
}

double clamped(double length, double total) {
  if (!(length >= -kCurveRounding * total && length <= (1.0 + kCurveRounding) * total)) {
    throw std::invalid_argument("a length along the helix is between 0 and that of the whole curve");
  }
  return std::clamp(length, 0.0, total);
}

// L(phi) in the northern half.
double half_length(double turns, double phi) { return arc_of_growing_speed(phi, 4.0 * turns * turns); }

constexpr double kSame = 1e-6;  // relative difference of two mismatches that rounding may make

double place(const HelixEntries& entries, std::size_t i) {
  const double end = last_index(entries);
  if (i >= entries.count) throw std::invalid_argument("there is no such entry on the helix");
  return static_cast<double>(i) / end;
}

// T at phi = pi, in the unit that the look-up takes for the length of the curve.
double assumed_length(const HelixEntries& entries, HelixSpacing spacing) {
  return spacing == HelixSpacing::true_arc ? helix_total_length(entries.turns)
                                           : total_travelled_distance(entries.turns);
}

// Two entries, and the weight of the second.
struct Between {
  std::size_t entry;
  double share;
};

Between on_turn(const HelixEntries& entries, HelixIndex index, double phi) {
  const double place = helix_place(entries, index, phi);
  const std::size_t entry = std::min(static_cast<std::size_t>(place), entries.count - 2);
  return {entry, place - static_cast<double>(entry)};
}

double share_of_curve(const HelixEntries& entries, HelixIndex index, double phi) {
  const double turns = entries.turns;
  if (index == HelixIndex::true_arc) return helix_length(turns, phi) / helix_total_length(turns);
  return travelled_distance(turns, phi) / (index == HelixIndex::eq10_true_spacing
                                               ? helix_total_length(turns)
                                               : total_travelled_distance(turns));
}

}  // namespace

double helix_length(double turns, double phi) {
  require_turns(turns);
  require_polar_angle(phi);
  if (2.0 * phi <= kPi) return half_length(turns, phi);
  return helix_total_length(turns) - half_length(turns, kPi - phi);
}

double helix_total_length(double turns) {
  require_turns(turns);
  return 2.0 * half_length(turns, 0.5 * kPi);
}

double helix_total_length_asymptote(double turns) {
  require_turns(turns);
  return 4.0 * turns + (std::log(8.0 * turns) + 0.5) / (2.0 * turns);
}

double travelled_distance(double turns, double phi) {
  require_polar_angle(phi);
  const double half = std::sin(0.5 * phi);
  return total_travelled_distance(turns) * half * half;
}

double total_travelled_distance(double turns) {
  require_turns(turns);
  return 4.0 * turns + 1.0;
}

double polar_angle_at_length(double turns, double length) {
  const double total = helix_total_length(turns);
  const double wanted = clamped(length, total);
  const double north = std::min(wanted, total - wanted);  // the southern half mirrors the northern one
  const double phi =
      find_root([&](double angle) { return half_length(turns, angle) - north; }, 0.0, 0.5 * kPi);
  return wanted == north ? phi : kPi - phi;
}

double polar_angle_at_travelled_distance(double turns, double distance) {
  const double total = total_travelled_distance(turns);
  const double wanted = clamped(distance, total);
  return 2.0 * std::atan2(std::sqrt(wanted), std::sqrt(total - wanted));
}

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

std::optional<HelixNeighbours> helix_neighbours(const HelixEntries& entries, const Vec3& x) {
  const Angles at = to_angles(x);
  const double slope = 2.0 * entries.turns;
  const double above = std::floor((slope * at.phi - at.theta) / (2.0 * kPi));
  HelixNeighbours found;
  found.phi_above = (at.theta + 2.0 * kPi * above) / slope;
  found.phi_below = found.phi_above + 2.0 * kPi / slope;
  if (found.phi_above < 0.0 || found.phi_below > kPi) return std::nullopt;
  found.travelled_above = travelled_distance(entries.turns, found.phi_above);
  found.travelled_below = travelled_distance(entries.turns, found.phi_below);
  const double spacing = total_travelled_distance(entries.turns) / static_cast<double>(entries.count - 1);
  const auto before = [&](double travelled) {
    return std::min(static_cast<std::size_t>(travelled / spacing), entries.count - 2);
  };
  const std::size_t a = before(found.travelled_above);
  const std::size_t b = before(found.travelled_below);
  found.entry = {a, a + 1, b, b + 1};
  return found;
}

double helix_place(const HelixEntries& entries, HelixIndex index, double phi) {
  return last_index(entries) * std::min(share_of_curve(entries, index, phi), 1.0);
}

Stencil helix_stencil(const HelixEntries& entries, HelixIndex index, const Vec3& x) {
  const Angles at = to_angles(x);
  const double slope = 2.0 * entries.turns;
  const double above = std::floor((slope * at.phi - at.theta) / (2.0 * kPi));
  const double phi_a = (at.theta + 2.0 * kPi * above) / slope;
  const double phi_b = (at.theta + 2.0 * kPi * (above + 1.0)) / slope;
  if (phi_a < 0.0) {
    const Between b = on_turn(entries, index, phi_b);
    const double down = std::min(at.phi / phi_b, 1.0);
    return {{0, b.entry, b.entry + 1}, {1.0 - down, down * (1.0 - b.share), down * b.share}, 3, 0};
  }
  const Between a = on_turn(entries, index, std::min(phi_a, kPi));
  if (phi_b > kPi) {
    const double down = phi_a < kPi ? std::clamp((at.phi - phi_a) / (kPi - phi_a), 0.0, 1.0) : 0.0;
    return {{a.entry, a.entry + 1, entries.count - 1},
            {(1.0 - down) * (1.0 - a.share), (1.0 - down) * a.share, down},
            3,
            0};
  }
  const Between b = on_turn(entries, index, phi_b);
  const double down = std::clamp((at.phi - phi_a) / (phi_b - phi_a), 0.0, 1.0);
  return {{a.entry, a.entry + 1, b.entry, b.entry + 1},
          {(1.0 - down) * (1.0 - a.share), (1.0 - down) * a.share, down * (1.0 - b.share), down * b.share},
          4,
          0};
}

}  // namespace impinge
