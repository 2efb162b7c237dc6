// SPDX-License-Identifier: GPL-3.0-or-later
// Points on the rotated conchoid and the area that each stands for.
#include "curves/conchoid_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/conchoid_rays.hpp"
#include "curves/nearest_point.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

constexpr double kRim = 0.5 * kPi;
const ConchoidShape kShapes[] = {{}, {22.0, 0.0}, {20.0, 20.0}};

TEST(NearestPoint, IsThatOfBruteForce) {
  std::vector<Vec3> points = test::random_directions(500, 1);
  points.push_back(points[7]);  // of two in one place the first
  for (const double side : {0.1, 0.7, 5.0}) {
    const NearestPoint nearest(points, side);
    for (Vec3 x : test::random_directions(300, 2)) {
      x *= 1.3 * std::abs(x.x());  // inside and outside of the box of the points
      std::size_t expected = 0;
      for (std::size_t i = 1; i < points.size(); ++i) {
        if ((points[i] - x).squaredNorm() < (points[expected] - x).squaredNorm()) expected = i;
      }
      ASSERT_EQ(nearest(x), expected);
    }
    EXPECT_EQ(nearest(points[7]), 7U);
  }
}

TEST(NearestPoint, RefusesNoPointsAndNoSide) {
  const std::vector<Vec3> points = test::random_directions(10, 3);
  EXPECT_THROW(NearestPoint({}, 1.0), std::invalid_argument);
  for (const double side : {0.0, -1.0, 1e-9, std::nan("")}) {
    EXPECT_THROW(NearestPoint(points, side), std::invalid_argument);
  }
}

// A(phi) between consecutive points of the spiral is A / count: the surface is cut into equal bands.
TEST(ConchoidSpiral, PointsStandForEqualAreas) {
  for (const ConchoidShape& shape : kShapes) {
    const auto points = conchoid_spiral(shape, 800);
    const double each = cap_area(shape, kRim) / 800.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto [phi, theta] = to_angles(points[i]);
      EXPECT_NEAR(cap_area(shape, phi), (static_cast<double>(i) + 0.5) * each, 1e-9);
      EXPECT_NEAR(points[i].norm(), conchoid_radius(shape, phi), 1e-12);
    }
  }
}

// With b = 0 it is the sphere's: cos(phi_i) = 1 - (i + 1/2) / n, theta = sqrt(2 pi n) phi.
TEST(ConchoidSpiral, OfACircleIsTheSphericalOne) {
  const auto points = conchoid_spiral({22.0, 0.0}, 500);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double phi = std::acos(1.0 - (static_cast<double>(i) + 0.5) / 500.0);
    const Vec3 expected = 22.0 * to_direction({phi, std::sqrt(2.0 * kPi * 500.0) * phi});
    ASSERT_LT((points[i] - expected).norm(), 1e-9);
  }
}

TEST(NearestAreas, SumToTheCap) {
  for (const ConchoidShape& shape : kShapes) {
    const auto points = conchoid_spiral(shape, 300);
    const auto areas = nearest_areas(shape, points, 50);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), cap_area(shape, kRim), 1e-9);
  }
}

// Away from apex and rim a ring's points share the band between the middles to the next rings.
TEST(NearestAreas, OfRingsAreThoseOfTheirBands) {
  const ConchoidShape shape;
  const auto phi = original_angles(13);
  const auto areas = nearest_areas(shape, conchoid_rings(shape, phi, 48), 256);
  for (std::size_t ring = 4; ring < 12; ++ring) {
    const double band = cap_area(shape, 0.5 * (phi[ring] + phi[ring + 1])) -
                        cap_area(shape, 0.5 * (phi[ring] + phi[ring - 1]));
    for (std::size_t i = 0; i < 48; ++i) EXPECT_NEAR(areas[48 * ring + i], band / 48.0, 0.1 * band / 48.0);
  }
  for (std::size_t i = 1; i < 48; ++i) EXPECT_EQ(areas[i], areas[0]) << "the apex is shared";
}

// What the spiral is for: on the surface its points stand for nearly one area, rings at equal theta do not.
TEST(NearestAreas, OfTheSpiralAreNearlyEqual) {
  const ConchoidShape shape;
  const auto points = conchoid_spiral(shape, 600);
  const auto areas = nearest_areas(shape, points, 100);
  const double mean = cap_area(shape, kRim) / 600.0;
  for (std::size_t i = 20; i < 540; ++i) EXPECT_NEAR(areas[i], mean, 0.12 * mean) << i;
}

// The bands hold every point but those at the rim, and their means those of nearest_areas().
TEST(AreaBands, AreThoseOfTheirPoints) {
  const ConchoidShape shape;
  const auto points = conchoid_rings(shape, original_angles(10), 30);
  const auto areas = nearest_areas(shape, points, 100);
  const auto bands = area_bands(shape, points, {100, 3});
  ASSERT_EQ(bands.size(), 3U);
  for (std::size_t band = 0; band < 3; ++band) {  // rings at 0, 10, 20; 30, 40, 50; 60, 70, 80 degrees
    EXPECT_EQ(bands[band].points, 90U);
    const auto from = areas.begin() + static_cast<std::ptrdiff_t>(90 * band);
    EXPECT_EQ(bands[band].smallest, *std::min_element(from, from + 90));
    EXPECT_EQ(bands[band].largest, *std::max_element(from, from + 90));
    EXPECT_NEAR(bands[band].mean, std::accumulate(from, from + 90, 0.0) / 90.0, 1e-12);
  }
  EXPECT_THROW(area_bands(shape, points, {100, 0}), std::invalid_argument);
}

TEST(ConchoidSurface, RefusesNothing) {
  EXPECT_THROW(conchoid_spiral({}, 0), std::invalid_argument);
  EXPECT_THROW(nearest_areas({}, {}, 10), std::invalid_argument);
  const auto one = conchoid_spiral({}, 1);
  EXPECT_THROW(nearest_areas({}, one, 0), std::invalid_argument);
  EXPECT_NEAR(nearest_areas({}, one, 10).front(), cap_area({}, kRim), 1e-9);
  EXPECT_TRUE(conchoid_rings({}, {}, 5).empty());
}

}  // namespace
}  // namespace impinge
