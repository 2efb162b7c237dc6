// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: every end of a segment lies on the sphere, |x| = radius, and on an edge of the mesh; the section
// of a closed body is closed; that of a cone about its axis is the polygon of its circle.
#include "mesh/sphere_section.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge {
namespace {

TEST(SphereSection, EndsLieOnTheSphereAndJoin) {
  const TriangleMesh body = sphere(20.0, 2000, Vec3(3.0, -2.0, 5.0));
  const std::vector<Segment> section = sphere_section(body, 20.0);
  ASSERT_GT(section.size(), 20U);
  std::map<std::tuple<long, long, long>, int> ends;
  for (const Segment& s : section) {
    for (const Vec3& x : s) {
      EXPECT_NEAR(x.norm(), 20.0, 1e-12);
      EXPECT_NEAR((x - Vec3(3.0, -2.0, 5.0)).norm(), 20.0, 0.1);
      ++ends[{std::lround(x.x() * 1e6), std::lround(x.y() * 1e6), std::lround(x.z() * 1e6)}];
    }
  }
  for (const auto& end : ends) EXPECT_EQ(end.second, 2);
}

// A cone with its apex at z = 30 and base corners at r = 20, z = -10: its edges cross |x| = 25 at
// (20 s, 30 - 40 s) with 400 s^2 + (30 - 40 s)^2 = 625.
TEST(SphereSection, ConeGivesItsCircle) {
  const TriangleMesh body = cone({.base_radius = 20.0, .apex_height = 30.0, .base_depth = 10.0, .sides = 64});
  const double s = (2400.0 - std::sqrt(2400.0 * 2400.0 - 4.0 * 2000.0 * 275.0)) / 4000.0;
  const std::vector<Segment> section = sphere_section(body, 25.0);
  EXPECT_EQ(section.size(), 64U);
  for (const Segment& segment : section) {
    for (const Vec3& x : segment) {
      EXPECT_NEAR(std::hypot(x.x(), x.y()), 20.0 * s, 1e-12);
      EXPECT_NEAR(x.z(), 30.0 - 40.0 * s, 1e-12);
    }
  }
}

TEST(SphereSection, IsEmptyWhereNothingCrosses) {
  EXPECT_TRUE(sphere_section(sphere(20.0, 200), 25.0).empty());
  EXPECT_TRUE(sphere_section(sphere(20.0, 200), 10.0).empty());
}

}  // namespace
}  // namespace impinge
