// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter of each family is what its shape really has.
#include "stress/shapes.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/validation.hpp"
#include "reference/exact_radius.hpp"
#include "stress/aimed_faces.hpp"
#include "stress/conditions.hpp"
#include "stress/methods.hpp"
#include "support/directions.hpp"

namespace impinge::lab {
namespace {

std::vector<double> radii(const TriangleMesh& mesh, const std::vector<Vec3>& directions, Layer layer) {
  return exact_radii(mesh, {directions, layer, {}});
}

// Rounding a corner moves it by 2^-49 mm: of 20 mm times the angle that is little down to 1e-12 degrees.
TEST(NearTangent, TheAimMeetsTheFaceAtTheAngle) {
  for (const double degrees : {1.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
    for (const Vec3& aim : test::random_directions(20, 3)) {
      const TriangleMesh face = near_tangent_face(aim, degrees * kDegree);
      const double slope = conditions_along(face, {&aim, 1})[0].slope;
      EXPECT_NEAR(1.0 / slope, std::tan(degrees * kDegree), 1e-3 * degrees * kDegree + 3e-15);
      const double radius = radii(face, {aim}, Layer::nearest)[0];
      EXPECT_GT(radius, kAimedRadius - 5.0);
      EXPECT_LT(radius, kAimedRadius + 5.0);
    }
  }
}

double aspect_of(const TriangleMesh& mesh, const Face& face) {
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, (corner(mesh, face, k) - corner(mesh, face, (k + 1) % 3)).norm());
  return area_vector(mesh, face).norm() / (longest * longest);
}

TEST(Sliver, IsAsHighAsItSays) {
  for (const double aspect : {1.0, 1e-3, 1e-6, 1e-10}) {
    const TriangleMesh mesh = aimed_sliver({0.3, -0.5, 0.8}, aspect);
    EXPECT_NEAR(aspect_of(mesh, mesh.faces[0]), aspect, 0.3 * aspect + 1e-14);
    const StabilityScene body = slivered(sphere(22.0, 100), aspect);
    EXPECT_TRUE(validate(body.mesh).closed());
    if (aspect > 0.1) continue;
    EXPECT_NEAR(aspect_of(body.mesh, body.mesh.faces[0]), aspect, 0.05 * aspect + 1e-14);
  }
}

TEST(Sliver, HoldsItsAim) {
  const Vec3 aim = Vec3(0.3, -0.5, 0.8).normalized();
  for (const double aspect : {1.0, 1e-4, 1e-8, 1e-12}) {
    const TriangleMesh mesh = aimed_sliver(aim, aspect);
    EXPECT_TRUE(is_met(cone_of(mesh, mesh.faces[0]), aim, aim)) << aspect;
  }
}

TEST(Sliver, WithoutAreaIsFlatAndHasADuplicateCorner) {
  const TriangleMesh mesh = slivered(sphere(22.0, 100), 0.0).mesh;
  const TriangleMesh& m = mesh;
  std::size_t flat = 0;
  for (const Face& face : m.faces) flat += aspect_of(m, face) < 1e-14 ? 1U : 0U;
  EXPECT_EQ(flat, 200U) << "one on the side, one between two places, of each of 100 faces";
}

TEST(RayThroughEdgeOrVertex, CoordinatesAddWithoutRounding) {
  const TriangleMesh body = dyadic_body();
  EXPECT_TRUE(validate(body).closed());
  for (const Vec3& v : body.vertices) EXPECT_EQ((64.0 * v).eval(), Vec3((64.0 * v).array().round()));
  for (const Face& face : body.faces) {
    const Vec3& a = corner(body, face, 0);
    const Vec3& b = corner(body, face, 1);
    EXPECT_EQ(orientation(a, b, a + b), 0) << "the ray is in the plane of the edge, exactly";
  }
}

TEST(RayThroughEdgeOrVertex, PassesByUnitsInTheLastPlace) {
  const Vec3 x(1.0, -0.75, 0.0);
  ASSERT_EQ(ulps_beside(x, 0), std::vector<Vec3>{x});
  const auto beside = ulps_beside(x, 2);
  ASSERT_EQ(beside.size(), 6U);
  EXPECT_EQ(beside[1].x(), 1.0 + 0x1p-51);
  EXPECT_EQ(beside[0].x(), 1.0 - 0x1p-52) << "below a power of two they are half as long";
  EXPECT_EQ(beside[2].y(), -0.75 - 0x1p-52);
  EXPECT_EQ(beside[5].z(), 2.0 * std::numeric_limits<double>::denorm_min());
}

TEST(Fold, IsMetOnceALayer) {
  const Vec3 axis = Vec3(1.0, 2.0, 2.0).normalized();
  const Vec3 across = axis.unitOrthogonal();
  const Vec3 within = std::cos(40.0 * kDegree) * axis + std::sin(40.0 * kDegree) * across;
  for (const std::size_t layers : {2U, 5U, 20U}) {
    const TriangleMesh mesh = pleated(layers);
    std::size_t met = 0;
    for (const Face& face : mesh.faces) {
      const TriangleCone cone = cone_of(mesh, face);
      met += !cone.edge_on() && cone.contains(within) ? 1U : 0U;
    }
    EXPECT_EQ(met, layers);
    EXPECT_NEAR(radii(mesh, {within}, Layer::nearest)[0], 20.0, 0.7);
    EXPECT_NEAR(radii(mesh, {within}, Layer::farthest)[0], 19.0 + static_cast<double>(layers), 1.5);
  }
}

TEST(MeshNoise, HasTheSharesThatItSays) {
  const TriangleMesh clean = sphere(22.0, 2000);
  EXPECT_EQ(noisy(clean, 0.0, 1).faces, clean.faces);
  const MeshReport report = validate(noisy(clean, 0.1, 1));
  EXPECT_NEAR(static_cast<double>(report.duplicate_faces), 180.0, 60.0);
  EXPECT_NEAR(static_cast<double>(report.faces - report.duplicate_faces), 1800.0, 60.0);
  EXPECT_GT(report.boundary_edges, 300U);
  const TriangleMesh turned = noisy(clean, 0.1, 1);
  std::size_t inward = 0;
  for (const Face& face : turned.faces)
    inward += area_vector(turned, face).dot(corner(turned, face, 0)) < 0.0;
  EXPECT_NEAR(static_cast<double>(inward), 200.0, 60.0);
}

}  // namespace
}  // namespace impinge::lab
