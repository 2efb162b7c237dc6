// SPDX-License-Identifier: GPL-3.0-or-later
// Radial contact against the intersection of the surfaces, by CGAL (reference/meeting_surfaces.hpp):
//   impinged  <=>  the surfaces meet, or have slipped past each other: the ball meets the wall of the rim, is
//                  beyond the socket as a whole, or holds it as a whole
// Each side of the equivalence is asked where its own frame has rounded the other surface.
#include "reference/meeting_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/overlay.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/bodies.hpp"
#include "mesh/star_shape.hpp"
#include "support/dice.hpp"
#include "support/poses.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

constexpr double kReach = 200.0;  // mm, beyond all vertices in all poses

class MeetingSurfacesAttack : public testing::Test, protected test::Dice {
 protected:
  MeetingSurfacesAttack() : Dice(17) {}
  // A bumpy closed ball, and a bumpy cup or a closed socket.
  BallSocketPair any_joint() {
    const auto bumps = [this](TriangleMesh mesh, double height) {
      for (Vec3& v : mesh.vertices) v *= 1.0 + height * between(-1.0, 1.0);
      return mesh;
    };
    const auto faces = [this](int most) { return 2 * static_cast<std::size_t>(between(4.0, most)); };
    const double opening = between(30.0, 170.0);
    const TriangleMesh ball = bumps(sphere(20.0, faces(20)), 0.2);
    const TriangleMesh socket = between(0.0, 1.0) < 0.2 ? bumps(sphere(30.0, faces(20)), 0.2)
                                                        : bumps(cup(28.0, opening, faces(20)), 0.1);
    return {ball, socket};
  }

  Pose any_pose() {
    Pose pose{Eigen::AngleAxisd(between(0.0, kPi), direction()).toRotationMatrix(), Vec3::Zero()};
    const double kind = between(0.0, 1.0);
    if (kind > 0.3) pose.translation = (kind > 0.7 ? 90.0 : 15.0) * between(0.0, 1.0) * direction();
    return pose;
  }
};

// What CGAL says of a pose.
struct Relation {
  bool meet = false;      // the surfaces have a common point, in either frame
  bool past_rim = false;  // the ball meets the wall of the rim
  bool beyond = false;    // so is the first vertex of the ball
  bool within = false;    // so is the first vertex of the socket
  bool impinged() const { return meet || past_rim || beyond || within; }
};

Relation relation(const BallSocketPair& joint, const TriangleMesh& wall, const Pose& pose) {
  const TriangleMesh ball = test::ball_in_socket_frame(joint.ball, pose);
  const TriangleMesh socket = test::socket_in_ball_frame(joint.socket, pose);
  return {surfaces_meet(ball, joint.socket) || surfaces_meet(joint.ball, socket), surfaces_meet(ball, wall),
          beyond_surface(joint.socket, ball.vertices[0]),
          within_surface(joint.ball, socket.vertices[0], kReach)};
}

// The two neighbouring shares of a way at which the verdict changes, if it does.
std::optional<std::array<double, 2>> change(const SurfaceOverlay& overlay, const Pose& from,
                                            const Vec3& way) {
  const auto at = [&](double share) { return Pose{from.rotation, from.translation + share * way}; };
  double low = 0.0;
  double high = 1.0;
  const bool first = overlay.impinged(at(low));
  if (overlay.impinged(at(high)) == first) return std::nullopt;
  for (double middle = 0.5; middle > low && middle < high; middle = 0.5 * (low + high))
    (overlay.impinged(at(middle)) == first ? low : high) = middle;
  return std::array{low, high};
}

// Random poses, and next to every second one the two nearest between which the verdict changes.
TEST_F(MeetingSurfacesAttack, ImpingedIsToMeetOrToHaveSlippedPast) {
  const std::size_t cases = std::max<std::size_t>(random_cases() / 10, 1000);  // poses, some 100 a joint
  std::size_t tangent = 0;
  std::size_t without_meeting = 0;
  std::size_t clear = 0;
  for (std::size_t n = 0; n < cases;) {
    const BallSocketPair joint = any_joint();
    if (!star_shape(joint.ball).star_shaped || !star_shape(joint.socket).star_shaped) continue;
    const SurfaceOverlay overlay(joint.ball, joint.socket);
    const TriangleMesh wall = rim_wall(joint.socket, kReach);
    const auto ask = [&](const Pose& pose) {
      ++n;
      const Relation truth = relation(joint, wall, pose);
      EXPECT_EQ(overlay.impinged(pose), truth.impinged()) << "case " << n;
      if (pose.translation.isZero(0.0)) {
        EXPECT_EQ(truth.impinged(), truth.meet || truth.within) << "case " << n;
      }
      without_meeting += truth.impinged() && !truth.meet ? 1U : 0U;
      clear += truth.impinged() ? 0U : 1U;
    };
    for (int k = 0; k < 50; ++k) {
      const Pose pose = any_pose();
      ask(pose);
      const Vec3 way = between(0.0, 20.0) * direction();
      const auto contact = change(overlay, pose, way);
      if (!contact) continue;
      ++tangent;
      for (const double share : *contact) ask({pose.rotation, pose.translation + share * way});
    }
  }
  EXPECT_GT(tangent, cases / 20);
  EXPECT_GT(without_meeting, cases / 50);
  EXPECT_GT(clear, cases / 20);
}

}  // namespace
}  // namespace impinge
