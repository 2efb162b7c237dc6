// SPDX-License-Identifier: GPL-3.0-or-later
// Contract, away from the rim: |field - signed distance| <= the bound of the distance grid; negative beyond
// the socket as the centre sees it.
#include "methods/cartesian_field.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "support/directions.hpp"

namespace impinge::lab {
namespace {

constexpr double kSocket = 26.0;

TEST(CartesianField, IsTheSignedDistanceOfASphereInside) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  const DistanceGridShape shape{32.0, 33};
  const CartesianField field(pair.ball, make_signed_field(pair.socket, shape));
  const GridField grid = make_signed_field(pair.socket, shape);
  for (const Vec3& u : test::random_directions(300, 7)) {
    if (u.z() < 0.3) continue;
    for (const double radius : {22.0, 25.0, 27.0, 30.0})
      EXPECT_NEAR(grid.at(radius * u), kSocket - radius, distance_grid_bound(shape) + 0.1) << u.transpose();
  }
  EXPECT_GT(grid.at(Vec3(0.0, 0.0, -30.0)), 0.0) << "nothing is beyond where no socket is";
  EXPECT_TRUE(std::isnan(grid.at(Vec3(0.0, 0.0, 33.0))));
  EXPECT_EQ(field.bytes(), 33U * 33U * 33U * 4U);
}

TEST(CartesianField, TouchesOnceAVertexIsThrough) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  const DistanceGridShape shape{32.0, 33};
  CartesianField field(pair.ball, make_signed_field(pair.socket, shape));
  for (const double moved : {0.0, 2.0, 3.2, 4.8, 6.0}) {
    Pose pose;
    pose.translation = Vec3(0.0, 0.0, moved);
    EXPECT_EQ(field.touches(pose), moved > 4.0) << moved;
  }
  double least = 1e9;
  for (const double d : field.distances()) least = std::min(least, d);
  EXPECT_NEAR(least, -2.0, distance_grid_bound(shape) + 0.1) << "of the last pose";
}

}  // namespace
}  // namespace impinge::lab
