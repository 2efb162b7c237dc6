// SPDX-License-Identifier: GPL-3.0-or-later
// Segments between rays at equal angles from points of the axis (thesis, Figure 53).
#include "curves/conchoid_spacing.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/conchoid_origins.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

const ConchoidShape kCircle{22.0, 0.0};

TEST(ConchoidSpacing, FromTheConchoidsOriginIsTheSpeed) {
  for (const double phi : {0.0, 0.4, 1.0, 0.5 * kPi}) {
    EXPECT_NEAR(spacing_rate({}, 0.0, phi), conchoid_speed({}, phi), 1e-12);
    EXPECT_NEAR(ray_angle({}, 0.0, phi), phi, 1e-15);
  }
}

TEST(ConchoidSpacing, OfACircleAboutItsCentreIsEven) {
  for (const double length : segment_lengths(kCircle, 0.0, 31)) EXPECT_NEAR(length, 11.0 * kPi / 30.0, 1e-12);
}

// A chord through a point off the centre: the rate is distance^2 / distance of the tangent from the point.
TEST(ConchoidSpacing, OfACircleAboutAPointOffItsCentre) {
  for (const double phi : {0.0, 0.4, 1.0, 0.5 * kPi}) {
    const double square = 22.0 * 22.0 + 25.0 - 2.0 * 22.0 * 5.0 * std::cos(phi);
    EXPECT_NEAR(spacing_rate(kCircle, 5.0, phi), square / (22.0 - 5.0 * std::cos(phi)), 1e-12);
  }
}

TEST(ConchoidSpacing, RateIsTheLimitOfSegments) {
  const double h = 1e-5;
  for (const double height : {0.0, 12.0, 19.0, 37.0}) {
    for (const double phi : {0.2, 0.9, 1.5}) {
      const double arc = meridian_length({}, phi + h) - meridian_length({}, phi - h);
      const double angle = ray_angle({}, height, phi + h) - ray_angle({}, height, phi - h);
      EXPECT_NEAR(spacing_rate({}, height, phi), arc / angle, 1e-6 * arc / angle);
    }
  }
}

TEST(ConchoidSpacing, CutsAreAtEqualAnglesAndSegmentsMakeTheArc) {
  for (const SamplingOrigin& at : sampling_origins({})) {
    const auto cuts = ray_cuts({}, at.height, 10);
    const double end = ray_angle({}, at.height, 0.5 * kPi);
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_NEAR(ray_angle({}, at.height, cuts[i]), end * static_cast<double>(i) / 9.0, 1e-13) << at.name;
    }
    const auto lengths = segment_lengths({}, at.height, 10);
    EXPECT_NEAR(std::accumulate(lengths.begin(), lengths.end(), 0.0), meridian_length({}, 0.5 * kPi), 1e-11);
  }
}

TEST(ConchoidSpacing, RefusesOriginsOutsideAndTooFewRays) {
  for (const double height : {-1.0, 38.344, 50.0, std::nan("")}) {
    EXPECT_THROW(spacing_rate({}, height, 1.0), std::invalid_argument);
    EXPECT_THROW(ray_cuts({}, height, 5), std::invalid_argument);
  }
  EXPECT_THROW(ray_cuts({}, 1.0, 0), std::invalid_argument);
  EXPECT_THROW(segment_lengths({}, 1.0, 1), std::invalid_argument);
  EXPECT_EQ(segment_lengths({}, 1.0, 2).size(), 1U);
}

}  // namespace
}  // namespace impinge
