// SPDX-License-Identifier: GPL-3.0-or-later
// A ball with a spike in five walls of a cube: how far its tip is from a wall has a closed form. As near to
// contact as could be, no rotations are called free or blocked that are not all so, and no cut has another
// depth than it must.
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "change/resection.hpp"
#include "mesh/bodies.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

constexpr double kWall = 26.0;   // mm from the centre
constexpr double kTilt = 0.2;    // radians from the wall's normal, +z, to the tip
constexpr double kReach = 0.05;  // radians, of the turns
constexpr std::array kCloseness{1e-3, 1e-6, 1e-8, 1e-10, 1e-12};  // to contact, as a share of the radius

// Well beside the side between the wall's two triangles.
Vec3 tip_direction() {
  return Eigen::AngleAxisd(0.4, Vec3::UnitZ()) * Vec3(std::sin(kTilt), 0.0, std::cos(kTilt));
}

// The rotation brings the tip, `length` mm out, to tip_direction(); all else of the ball is far inside.
BallSocketPair spike_in_walls(double length, const Eigen::Matrix3d& rotation) {
  BallSocketPair pair{octahedron(5.0), {}};
  pair.ball.vertices[4] = length * tip_direction();  // that along +z
  for (Vec3& x : pair.ball.vertices) x = rotation.transpose() * x;
  for (int k = 0; k < 8; ++k)
    pair.socket.vertices.push_back(
        kWall * Vec3((k & 1) != 0 ? 1.0 : -1.0, (k & 2) != 0 ? 1.0 : -1.0, (k & 4) != 0 ? 1.0 : -1.0));
  // All but the one at -z, towards the centre.
  pair.socket.faces = {{4, 6, 5}, {5, 6, 7}, {0, 4, 1}, {1, 4, 5}, {2, 3, 6},
                       {3, 7, 6}, {0, 2, 4}, {2, 6, 4}, {1, 5, 3}, {3, 5, 7}};
  return pair;
}

// Turns by up to rho bring the tip p to |p| cos(tilt - rho) along the normal at most, and to
// |p| cos(tilt + rho) at least: all are free if that most is below the wall, all blocked if that least is
// not.
TEST(NearContact, NoRotationsAreFreeOrBlockedThatAreNotAllSo) {
  for (const Pose& pose : test::random_poses(5, kPi, 0.0, 25)) {
    for (const double sign : {-1.0, 1.0}) {
      const CellState state = sign < 0.0 ? CellState::free : CellState::blocked;
      const double length = kWall / std::cos(kTilt + sign * kReach);
      const CellTest test(spike_in_walls(length, pose.rotation));
      const auto found = [&](double short_of) {
        const double end = std::acos((kWall * (1.0 + sign * short_of)) / length);
        return CellSearch(test).decide(RotationBall{pose.rotation, sign * (end - kTilt)}).state;
      };
      for (const double close : kCloseness) {
        const CellState within = found(close);
        EXPECT_TRUE(within == state || (within == CellState::open && close < 1e-6)) << close;
        EXPECT_NE(found(-close), state) << close;
      }
    }
  }
}

// The turn leads the tip straight towards the normal. At its end the wall is nearest along the tip's ray, and
// what is beyond it, less the clearance, has to go.
TEST(NearContact, NoCutIsDeeperOrLessDeepThanItMustBe) {
  constexpr double kClearance = 0.5;
  const double may_stay = kWall / std::cos(kTilt - kReach) - kClearance;
  for (const Pose& pose : test::random_poses(5, kPi, 0.0, 26)) {
    RequiredLeg leg;
    leg.turn = {Eigen::Matrix3d::Identity(), tip_direction().cross(Vec3::UnitZ()).normalized(),
                pose.rotation};
    leg.growing = "flexion";
    leg.largest_deg = kReach / kDegree;
    const auto cut = [&](double length) {
      const BallSocketPair joint = spike_in_walls(length, pose.rotation);
      return least_radial_cut(joint.ball, SweptRadius(joint.socket, {leg}),
                              {.clearance_mm = kClearance, .least_mm3 = 1e-6});
    };
    for (const double close : kCloseness) {
      const double depth = close * may_stay;
      const Resection none = cut(may_stay - depth);
      EXPECT_TRUE(none.volume_mm3.low <= 0.0 && none.depth_mm.low <= 0.0) << close;
      const Resection some = cut(may_stay + depth);
      EXPECT_FALSE(some.empty()) << close;
      EXPECT_LE(some.depth_mm.low, depth + 1e-13) << close;  // the rounding of the depth itself
      EXPECT_GE(some.depth_mm.high, depth - 1e-13) << close;
    }
  }
}

}  // namespace
}  // namespace impinge
