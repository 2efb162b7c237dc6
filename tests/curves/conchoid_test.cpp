// SPDX-License-Identifier: GPL-3.0-or-later
// r = a + b cos(phi) (thesis, Eq. 11): length (Eq. 12), area and incidence against quadrature, limits,
// refusals.
#include "curves/conchoid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "curves/conchoid_rays.hpp"
#include "curves/conchoid_surface.hpp"
#include "curves/gsl.hpp"
#include "sphere/direction.hpp"
#include "support/directions.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

// Menschik's, a circle, almost a circle, almost a cusp, the cusp.
const ConchoidShape kConchoids[] = {{},           {22.0, 0.0},         {22.0, 1e-9},
                                    {22.0, 11.0}, {20.0, 20.0 - 1e-9}, {20.0, 20.0}};
constexpr double kAngles[] = {0.0, 1e-7, 0.01, 0.7, 0.5 * kPi, 2.5, 3.14, kPi};

// sqrt(r^2 + r'^2) as Eq. 12 has it.
double speed(const ConchoidShape& s, double phi) {
  return std::hypot(s.a + s.b * std::cos(phi), s.b * std::sin(phi));
}

TEST(Conchoid, LengthIsEq12) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double phi : kAngles) {
      const double expected = integrate([&](double t) { return speed(shape, t); }, 0.0, phi);
      EXPECT_NEAR(meridian_length(shape, phi), expected, 1e-12 * expected) << shape.b << ' ' << phi;
      EXPECT_NEAR(conchoid_speed(shape, phi), speed(shape, phi), 1e-14 * shape.a);
    }
  }
}

TEST(Conchoid, LengthOfACircleAndOfTheCuspAreClosedForms) {
  for (const double phi : kAngles) {
    EXPECT_DOUBLE_EQ(meridian_length({22.0, 0.0}, phi), 22.0 * phi);
    EXPECT_DOUBLE_EQ(meridian_length({20.0, 20.0}, phi), 80.0 * std::sin(0.5 * phi));
  }
  // Continuous into the cusp: beyond its closed form a shape b = a (1 - e) adds a term of order e^2 ln(1 /
  // e).
  EXPECT_NEAR(meridian_length({20.0, 20.0 * (1.0 - 1e-12)}, kPi), 80.0, 1e-10);
}

// dA = 2 pi r sin(phi) ds.
TEST(Conchoid, AreaIsThatOfTheSweptSurface) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double phi : kAngles) {
      const auto strip = [&](double t) {
        return 2.0 * kPi * (shape.a + shape.b * std::cos(t)) * std::sin(t) * speed(shape, t);
      };
      const double expected = integrate(strip, 0.0, phi);
      EXPECT_NEAR(cap_area(shape, phi), expected, 1e-12 * expected) << shape.b << ' ' << phi;
    }
  }
}

// The closed form of the header before v0 - v was taken out, where it does not cancel.
TEST(Conchoid, AreaIsTheClosedForm) {
  const ConchoidShape s;
  const double u0 = std::pow(s.a + s.b, 2);
  const double u = s.a * s.a + s.b * s.b;
  const auto primitive = [&](double x) {
    return 0.4 * std::pow(x, 2.5) + 2.0 / 3.0 * (s.a * s.a - s.b * s.b) * std::pow(x, 1.5);
  };
  const double expected = kPi / (2.0 * s.a * s.a * s.b) * (primitive(u0) - primitive(u));
  EXPECT_NEAR(cap_area(s, 0.5 * kPi), expected, 1e-12 * expected);
  EXPECT_NEAR(expected, 6218.80, 5e-3);
}

TEST(Conchoid, InversesRoundTrip) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double share : {0.0, 1e-12, 1e-3, 0.2, 0.5, 0.9, 0.9999, 1.0}) {
      const double length = share * meridian_length(shape, kPi);
      EXPECT_NEAR(meridian_length(shape, polar_angle_at_meridian_length(shape, length)), length,
                  1e-13 * length);
      const double area = share * cap_area(shape, kPi);
      EXPECT_NEAR(cap_area(shape, polar_angle_at_cap_area(shape, area)), area, 1e-13 * area);
    }
    EXPECT_EQ(polar_angle_at_meridian_length(shape, meridian_length(shape, kPi) * (1.0 + 1e-15)), kPi);
    EXPECT_EQ(polar_angle_at_cap_area(shape, cap_area(shape, kPi) * (1.0 + 1e-15)), kPi);
  }
}

// The normal turned out of the direction by psi: of the surface x(phi), n.u = cos psi.
TEST(Conchoid, IncidenceIsTheAngleOfTheNormal) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double phi : {0.0, 0.3, 1.0, 0.5 * kPi, 2.0, 3.0}) {
      const double r = shape.a + shape.b * std::cos(phi);
      const double slope = -shape.b * std::sin(phi);
      const double tangent_x = slope * std::sin(phi) + r * std::cos(phi);
      const double tangent_z = slope * std::cos(phi) - r * std::sin(phi);
      const double along = std::abs(tangent_x * std::sin(phi) + tangent_z * std::cos(phi));
      EXPECT_NEAR(std::sin(conchoid_incidence(shape, phi)), along / std::hypot(tangent_x, tangent_z), 1e-12);
    }
  }
  EXPECT_EQ(conchoid_incidence({20.0, 20.0}, kPi), 0.5 * kPi);
  EXPECT_NEAR(conchoid_incidence({}, 0.5 * kPi), std::atan(17.843 / 20.501), 1e-15);
}

// dA / dOmega with dOmega = 2 pi sin(phi) dphi, by differences.
TEST(Conchoid, AreaPerSolidAngle) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double phi : {0.3, 1.0, 0.5 * kPi, 2.0}) {
      const double h = 1e-4;
      const double area = cap_area(shape, phi + h) - cap_area(shape, phi - h);
      const double solid_angle = 2.0 * kPi * (std::cos(phi - h) - std::cos(phi + h));
      EXPECT_NEAR(area_per_solid_angle(shape, phi), area / solid_angle, 1e-6 * area / solid_angle);
    }
  }
}

TEST(Conchoid, NothingIsNotANumber) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double phi : kAngles) {
      for (const auto value : {conchoid_radius(shape, phi), meridian_length(shape, phi), cap_area(shape, phi),
                               conchoid_incidence(shape, phi), area_per_solid_angle(shape, phi)}) {
        EXPECT_TRUE(std::isfinite(value) && value >= 0.0) << shape.a << ' ' << shape.b << ' ' << phi;
      }
    }
  }
}

TEST(Conchoid, RefusesALoopAndSaysWhy) {
  const std::string said = test::thrown<std::invalid_argument>([] {
    static_cast<void>(meridian_length({17.843, 20.501}, 1.0));
  });
  EXPECT_NE(said.find("a < b"), std::string::npos) << said;
  EXPECT_NE(said.find("choose a >= b"), std::string::npos) << said;
}

TEST(Conchoid, RefusesWhatIsNoShapeAndNoPlaceOnIt) {
  for (const ConchoidShape& shape : {ConchoidShape{0.0, 0.0},
                                     {-1.0, -2.0},
                                     {20.0, -1.0},
                                     {std::nan(""), 1.0},
                                     {20.0, std::nan("")},
                                     {HUGE_VAL, 1.0}}) {
    EXPECT_THROW(cap_area(shape, 1.0), std::invalid_argument);
    EXPECT_THROW(conchoid_radius(shape, 1.0), std::invalid_argument);
    EXPECT_THROW(polar_angle_at_cap_area(shape, 1.0), std::invalid_argument);
  }
  for (const double phi : {-1e-9, 3.2, std::nan("")}) {
    EXPECT_THROW(conchoid_radius({}, phi), std::invalid_argument);
    EXPECT_THROW(meridian_length({}, phi), std::invalid_argument);
    EXPECT_THROW(cap_area({}, phi), std::invalid_argument);
    EXPECT_THROW(conchoid_incidence({}, phi), std::invalid_argument);
  }
  for (const double beyond : {-1.0, 1e5, std::nan("")}) {
    EXPECT_THROW(polar_angle_at_meridian_length({}, beyond), std::invalid_argument);
    EXPECT_THROW(polar_angle_at_cap_area({}, beyond), std::invalid_argument);
  }
}

// Points on the rotated conchoid and the area that each stands for.

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
