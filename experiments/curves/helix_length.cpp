// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/helix_length.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "curves/carlson.hpp"
#include "curves/root.hpp"
#include "curves/rounding.hpp"
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

}  // namespace impinge
