// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: a ray refers to the face that it meets first (nearest) or last (farthest); the raster fills as
// all pairs do; a point that does not meet the face of its ray gets no radius, any other the exact one.
#include "methods/triangle_table.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/icosphere.hpp"
#include "methods/maciel_triangles.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

TEST(TriangleTable, RaysStandInTheMiddleOfTheirPatches) {
  for (const std::size_t side : {1U, 7U, 10U}) {
    for (std::size_t ray = 0; ray < side * side; ++ray)
      EXPECT_EQ(ray_of(side, 3.0 * ray_direction(side, ray)), ray);
  }
  EXPECT_NEAR(angle_between(ray_direction(10, 0), Vec3::UnitZ()) / kDegree, 9.0, 1e-12);
  EXPECT_NEAR(to_angles(ray_direction(10, 1)).theta / kDegree, 54.0, 1e-12);
  EXPECT_EQ(ray_of(10, Vec3::UnitZ()), 0U);
  EXPECT_EQ(ray_of(10, -Vec3::UnitZ()), 90U) << "the poles belong to the outermost rows";
}

TEST(TriangleTable, RadiusOnAFaceIsThatOfTheRayCaster) {
  const BallSocketPair pair = make_ball_socket_pair(100);
  for (const TriangleMesh* mesh : {&pair.ball, &pair.socket}) {
    const RayCaster caster(*mesh);
    for (const Vec3& u : test::random_directions(300, 6)) {
      double met = std::nan("");
      for (const Face& face : mesh->faces) {
        const double radius = radius_on(*mesh, face, 7.0 * u);
        if (!std::isnan(radius)) met = radius;
      }
      const double expected = caster.cast(u, Layer::nearest);
      EXPECT_EQ(std::isnan(met), std::isnan(expected));
      if (std::isnan(met)) continue;
      EXPECT_NEAR(met, expected, 1e-11);
    }
  }
}

TEST(TriangleTable, TheRasterFillsAsAllPairsDo) {
  const BallSocketPair pair = make_ball_socket_pair(300, impinging_cam());
  TriangleMesh outer = pair.socket;
  for (Vec3& v : outer.vertices) v *= 1.1;
  const TriangleMesh two_layers = test::joined(pair.socket, outer);
  for (const TriangleMesh* mesh : {&pair.ball, &pair.socket, &two_layers}) {
    for (const Layer layer : {Layer::nearest, Layer::farthest}) {
      for (const std::size_t side : {1U, 2U, 10U, 37U})
        EXPECT_EQ(fill_triangles(*mesh, side, layer).face, fill_triangles_pairwise(*mesh, side, layer).face);
    }
  }
  EXPECT_NE(fill_triangles(two_layers, 37, Layer::nearest).face,
            fill_triangles(two_layers, 37, Layer::farthest).face);
  EXPECT_THROW(fill_triangles(two_layers, 0, Layer::nearest), std::invalid_argument);
}

TEST(TriangleTable, LosesFacesUntilEachHasARay) {
  const TriangleMesh ball = icosphere(22.0, 2);  // 320 faces, about 10 degrees wide
  const auto missed = [&ball](std::size_t side) {
    return missed_faces(fill_triangles(ball, side, Layer::farthest), ball);
  };
  EXPECT_GE(missed(10), 320U - 100U) << "no more faces than rays";
  EXPECT_GT(missed(20), 0U);
  EXPECT_EQ(missed(200), 0U);
}

TEST(TriangleTable, ExactWhereTheFaceIsMetAndSilentElsewhere) {
  const TriangleMesh ball = make_ball_socket_pair(300).ball;
  const TriangleTable table = fill_triangles(ball, 24, Layer::farthest);
  const RayCaster caster(ball);
  int silent = 0;
  for (const Vec3& u : test::random_directions(1000, 2)) {
    const double radius = radius_at(table, ball, 5.0 * u);
    silent += std::isnan(radius) ? 1 : 0;
    if (std::isnan(radius)) continue;
    EXPECT_NEAR(radius, caster.cast(u, Layer::farthest), 1e-11);
  }
  EXPECT_GT(silent, 50);
  EXPECT_LT(silent, 950);
}

TEST(MacielTriangles, MissesAContactUnderATriangleThatItLost) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  Pose touching;
  touching.translation = Vec3(0.1, 0.2, 4.5);
  Pose free;
  free.translation = Vec3(0.1, 0.2, 1.0);
  MacielTriangles fine(pair.ball, pair.socket, fill_triangles(pair.ball, 400, Layer::farthest));
  EXPECT_TRUE(fine.touches(touching));
  EXPECT_FALSE(fine.touches(free));
  TriangleTable none{1, {kNoFace}};
  EXPECT_FALSE(MacielTriangles(pair.ball, pair.socket, none).touches(touching));
  EXPECT_EQ(fine.bytes(), 400U * 400U * 4U + pair.ball.vertices.size() * 24U + 300U * 12U);
}

}  // namespace
}  // namespace impinge::lab
