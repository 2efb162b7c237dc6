// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: every end of a segment lies on the plane, n.x = 0, and on an edge of the mesh; the section of a
// closed body is closed; that of an octahedron is the square |x| + |z| = R.
#include "23_detection_diagrams/plane_section.hpp"

#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge::lab {
namespace {

double length(const Segment& s) { return (s[1] - s[0]).norm(); }

TEST(PlaneSection, ClosedBodyGivesAClosedLine) {
  const TriangleMesh body = sphere(20.0, 2000, Vec3(3.0, -2.0, 5.0));
  const Vec3 normal(0.3, -0.5, 2.0);
  const std::vector<Segment> section = plane_section(body, normal);
  std::map<std::tuple<double, double, double>, int> ends;
  double around = 0.0;
  for (const Segment& s : section) {
    around += length(s);
    for (const Vec3& x : s) {
      EXPECT_NEAR(normal.dot(x), 0.0, 1e-13);
      ++ends[{x.x(), x.y(), x.z()}];  // bit for bit: both faces of an edge find the same point
    }
  }
  for (const auto& end : ends) EXPECT_EQ(end.second, 2);
  // A circle of radius sqrt(R^2 - h^2), h the distance of the sphere's centre from the plane.
  const double h = normal.dot(Vec3(3.0, -2.0, 5.0)) / normal.norm();
  const double circle = 2.0 * kPi * std::sqrt(20.0 * 20.0 - h * h);
  EXPECT_LT(around, circle);
  EXPECT_GT(around, 0.99 * circle);
}

// The plane y = 0 holds four corners of the octahedron.
TEST(PlaneSection, CornersOnThePlaneGiveTheSquareOnce) {
  double around = 0.0;
  for (const Segment& s : plane_section(octahedron(7.0), Vec3::UnitY())) {
    around += length(s);
    for (const Vec3& x : s) EXPECT_NEAR(std::abs(x.x()) + std::abs(x.z()), 7.0, 1e-14);
  }
  EXPECT_NEAR(around, 4.0 * std::sqrt(2.0) * 7.0, 1e-13);
}

TEST(PlaneSection, IsEmptyWhereNothingCrosses) {
  EXPECT_TRUE(plane_section(sphere(2.0, 200, Vec3(0.0, 5.0, 0.0)), Vec3::UnitY()).empty());
  EXPECT_TRUE(plane_section(sphere(2.0, 200, Vec3(0.0, -5.0, 0.0)), Vec3::UnitY()).empty());
}

}  // namespace
}  // namespace impinge::lab
