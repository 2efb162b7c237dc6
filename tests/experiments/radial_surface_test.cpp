// SPDX-License-Identifier: GPL-3.0-or-later
// |grad r| = r tan psi on the unit sphere, and the radius lies on the surface.
#include "04_sampling_error/radial_surface.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "table/probe_directions.hpp"

namespace impinge::lab {
namespace {

const Vec3 kAxis = Vec3(0.48, 0.6, 0.64);
constexpr ConchoidShape kHip{20.501, 17.843};  // mm (thesis, Section 5.1.2)

// Length of the gradient of r by central differences.
double gradient(const RadialSurface& surface, const Vec3& u) {
  constexpr double h = 1e-5;
  const Vec3 east = u.unitOrthogonal();
  const Vec3 north = u.cross(east);
  const auto along = [&](const Vec3& t) {
    const Vec3 ahead = (u + h * t).normalized();
    const Vec3 behind = (u - h * t).normalized();
    return (surface.radius(ahead) - surface.radius(behind)) / (2.0 * std::atan(h));
  };
  return std::hypot(along(east), along(north));
}

TEST(RadialSurface, SlopeIsTheGradient) {
  EdgeShape edge;
  edge.axis = kAxis;
  edge.edge = kAxis.unitOrthogonal();
  edge.dihedral_deg = 20.0;
  edge.tilt_deg = 25.0;
  for (const RadialSurface& surface :
       {spherical_surface("sphere", 22.0, 5.0 * kAxis), conchoid_surface("conchoid", kHip, kAxis),
        planar_surface("plane", kAxis, 22.0, 75.0), edge_surface("edge", edge).surface}) {
    std::size_t tried = 0;
    for (const Vec3& u : uniform_directions(2000, 41)) {
      if (!surface.covers(u)) continue;
      if (surface.name == "edge" && std::abs(u.dot(kAxis.cross(edge.edge))) < 1e-3) continue;  // its kink
      const double expected = surface.radius(u) * surface.slope(u);
      ASSERT_NEAR(gradient(surface, u), expected, 1e-6 * (1.0 + expected)) << surface.name;
      ++tried;
    }
    EXPECT_GT(tried, 100U) << surface.name;
  }
}

TEST(RadialSurface, PointsLieOnTheSurface) {
  const Vec3 centre(1.0, -2.0, 4.0);
  const auto sphere = spherical_surface("sphere", 22.0, centre);
  const auto plane = planar_surface("plane", kAxis, 20.0, 75.0);
  for (const Vec3& u : uniform_directions(200, 42)) {
    EXPECT_NEAR((sphere.radius(u) * u - centre).norm(), 22.0, 1e-12);
    if (plane.covers(u)) {
      EXPECT_NEAR(plane.radius(u) * u.dot(kAxis), 20.0, 1e-11);
    }
  }
  const auto conchoid = conchoid_surface("conchoid", kHip, kAxis);
  EXPECT_DOUBLE_EQ(conchoid.radius(kAxis), 20.501 + 17.843);
  EXPECT_NEAR(conchoid.radius(kAxis.unitOrthogonal()), 20.501, 1e-14);
  // The steepest place of the thesis' part: tan psi = b / a, 41 degrees.
  EXPECT_NEAR(std::atan(conchoid.slope(kAxis.unitOrthogonal())) / kDegree, 41.03, 0.01);
}

// The nearer plane counts, the edge is at the given radius, and the slope jumps by r^2 |q1 - q2|.
TEST(RadialSurface, EdgeIsConvexAndHasItsKink) {
  EdgeShape shape;
  shape.axis = kAxis;
  shape.edge = kAxis.unitOrthogonal();
  shape.dihedral_deg = 3.0;
  shape.tilt_deg = 40.0;
  const EdgeSurface edge = edge_surface("edge", shape);
  EXPECT_NEAR(edge.surface.radius(kAxis), shape.radius, 1e-12);
  EXPECT_NEAR(angle_between(edge.inverse_1, edge.inverse_2), 3.0 * kDegree, 1e-12);
  const Vec3 across = kAxis.cross(shape.edge);
  constexpr double h = 1e-6;
  const auto slope = [&](double from, double to) {
    const auto at = [&](double s) {
      return edge.surface.radius((std::cos(s) * kAxis + std::sin(s) * across).normalized());
    };
    return (at(to) - at(from)) / (to - from);
  };
  const double kink = shape.radius * shape.radius * (edge.inverse_1 - edge.inverse_2).norm();
  EXPECT_NEAR(slope(-2.0 * h, -h) - slope(h, 2.0 * h), kink, 1e-3);
  EXPECT_GT(kink, shape.radius * 3.0 * kDegree);
  for (const Vec3& u : directions_along(shape, 0.01, 500)) {
    ASSERT_LE(std::abs(u.dot(across)), 0.01);
    ASSERT_TRUE(edge.surface.covers(u));
    ASSERT_NEAR(edge.surface.radius(u), std::min(1.0 / edge.inverse_1.dot(u), 1.0 / edge.inverse_2.dot(u)),
                1e-12);
  }
}

TEST(RadialSurface, RefusesShapesThatAreNone) {
  EXPECT_THROW(spherical_surface("", 5.0, {0.0, 0.0, 5.0}), std::invalid_argument);
  EXPECT_THROW(conchoid_surface("", {10.0, 10.0}, kAxis), std::invalid_argument);
  EXPECT_THROW(conchoid_surface("", {10.0, std::nan("")}, kAxis), std::invalid_argument);
  EXPECT_THROW(planar_surface("", kAxis, 0.0, 75.0), std::invalid_argument);
  EXPECT_THROW(planar_surface("", kAxis, 22.0, 90.0), std::invalid_argument);
  EdgeShape edge;
  edge.tilt_deg = 70.0;
  EXPECT_THROW(edge_surface("", edge), std::invalid_argument);
}

}  // namespace
}  // namespace impinge::lab
