// SPDX-License-Identifier: GPL-3.0-or-later
// Joints of a few faces of the kinds that go wrong, in poses that make them worse: faces in planes through a
// centre, exactly or but for rounding, slivers, bars that meet edge on edge, vertices on a centre or on each
// other. The culled overlay must answer as the overlay of all faces, and both as the exact oracle
// (reference/shadow.hpp) does:
//   some face of the ball meets a shadow of the socket at rest, or
//   some face of the socket at rest ... a pyramid of the ball,
// without the faces whose plane holds the centre of their own mesh. And needles that meet tip on tip, so that
// the caps of both faces, and the ranges of their radii, share next to nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "contact/culled_overlay.hpp"
#include "gap/overlay.hpp"
#include "mesh/bodies.hpp"
#include "reference/shadow.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/poses.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

constexpr std::size_t kPosesPerJoint = 20;  // making a joint costs as much as asking it so often
constexpr std::size_t kPosesPerOracle = 8;  // the oracle costs as much again

class TheoremOverlay : public testing::Test, protected test::Dice {
 protected:
  TheoremOverlay() : Dice(11) {}
  // On a grid of 8 mm: corners of different faces and of poses by whole steps and quarter turns coincide.
  Vec3 on_grid() {
    Vec3 v = Vec3::Zero();
    while (v.isZero(0.0)) v = 8.0 * Vec3(whole(-3, 3), whole(-3, 3), whole(-3, 3));
    return v;
  }

  void add_any_face(TriangleMesh& mesh, double radius) {
    const Vec3 a = whole(0, 1) == 0 ? on_grid() : Vec3(radius * between(0.5, 1.5) * direction());
    const Vec3 b = whole(0, 1) == 0 ? on_grid() : Vec3(radius * between(0.5, 1.5) * direction());
    switch (whole(0, 5)) {
      case 0:  // a flange: in a plane through the centre, exactly on the grid and else but for rounding
        return test::add_face(mesh, a, b, whole(-2, 2) * a + whole(-2, 2) * b);
      case 1:
        return test::add_face(mesh, a, b, between(-1, 2) * a + between(-1, 2) * b);
      case 2:  // a sliver, or none
        return test::add_face(mesh, a, b, a + std::ldexp(whole(0, 8), -3) * (b - a));
      case 3: {  // two bars of a cross
        const Vec3 along = a.unitOrthogonal();
        const Vec3 up = 0.04 * a;
        return test::add_face(mesh, a - 9 * along, a + 9 * along,
                              whole(0, 1) == 0 ? Vec3(2 * a) : Vec3(0.5 * a + up));
      }
      default:
        return test::add_face(mesh, a, b, whole(0, 1) == 0 ? on_grid() : Vec3(radius * direction()));
    }
  }

  BallSocketPair any_joint() {
    BallSocketPair joint;
    if (whole(0, 3) == 0) joint.ball = octahedron(8.0 * whole(1, 3));
    if (whole(0, 3) == 0) joint.socket = octahedron(8.0 * whole(2, 4));
    for (int k = whole(0, 2) + (joint.ball.faces.empty() ? 1 : 0); k > 0; --k) add_any_face(joint.ball, 18.0);
    for (int k = whole(0, 2) + (joint.socket.faces.empty() ? 1 : 0); k > 0; --k)
      add_any_face(joint.socket, 24.0);
    return joint;
  }

  Eigen::Matrix3d generic_rotation() {
    return Eigen::AngleAxisd(between(-kPi, kPi), direction()).toRotationMatrix();
  }

  // A face as thin as a needle from an end, `length` radians from x towards a unit vector across, to its tip,
  // which is a thousandth of that past x.
  void add_needle(TriangleMesh& mesh, const Vec3& x, const Vec3& towards, double length) {
    const double radius = x.norm() * between(0.8, 1.25);
    const Vec3 end = radius * (std::cos(length) * x.normalized() + std::sin(length) * towards);
    const Vec3 beside = 1e-5 * length * x.cross(towards);
    test::add_face(mesh, x - 1e-3 * (end - x), end - beside, end + beside);
  }

  // Two needles that point at each other but for 3 to 10 degrees, and pass each other with their tips about
  // the direction u; that of the ball is beyond by as little as 1e-5 of the radius. Between shells that are
  // far away.
  BallSocketPair needles(const Vec3& u) {
    BallSocketPair joint{octahedron(2.0), octahedron(90.0)};
    const Vec3 towards = u.cross(direction()).normalized();
    const double length = power(-2.0, -0.3);
    const double turn = (whole(0, 1) == 0 ? 1.0 : -1.0) * between(3.0, 10.0) * kDegree;
    const Vec3 x = between(18.0, 24.0) * u;
    add_needle(joint.ball, (1.0 + power(-5.0, -1.0)) * x, towards, length);
    add_needle(joint.socket, x, -(std::cos(turn) * towards + std::sin(turn) * u.cross(towards)), length);
    return joint;
  }

  Eigen::Matrix3d any_rotation() {
    if (whole(0, 2) == 0) return generic_rotation();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    for (int k = whole(0, 3); k > 0; --k) {  // exact quarter turns about x, y or z
      Eigen::Matrix3d quarter = Eigen::Matrix3d::Zero();
      const int axis = whole(0, 2);
      quarter(axis, axis) = 1.0;
      quarter((axis + 1) % 3, (axis + 2) % 3) = -1.0;
      quarter((axis + 2) % 3, (axis + 1) % 3) = 1.0;
      turn = turn * quarter;
    }
    return turn;
  }

  Pose any_pose(const BallSocketPair& joint) {
    Pose pose{any_rotation(), Vec3::Zero()};
    const Vec3& x =
        joint.ball.vertices[static_cast<std::size_t>(whole(0, 1000)) % joint.ball.vertices.size()];
    const Vec3& y =
        joint.socket.vertices[static_cast<std::size_t>(whole(0, 1000)) % joint.socket.vertices.size()];
    switch (whole(0, 7)) {
      case 0:  // vertex on vertex, or as good as
        pose.translation = y - pose.rotation * x;
        break;
      case 1:  // a vertex of the socket on the ball's centre
        pose.translation = y;
        break;
      case 2:  // a vertex of the ball on the socket's centre, or so near
        pose.translation = -to_socket(pose, x) + std::ldexp(whole(0, 1), -whole(4, 40)) * direction();
        break;
      case 3:
        pose.translation = on_grid();
        break;
      case 4:
        pose.translation = between(0.0, 30.0) * direction();
        break;
      default:  // none
        break;
    }
    return pose;
  }
};

TriangleMesh counted(TriangleMesh mesh) {
  std::erase_if(mesh.faces, [&mesh](const Face& face) {
    return !covers_directions({corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)});
  });
  return mesh;
}

bool oracle(const BallSocketPair& joint, const Pose& pose) {
  const BallSocketPair surfaces{counted(joint.ball), counted(joint.socket)};
  return ShadowReference(test::ball_in_socket_frame(surfaces.ball, pose), surfaces.socket)
             .ball_beyond_socket() ||
         ShadowReference(surfaces.ball, test::socket_in_ball_frame(surfaces.socket, pose))
             .socket_within_ball();
}

TEST_F(TheoremOverlay, CullingAndTheOracleAgreeOnDegenerateJoints) {
  std::size_t impinged = 0;
  std::size_t between_vertices = 0;
  const std::size_t cases = random_cases();
  for (std::size_t n = 0; n < cases; n += kPosesPerJoint) {
    const BallSocketPair joint = any_joint();
    const SurfaceOverlay all(joint.ball, joint.socket);
    const CulledJoint vertices(joint);
    const CulledOverlay culled(joint);
    for (std::size_t k = 0; k < kPosesPerJoint; ++k) {
      const Pose pose = any_pose(joint);
      const bool expected = all.impinged(pose);
      ASSERT_EQ(culled.impinged(pose), expected) << "case " << n + k;
      ASSERT_EQ(culled.impinged(pose, vertices), expected) << "case " << n + k;
      ASSERT_EQ(all.deepest(pose).has_value(), expected) << "case " << n + k;
      if (k < kPosesPerOracle) {
        ASSERT_EQ(oracle(joint, pose), expected) << "case " << n + k;
      }
      impinged += expected ? 1U : 0U;
      between_vertices += expected && !vertices.impinged(pose) ? 1U : 0U;
    }
  }
  EXPECT_GT(impinged, cases / 5);
  EXPECT_LT(impinged, cases * 4 / 5);
  EXPECT_GT(between_vertices, cases / 50);  // of faces alone
}

// Each pose has a joint of its own, which takes a millisecond to make.
TEST_F(TheoremOverlay, NeedlesThatMeetTipOnTipAreFound) {
  std::size_t between_vertices = 0;
  const std::size_t cases = random_cases() / 10;
  for (std::size_t n = 0; n < cases; ++n) {
    const Pose pose{generic_rotation(), (whole(0, 1) == 0 ? 0.0 : between(0.0, 5.0)) * direction()};
    BallSocketPair joint = needles(direction());
    if (whole(0, 1) == 0)  // they meet as seen from the centre of the socket, or of the ball
      joint.ball = test::socket_in_ball_frame(joint.ball, pose);
    else
      joint.socket = test::ball_in_socket_frame(joint.socket, pose);
    const CulledJoint vertices(joint);
    ASSERT_TRUE(SurfaceOverlay(joint.ball, joint.socket).impinged(pose)) << "case " << n;
    ASSERT_TRUE(CulledOverlay(joint).impinged(pose)) << "case " << n;
    ASSERT_TRUE(CulledOverlay(joint).impinged(pose, vertices)) << "case " << n;
    if (n % 10 == 0) {
      ASSERT_TRUE(oracle(joint, pose)) << "case " << n;
    }
    between_vertices += vertices.impinged(pose) ? 0U : 1U;
  }
  EXPECT_EQ(between_vertices, cases);
}

}  // namespace
}  // namespace impinge
