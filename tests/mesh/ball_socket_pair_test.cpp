// SPDX-License-Identifier: GPL-3.0-or-later
// Contract of the generated joint, S the socket radius, B(u) = R + h cos^2(pi/2 min(1, angle(u, c) / w)):
//   both meshes have exactly the faces asked for, vertices at S or B(u); the ball is closed, n.v0 > 0;
//   default: the gap S - B(u) is at least 1 mm in every rotation, and 4 mm as given;
//   impinging_cam(): 4 mm as given, -1 mm when the cam is under the socket.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "mesh/validation.hpp"

namespace impinge {
namespace {

constexpr std::size_t kLevels[] = {300, 1000, 3000, 12000};

// Smallest gap over the ball vertices that lie under the socket when the ball is turned about +y.
double smallest_gap(const TriangleMesh& ball, const PairShape& shape, double degrees) {
  const Eigen::AngleAxisd turn(degrees * kDegree, Vec3::UnitY());
  double gap = shape.socket_radius;
  for (const Vec3& v : ball.vertices) {
    if (to_angles(turn * v).phi <= shape.half_opening_deg * kDegree) {
      gap = std::min(gap, shape.socket_radius - v.norm());
    }
  }
  return gap;
}

class Level : public testing::TestWithParam<std::size_t> {};

TEST_P(Level, MeshesAreExactAndStarShaped) {
  for (const PairShape& shape : {PairShape{}, impinging_cam()}) {
    const auto [ball, socket] = make_ball_socket_pair(GetParam(), shape);
    const MeshReport ball_report = validate(ball);
    const MeshReport socket_report = validate(socket);
    EXPECT_EQ(ball_report.faces, GetParam());
    EXPECT_EQ(socket_report.faces, GetParam());
    EXPECT_TRUE(ball_report.closed() && ball_report.volume && *ball_report.volume > 0.0);
    EXPECT_FALSE(socket_report.closed());
    EXPECT_EQ(ball_report.components + socket_report.components, 2U);
    for (const Vec3& v : ball.vertices) EXPECT_NEAR(v.norm(), ball_radius(v.normalized(), shape), 1e-12);
    for (const Vec3& v : socket.vertices) EXPECT_NEAR(v.norm(), shape.socket_radius, 1e-13);
    // The origin lies at least half the head radius behind the plane of every face.
    for (const Face& face : ball.faces) {
      EXPECT_GT(area_vector(ball, face).normalized().dot(corner(ball, face, 0)), 0.5 * shape.head_radius);
    }
    for (const Face& face : socket.faces)
      EXPECT_LT(area_vector(socket, face).dot(corner(socket, face, 0)), 0.0);
  }
}

TEST_P(Level, VerticesOnThePoles) {
  const auto [ball, socket] = make_ball_socket_pair(GetParam());
  EXPECT_EQ(ball.vertices.front(), Vec3(0.0, 0.0, 22.0));
  EXPECT_EQ(ball.vertices.back(), Vec3(0.0, 0.0, -22.0));
  EXPECT_EQ(socket.vertices.front(), Vec3(0.0, 0.0, 26.0));
}

INSTANTIATE_TEST_SUITE_P(OfTheThesis, Level, testing::ValuesIn(kLevels));

TEST(BallSocketPair, LargeCountsAreExactToo) {
  const auto [ball, socket] = make_ball_socket_pair(400000);
  EXPECT_EQ(ball.faces.size(), 400000U);
  EXPECT_EQ(socket.faces.size(), 400000U);
}

TEST(BallSocketPair, OddOrTooFewFacesAreRefused) {
  EXPECT_THROW(make_ball_socket_pair(301), std::invalid_argument);
  EXPECT_THROW(make_ball_socket_pair(6), std::invalid_argument);
  EXPECT_THROW(make_ball_socket_pair(300, {.head_radius = 0.0}), std::invalid_argument);
  EXPECT_THROW(make_ball_socket_pair(300, {.cam_half_width_deg = 0.0}), std::invalid_argument);
  EXPECT_THROW(make_ball_socket_pair(300, {.half_opening_deg = 180.0}), std::invalid_argument);
}

TEST(BallSocketPair, BumpJoinsTheHeadSmoothly) {
  const PairShape shape;
  const Vec3 top = cam_direction(shape);
  const Vec3 side = Vec3::UnitY().cross(top).normalized();
  const auto radius_at = [&](double degrees) {
    return ball_radius(std::cos(degrees * kDegree) * top + std::sin(degrees * kDegree) * side, shape);
  };
  EXPECT_DOUBLE_EQ(radius_at(0.0), 25.0);
  EXPECT_NEAR(radius_at(15.0), 23.5, 1e-12);  // half the height at half the width
  EXPECT_EQ(radius_at(30.5), 22.0);
  // Slope: dB/dangle = -h pi / (2 w) sin(pi angle / w), which is zero at the top and at the foot.
  for (const double angle : {1.0, 10.0, 20.0, 29.985, 30.015}) {
    const double slope = (radius_at(angle + 0.01) - radius_at(angle - 0.01)) / 0.02;
    const double expected = angle < 30.0 ? -3.0 * kPi / 60.0 * std::sin(kPi * angle / 30.0) : 0.0;
    EXPECT_NEAR(slope, expected, 1e-7) << angle;
  }
}

TEST(BallSocketPair, DefaultCamNeverImpinges) {
  const PairShape shape;
  const TriangleMesh ball = make_ball_socket_pair(3000).ball;
  EXPECT_NEAR(smallest_gap(ball, shape, 0.0), 4.0, 1e-12);
  for (const Vec3& v : ball.vertices) EXPECT_GE(shape.socket_radius - v.norm(), 1.0 - 1e-12);
  EXPECT_LT(smallest_gap(ball, shape, -60.0), 1.1);  // the top of the bump does come under the socket
}

TEST(BallSocketPair, ImpingingCamIsFreeAsGivenAndImpingesWhenTurned) {
  const PairShape shape = impinging_cam();
  const TriangleMesh ball = make_ball_socket_pair(12000, shape).ball;
  EXPECT_NEAR(smallest_gap(ball, shape, 0.0), 4.0, 1e-12);
  EXPECT_GT(smallest_gap(ball, shape, -33.0), 0.0);
  EXPECT_LT(smallest_gap(ball, shape, -37.0), 0.0);
  EXPECT_NEAR(smallest_gap(ball, shape, -60.0), -1.0, 0.02);
  EXPECT_NEAR(smallest_gap(ball, shape, 20.0), 4.0, 1e-12);  // away from the socket
}

}  // namespace
}  // namespace impinge
