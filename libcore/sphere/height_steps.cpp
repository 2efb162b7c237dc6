// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/height_steps.hpp"

#include <cmath>

#include "sphere/spiral_radii.hpp"
#include "sphere/turn_angle.hpp"
#include "sphere/vector_clones.hpp"

namespace impinge {
namespace {

// An entry is the m-th from the nearer pole. With x = m / (w - 1), at most 1/2,
//   s = sin(phi / 2) = sqrt(x),  c = cos(phi / 2) = sqrt(1 - x),  phi / 2 = s (1 + d q(d)),  d = 1 - c,
// where the polynomial q interpolates at Chebyshev nodes, within 3e-17 / d. Up to phi the helix has made
// (high + low) phi / 2 turns. The product high * coarse has no rounding, as both have 26 bits, so that the
// fraction of a turn is as accurate as s, however many turns there are.
struct Point {
  double x;
  double y;
  double z;
};

inline Point entry_direction(const HeightSteps::Curve& curve, double i) {
  const bool south = i > 0.5 * curve.last;
  const double from_pole = south ? curve.last - i : i;
  const double x = (from_pole < 0.0 ? 0.0 : from_pole) / curve.last;
  const double s = std::sqrt(x);
  const double c = std::sqrt(1.0 - x);
  const double d = 1.0 - c;
  const double d2 = d * d;
  const double d4 = d2 * d2;
  const double q =
      (0.3333333333333334 + 0.13333333333325953 * d) + (0.057142857152906956 + 0.02539682486450752 * d) * d2 +
      ((0.011544025959186025 + 0.005327778514072288 * d) +
       (0.0024886149078401838 + 0.0011563299153951427 * d) * d2 +
       ((0.0006082893079751548 + 0.00013564579639345278 * d) + 0.00028624328516098303 * d2) * d4) *
          d4;
  const double coarse = (s + 0x1.8p26) - 0x1.8p26;  // a multiple of 2^-26
  const double whole = coarse * curve.high;
  const double rest = (s - coarse) * curve.high + s * (curve.low + (curve.high + curve.low) * (d * q));
  const double turns = (whole - nearest_whole(whole)) + rest;
  const CosSin theta = turn_angle(south ? curve.end - turns : turns);
  const double sin_phi = 2.0 * s * c;
  const double cos_phi = 1.0 - 2.0 * x;
  return {sin_phi * theta.cos, sin_phi * theta.sin, south ? -cos_phi : cos_phi};
}

// Computes whole vectors, and so a few entries beyond the last in vain.
IMPINGE_VECTOR_CLONES
void fill_run(const HeightSteps::Curve& curve, DirectionRun& run) {
  constexpr int kVector = 4;
  const auto first = static_cast<double>(run.first);
  const int count = (static_cast<int>(run.count) + kVector - 1) / kVector * kVector;
  for (int k = 0; k < count; ++k) {
    const Point u = entry_direction(curve, first + static_cast<double>(k));
    const auto place = static_cast<std::size_t>(k);
    run.x[place] = u.x;
    run.y[place] = u.y;
    run.z[place] = u.z;
  }
}

// turns / (pi / 2) as a number of 26 bits and the rest.
HeightSteps::Curve curve_of(double last, double turns) {
  constexpr double kInverse = 0x1.45f306dc9c883p-2;  // 1 / pi
  constexpr double kInverseRest = -0x1.6b01ec5417056p-56;
  const double product = 2.0 * turns * kInverse;
  const double rest = std::fma(2.0 * turns, kInverse, -product) + 2.0 * turns * kInverseRest;
  const double split = product * (0x1p27 + 1.0);
  const double high = split - (split - product);
  return {last, turns - std::floor(turns), high, (product - high) + rest};
}

}  // namespace

HeightSteps::HeightSteps(std::size_t size, double slope)
    : last_(static_cast<double>(size - 1)),
      turns_(0.5 * slope),
      spacing_(2.0 * kPi / slope),
      curve_(curve_of(last_, turns_)) {}

Vec3 HeightSteps::direction(std::size_t entry) const {
  const Point u = entry_direction(curve_, static_cast<double>(entry));
  return {u.x, u.y, u.z};
}

void HeightSteps::fill(DirectionRun& run) const { fill_run(curve_, run); }

template double spiral_covering_radius(const HeightSteps&);
template double spiral_stencil_radius(const HeightSteps&);

}  // namespace impinge
