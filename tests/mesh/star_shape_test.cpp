// SPDX-License-Identifier: GPL-3.0-or-later
// Star-shaped: all faces on one side of the centre and no two cones overlap. Solid angles against closed
// forms.
#include "mesh/star_shape.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/joined.hpp"

namespace impinge {
namespace {

using Corners = std::array<Vec3, 3>;

TEST(StarShape, SolidAngles) {
  EXPECT_NEAR(solid_angle({1, 0, 0}, {0, 2, 0}, {0, 0, 3}), kPi / 2.0, 1e-15);  // an octant
  EXPECT_NEAR(solid_angle({1, 0, 0}, {0, 0, 3}, {0, 2, 0}), -kPi / 2.0, 1e-15);
  EXPECT_NEAR(star_shape(octahedron(20.0)).solid_angle, 4.0 * kPi, 1e-12);
  EXPECT_NEAR(star_shape(sphere(20.0, 500, {30.0, 0.0, 0.0})).solid_angle, 0.0, 1e-10);
}

TEST(StarShape, ConesOverlapExactlyIfTheyShareTheirInside) {
  const Corners octant{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  EXPECT_TRUE(cones_overlap(octant, octant));
  EXPECT_TRUE(cones_overlap(octant, {Vec3(2, 1, 1), Vec3(1, 2, 1), Vec3(1, 1, 2)}));      // inside
  EXPECT_FALSE(cones_overlap(octant, {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, -1, 0)}));    // a common edge
  EXPECT_FALSE(cones_overlap(octant, {Vec3(1, 0, 0), Vec3(1, -1, 0), Vec3(1, -1, -1)}));  // a common corner
  EXPECT_FALSE(cones_overlap(octant, {Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)}));  // opposite
  // A long thin triangle across the octant, no corner of either inside the other.
  EXPECT_TRUE(cones_overlap(octant, {Vec3(2, 2, -1), Vec3(2.1, 2, -1), Vec3(-1, -1, 4)}));
  const Corners twisted{Vec3(1, 1, -0.2), Vec3(-0.2, 1, 1), Vec3(1, -0.2, 1)};  // a star of two triangles
  EXPECT_TRUE(cones_overlap(octant, twisted));
}

TEST(StarShape, BodiesRoundTheCentreAreProven) {
  for (const TriangleMesh& mesh : {octahedron(20.0), cone(), sphere(22.0, 1000, {9.0, -4.0, 3.0}),
                                   make_ball_socket_pair(3000).ball, make_ball_socket_pair(3000).socket}) {
    const StarShapeReport report = star_shape(mesh);
    EXPECT_TRUE(report.star_shaped);
    EXPECT_EQ(report.overlapping_pairs, 0U);
    EXPECT_EQ(report.violating, 0.0);
  }
  EXPECT_NEAR(star_shape(make_ball_socket_pair(3000).socket).covered, 0.5 * (1.0 - std::cos(87.0 * kDegree)),
              0.003);
}

TEST(StarShape, ViolationsAreFoundAndMeasured) {
  const StarShapeReport beside = star_shape(sphere(20.0, 2000, {30.0, 0.0, 0.0}));
  EXPECT_FALSE(beside.star_shaped);
  EXPECT_NEAR(beside.violating, 0.5 * (1.0 - std::sqrt(5.0) / 3.0), 0.003);  // sin of the half angle is 2/3
  const StarShapeReport nested = star_shape(test::joined(cup(20.0, 40.0, 500), cup(26.0, 80.0, 500)));
  EXPECT_FALSE(nested.star_shaped);
  EXPECT_GT(nested.overlapping_pairs, 500U);
  EXPECT_NEAR(nested.violating, 0.5 * (1.0 - std::cos(40.0 * kDegree)), 0.003);
  EXPECT_NEAR(nested.covered, 0.5 * (1.0 - std::cos(80.0 * kDegree)), 0.003);
  TriangleMesh dented = sphere(20.0, 1000);
  dented.vertices[500] *= -0.1;  // through the centre to the other side
  EXPECT_FALSE(star_shape(dented).star_shaped);
}

TEST(StarShape, AFarMeshIsNotTriedPairByPair) {
  const StarShapeReport far = star_shape(sphere(20.0, 20000, {20000.0, 0.0, 0.0}));
  EXPECT_FALSE(far.star_shaped);
  EXPECT_LT(far.covered, 1e-4);
}

}  // namespace
}  // namespace impinge
