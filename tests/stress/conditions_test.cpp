// SPDX-License-Identifier: GPL-3.0-or-later
// d ln r / d angle = tan psi; condition = 1 + tan psi.
#include "stress/conditions.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "reference/exact_radius.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"

namespace impinge::lab {
namespace {

TEST(Conditions, ASlopeIsTheDerivativeOfTheRadius) {
  const TriangleMesh mesh = octahedron(20.0);
  const Vec3 n = Vec3(1.0, 1.0, 1.0).normalized();
  for (const Vec3& any : test::random_directions(50, 9)) {
    const Vec3 u = any.cwiseAbs().normalized();         // on the face x + y + z = 20
    const Vec3 down = (n.dot(u) * u - n).normalized();  // where the radius grows fastest
    constexpr double kStep = 1e-5;
    const std::vector<Vec3> ends{u - kStep * down, u + kStep * down};
    const std::vector<double> r = exact_radii(mesh, {ends, Layer::nearest, {}});
    const double derivative = std::log(r[1] / r[0]) / (2.0 * kStep);
    EXPECT_NEAR(conditions_along(mesh, {&u, 1})[0].slope, derivative, 1e-4 * (1.0 + derivative * derivative));
    EXPECT_NEAR(conditions_along(mesh, {&u, 1})[0].slope, std::tan(angle_between(u, n)), 1e-12);
  }
}

TEST(Conditions, AtAnEdgeTheSteeperFaceCounts) {
  // The edge from x to y is in the faces z > 0, at atan(sqrt(1/2)), and z < 0, which is steeper here.
  const TriangleMesh mesh{{{20, 0, 0}, {0, 20, 0}, {0, 0, 20}, {1, 1, -1}}, {{0, 1, 2}, {1, 0, 3}}};
  const Vec3 u = Vec3(1.0, 1.0, 0.0).normalized();
  const Vec3 n = (mesh.vertices[3] - mesh.vertices[0]).cross(mesh.vertices[3] - mesh.vertices[1]);
  EXPECT_NEAR(conditions_along(mesh, {&u, 1})[0].slope, std::abs(n.cross(u).norm() / n.dot(u)), 1e-9);
  EXPECT_EQ(conditions_along(mesh, std::vector<Vec3>{{-1.0, 0.0, 0.0}})[0].slope, 0.0) << "no face";
}

TEST(Conditions, AScenesStiffnessIsThatOfItsSteepestFace) {
  TriangleMesh mesh = sphere(20.0, 500, {2.0, 0.0, 0.0});
  EXPECT_LT(stiffness(mesh), 10.0);
  test::add_face(mesh, {10.0, 0.0, 1e-6}, {12.0, 1.0, 1e-6}, {12.0, -1.0, 1e-6});
  EXPECT_GT(stiffness(mesh), 1e6);
}

}  // namespace
}  // namespace impinge::lab
