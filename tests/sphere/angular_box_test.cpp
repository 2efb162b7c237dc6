// SPDX-License-Identifier: GPL-3.0-or-later
// A box holds every direction of its triangle, bulge of the great circles and poles included.
#include "sphere/angular_box.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/directions.hpp"

namespace impinge {
namespace {

bool holds(const AngularBox& box, const Vec3& x) {
  const auto [phi, theta] = to_angles(x);
  if (phi < box.phi_min || phi > box.phi_max) return false;
  if (phi == 0.0 || phi == kPi) return true;
  const double from_left = std::fmod(theta - box.theta_min + 8.0 * kPi, 2.0 * kPi);
  return from_left <= box.theta_width || from_left >= 2.0 * kPi - 1e-12;
}

// Points of the triangle on a grid of 20 by 20 barycentric steps, edges and corners included.
void expect_inside(const std::array<Vec3, 3>& t, double margin) {
  const AngularBox box = angular_box(t, margin);
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; i + j <= 20; ++j) {
      const Vec3 x = t[0] + (t[1] - t[0]) * (i / 20.0) + (t[2] - t[0]) * (j / 20.0);
      ASSERT_TRUE(holds(box, x)) << t[0].transpose() << " | " << t[1].transpose() << " | "
                                 << t[2].transpose();
    }
  }
}

TEST(AngularBox, HoldsRandomTrianglesOfAllSizes) {
  const auto u = test::random_directions(3000, 5);
  for (std::size_t k = 0; k + 2 < u.size(); k += 3) {
    for (const double size : {1e-6, 1e-2, 0.3, 3.0}) {
      expect_inside({u[k], (u[k] + size * u[k + 1]).normalized(), (u[k] + size * u[k + 2]).normalized()},
                    0.0);
    }
  }
}

TEST(AngularBox, HoldsTrianglesAtThePolesAndTheSeam) {
  for (const double z : {1.0, -1.0}) {
    expect_inside({Vec3(0, 0, z), {0.1, 0, z}, {0, 0.1, z}}, 0.0);           // pole a corner
    expect_inside({Vec3(-0.1, 0, z), {0.1, 0, z}, {0, 0.1, z}}, 0.0);        // pole on an edge
    expect_inside({Vec3(-0.1, -0.1, z), {0.1, -0.1, z}, {0, 0.1, z}}, 0.0);  // pole inside
    expect_inside({Vec3(1e-9, 0, z), {0.1, -0.1, z}, {0.1, 0.1, z}}, 0.0);   // pole just outside
  }
  expect_inside({Vec3(1, -0.1, 0), {1, 0.1, 0}, {1, 0, 0.1}}, 0.0);  // across theta = 0
  expect_inside({Vec3(1, 0, 0), {1, 0.1, 0}, {1, 0, 0.1}}, 0.0);     // along it
}

TEST(AngularBox, PoleOfAnotherHemisphereIsNotTakenIn) {
  const AngularBox north = angular_box({Vec3(-0.1, -0.1, 1), {0.1, -0.1, 1}, {0, 0.1, 1}});
  EXPECT_EQ(north.phi_min, 0.0);
  EXPECT_LT(north.phi_max, 0.2);
}

// Every direction within the margin of the triangle is in the box.
TEST(AngularBox, MarginIsAnAngleOnTheSphere) {
  const auto u = test::random_directions(2000, 6);
  for (std::size_t k = 0; k + 3 < u.size(); k += 4) {
    const std::array<Vec3, 3> t{u[k], (u[k] + 0.1 * u[k + 1]).normalized(),
                                (u[k] + 0.1 * u[k + 2]).normalized()};
    for (const double margin : {0.001, 0.05}) {
      const AngularBox box = angular_box(t, margin);
      const Vec3 aside = u[k + 3].cross(t[1]).normalized();
      ASSERT_TRUE(holds(box, std::cos(0.999 * margin) * t[1] + std::sin(0.999 * margin) * aside));
    }
  }
}

}  // namespace
}  // namespace impinge
