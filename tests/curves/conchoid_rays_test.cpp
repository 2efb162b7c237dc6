// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. 14-16 of the thesis and the exact angles: each cuts what it should into equal parts.
#include "curves/conchoid_rays.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/conchoid_rays.hpp"
#include "curves/conchoid_surface.hpp"
#include "hip/sphere_fit.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

TEST(ConchoidRays, OriginalOnesAreEquallyFarApart) {
  const auto phi = original_angles(4);
  ASSERT_EQ(phi.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(phi[i], 30.0 * static_cast<double>(i) * kDegree);
  EXPECT_EQ(original_angles(901).back(), 0.5 * kPi);
}

// Eq. 16 for 91 rays: phi_i = 2 asin(0.00785 i), whose last digit is rounded.
TEST(ConchoidRays, ThesisFormIsEq16) {
  const auto phi = adjusted_angles(thesis_closed_form(), 91);
  for (std::size_t i = 0; i < 91; ++i) {
    EXPECT_NEAR(std::sin(0.5 * phi[i]), 0.00785 * static_cast<double>(i), 5e-6 * static_cast<double>(i));
  }
}

// The closed form cuts its own length equally: p(phi_i) = i p(90 degrees) / (n - 1), for any shape.
TEST(ConchoidRays, ClosedFormCutsItsOwnLengthEqually) {
  for (const ConchoidShape& shape : {ConchoidShape{}, {22.0, 1.0}, {20.0, 20.0}}) {
    const auto phi = adjusted_angles(closed_form(shape), 31);
    for (std::size_t i = 0; i < 31; ++i) {
      EXPECT_NEAR(closed_form_length(shape, phi[i]),
                  static_cast<double>(i) / 30.0 * closed_form_length(shape, 0.5 * kPi), 1e-12);
    }
    EXPECT_DOUBLE_EQ(phi.back(), 0.5 * kPi);
  }
}

// The thesis' 4.29 and 3.03 are the form of a = 1.15 b, rounded.
TEST(ConchoidRays, ThesisFormIsTheRoundedOne) {
  const ConchoidClosedForm form = closed_form({1.15, 1.0});
  EXPECT_NEAR(form.factor, thesis_closed_form().factor, 5e-3);
  EXPECT_NEAR(form.quarter, thesis_closed_form().quarter, 5e-3);
}

// At the cusp the closed form is no approximation: a^2 + b^2 is 2 a b.
TEST(ConchoidRays, ClosedFormIsExactAtTheCusp) {
  const ConchoidShape cusp{20.0, 20.0};
  const auto closed = adjusted_angles(closed_form(cusp), 19);
  const auto exact = equal_arc_angles(cusp, 19);
  for (std::size_t i = 0; i < 19; ++i) EXPECT_NEAR(closed[i], exact[i], 1e-14);
}

TEST(ConchoidRays, ExactOnesCutTheArcEqually) {
  for (const ConchoidShape& shape : {ConchoidShape{}, {22.0, 0.0}, {22.0, 1.0}, {20.0, 20.0}}) {
    for (const std::size_t rays : {2UL, 4UL, 91UL}) {
      const auto phi = equal_arc_angles(shape, rays);
      const double part = meridian_length(shape, 0.5 * kPi) / static_cast<double>(rays - 1);
      for (std::size_t i = 0; i + 1 < rays; ++i) {
        EXPECT_NEAR(meridian_length(shape, phi[i + 1]) - meridian_length(shape, phi[i]), part, 1e-12);
      }
      EXPECT_EQ(phi.front(), 0.0);
      EXPECT_EQ(phi.back(), 0.5 * kPi);
    }
  }
}

TEST(ConchoidRays, ACircleNeedsNoAdjustment) {
  const auto exact = equal_arc_angles({22.0, 0.0}, 91);
  const auto original = original_angles(91);
  for (std::size_t i = 0; i < 91; ++i) EXPECT_NEAR(exact[i], original[i], 1e-14);
}

TEST(ConchoidRays, AnArgumentPast1ByRoundingIsTheEnd) {
  EXPECT_EQ(adjusted_angles({1.0, 1.0 + 4e-16}, 7).back(), kPi);
  EXPECT_THROW(adjusted_angles({1.0, 1.001}, 7), std::invalid_argument);
}

TEST(ConchoidRays, RefusesTooFewRaysAndNoForm) {
  for (const std::size_t rays : {0UL, 1UL}) {
    EXPECT_THROW(original_angles(rays), std::invalid_argument);
    EXPECT_THROW(adjusted_angles(thesis_closed_form(), rays), std::invalid_argument);
    EXPECT_THROW(equal_arc_angles({}, rays), std::invalid_argument);
  }
  EXPECT_THROW(closed_form({22.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(equal_arc_angles({17.0, 20.0}, 4), std::invalid_argument);
  for (const ConchoidClosedForm& none : {ConchoidClosedForm{0.0, 0.0}, {-1.0, -1.0}, {std::nan(""), 1.0}}) {
    EXPECT_THROW(adjusted_angles(none, 4), std::invalid_argument);
  }
}

// Segments between rays at equal angles from points of the axis (thesis, Figure 53).

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

// Centres of a conchoid's cap: of a circle in closed form, the best sphere against a fit of points.

const ConchoidShape kRound{22.0, 0.0};

// Of a circle every whole-curve centre is the circle's; of the half circle r / 2 and 2 r / pi are known.
TEST(ConchoidOrigins, CentresOfACircle) {
  for (const SamplingOrigin& at : sampling_origins(kRound)) {
    double expected = 0.0;
    if (at.name == "cap_extent_middle" || at.name == "cap_surface_centroid") expected = 11.0;
    if (at.name == "cap_curve_centroid") expected = 44.0 / kPi;
    EXPECT_NEAR(at.height, expected, 1e-9) << at.name;
  }
  EXPECT_GE(sampling_origins(kRound).size(), 4U);
  EXPECT_EQ(sampling_origins({}).size(), 9U);
}

// Against the fit of points that stand for equal areas.
TEST(ConchoidOrigins, BestSphereIsThatOfTheSurface) {
  const auto points = conchoid_spiral({}, 20000);
  const SphereFit expected = fit_sphere(points);
  const AxialSphere sphere = fit_axial_sphere({});
  EXPECT_NEAR(sphere.height, expected.centre.z(), 1e-3);
  EXPECT_NEAR(sphere.radius, expected.radius, 1e-3);
  double lowest = 0.0;
  double highest = 0.0;
  for (const Vec3& p : points) {
    const double residual = (p - expected.centre).norm() - expected.radius;
    lowest = std::min(lowest, residual);
    highest = std::max(highest, residual);
  }
  EXPECT_NEAR(sphere.lowest_residual, lowest, 5e-3);
  EXPECT_NEAR(sphere.highest_residual, highest, 5e-3);
}

TEST(ConchoidOrigins, RefusesWhatIsNoShape) {
  EXPECT_THROW(sampling_origins({1.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(fit_axial_sphere({0.0, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
