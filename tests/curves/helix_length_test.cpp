// SPDX-License-Identifier: GPL-3.0-or-later
// L(phi) = integral_0^phi sqrt(1 + 4 k^2 sin^2 t) dt against quadrature, chords and its asymptote; T of
// Eq. 10.
#include "curves/helix_length.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/quadrature.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

constexpr double kTurns[] = {2.0, 2.5, 10.0, 229.0, 458.0, 2292.0, 4584.0, 1e5};

double quadrature(double k, double from, double to) {
  return integrate([k](double t) { return std::hypot(1.0, 2.0 * k * std::sin(t)); }, from, to);
}

// In pieces that shrink towards both poles, where the speed falls to 1 within an angle of 1 / k.
TEST(HelixLength, IsTheIntegralOfTheSpeed) {
  for (const double k : kTurns) {
    double expected = 0.0;
    double from = 0.0;
    for (const double phi : {1e-8, 1e-5, 1e-3, 0.1, 1.0, 0.5 * kPi, 1.6, 3.0, 3.14, kPi - 1e-5, kPi}) {
      expected += quadrature(k, from, phi);
      from = phi;
      EXPECT_NEAR(helix_length(k, phi), expected, 1e-13 * expected) << k << ' ' << phi;
    }
  }
}

// The length of the polygon through many points of the curve approaches that of the curve from below.
TEST(HelixLength, IsTheLengthOfTheCurve) {
  const auto point = [](double phi) { return to_direction({phi, 2.0 * 10.0 * phi}); };
  const int parts = 200000;
  double length = 0.0;
  for (int i = 0; i < parts; ++i) length += (point(kPi * (i + 1) / parts) - point(kPi * i / parts)).norm();
  EXPECT_NEAR(helix_total_length(10.0), length, 1e-6);
  EXPECT_GT(helix_total_length(10.0), length);
}

TEST(HelixLength, TotalIsNot4kPlus1) {
  EXPECT_NEAR(helix_total_length(229.0), 916.0175, 5e-5);
  EXPECT_EQ(total_travelled_distance(229.0), 917.0);
}

TEST(HelixLength, ApproachesItsAsymptote) {
  for (const double k : kTurns) {
    const double rest = helix_total_length(k) - helix_total_length_asymptote(k);
    const double rounding = 1e-15 * 4.0 * k;
    EXPECT_LT(std::abs(rest), (1.0 + std::log(8.0 * k)) / (32.0 * k * k * k) + rounding) << k;
  }
}

TEST(HelixLength, NorthMirrorsSouth) {
  for (const double k : kTurns) {
    for (const double phi : {0.0, 1e-6, 0.3, 1.2, 0.5 * kPi}) {
      EXPECT_NEAR(helix_length(k, phi) + helix_length(k, kPi - phi), helix_total_length(k), 4e-15 * 4.0 * k);
    }
  }
}

TEST(HelixLength, InverseRoundTripsAtBothPolesToo) {
  for (const double k : kTurns) {
    const double total = helix_total_length(k);
    for (const double share : {0.0, 1e-14, 1e-9, 0.001, 0.3, 0.5, 0.7, 1.0 - 1e-9, 1.0}) {
      const double phi = polar_angle_at_length(k, share * total);
      EXPECT_NEAR(helix_length(k, phi), share * total, 1e-13 * total * std::min(share + 1e-3, 1.0)) << k;
    }
    for (const double phi : {1e-12, 1e-6, 0.2, 1.5, 1.7}) {
      EXPECT_NEAR(polar_angle_at_length(k, helix_length(k, phi)), phi, 2e-13 * phi) << k;
    }
    EXPECT_EQ(polar_angle_at_length(k, 0.0), 0.0);
    EXPECT_EQ(polar_angle_at_length(k, total), kPi);
    EXPECT_EQ(polar_angle_at_length(k, total * (1.0 + 1e-15)), kPi);
  }
}

// T = (4 k + 1) (1 - cos phi) / 2.
TEST(TravelledDistance, IsEq10AndHasAnInverse) {
  for (const double k : kTurns) {
    for (const double phi : {0.0, 0.3, 1.2, 0.5 * kPi, 2.0, kPi}) {
      const double t = travelled_distance(k, phi);
      EXPECT_NEAR(t, (4.0 * k + 1.0) * (1.0 - std::cos(phi)) / 2.0, 1e-15 * (4.0 * k + 1.0));
      EXPECT_NEAR(polar_angle_at_travelled_distance(k, t), phi, 1e-14);
    }
    EXPECT_EQ(travelled_distance(k, kPi), total_travelled_distance(k));
  }
}

TEST(HelixLength, RefusesWhatIsNoHelixAndNoPlaceOnIt) {
  for (const double k : {1.999, 0.0, -5.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(helix_length(k, 1.0), std::invalid_argument);
    EXPECT_THROW(helix_total_length(k), std::invalid_argument);
    EXPECT_THROW(helix_total_length_asymptote(k), std::invalid_argument);
    EXPECT_THROW(travelled_distance(k, 1.0), std::invalid_argument);
    EXPECT_THROW(polar_angle_at_length(k, 1.0), std::invalid_argument);
    EXPECT_THROW(polar_angle_at_travelled_distance(k, 1.0), std::invalid_argument);
  }
  for (const double phi : {-1e-9, 3.2, std::nan("")}) {
    EXPECT_THROW(helix_length(10.0, phi), std::invalid_argument);
    EXPECT_THROW(travelled_distance(10.0, phi), std::invalid_argument);
  }
  for (const double length : {-0.1, 41.1, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(polar_angle_at_length(10.0, length), std::invalid_argument);
    EXPECT_THROW(polar_angle_at_travelled_distance(10.0, length), std::invalid_argument);
  }
}

}  // namespace
}  // namespace impinge
