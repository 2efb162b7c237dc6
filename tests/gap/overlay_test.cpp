// SPDX-License-Identifier: GPL-3.0-or-later
// Ball and socket impinge exactly if some face of the ball meets the shadow of some face of the socket, seen
// from either centre (reference/shadow.hpp).
#include "gap/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/exact_side.hpp"
#include "gap/face_overlay.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/star_shape.hpp"
#include "reference/meeting_surfaces.hpp"
#include "reference/shadow.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/poses.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

bool oracle(const TriangleMesh& ball, const TriangleMesh& socket, const Pose& pose) {
  return ShadowReference(test::ball_in_socket_frame(ball, pose), socket).ball_beyond_socket() ||
         ShadowReference(ball, test::socket_in_ball_frame(socket, pose)).socket_within_ball();
}

struct Agreement {
  int wrong = 0;
  int clear = 0;
  int impinged = 0;
};

Agreement compare(const TriangleMesh& ball, const TriangleMesh& socket, const std::vector<Pose>& poses) {
  const SurfaceOverlay overlay(ball, socket);
  Agreement found;
  for (const Pose& pose : poses) {
    const bool expected = oracle(ball, socket, pose);
    found.wrong += overlay.impinged(pose) != expected ? 1 : 0;
    found.wrong += overlay.deepest(pose).has_value() != expected ? 1 : 0;
    ++(expected ? found.impinged : found.clear);
  }
  return found;
}

// Faces from a quarter of the view to small ones, so that every way of looking them up is taken.
TEST(TheoremOverlay, AgreesWithTheOracleOnBodiesOfAllKinds) {
  struct Case {
    TriangleMesh ball;
    TriangleMesh socket;
    double shift;
  };
  const BallSocketPair pair = make_ball_socket_pair(100, impinging_cam());
  const std::vector<Case> cases{{octahedron(16.0), octahedron(30.0), 6.0},
                                {octahedron(20.0), cup(22.0, 80.0, 100), 4.0},
                                {sphere(20.0, 60), sphere(22.5, 80), 3.0},
                                {cone({20.0, 24.0, 10.0, 9}), cup(24.5, 100.0, 60), 2.0},
                                {pair.ball, pair.socket, 4.0}};
  for (const Case& joint : cases) {
    const Agreement found = compare(joint.ball, joint.socket, test::random_poses(100, 3.0, joint.shift, 5));
    EXPECT_EQ(found.wrong, 0);
    EXPECT_GT(found.clear, 3) << found.impinged;
    EXPECT_GT(found.impinged, 3) << found.clear;
  }
}

// Exact contact and everything within a unit of the last place of it: identical surfaces touch everywhere.
TEST(Overlay, SurfacesThatTouchAreImpinged) {
  const TriangleMesh mesh = octahedron(16.0);
  EXPECT_TRUE(SurfaceOverlay(mesh, mesh).impinged({}));
  TriangleMesh smaller = mesh;
  for (Vec3& v : smaller.vertices) v *= 1.0 - 0x1p-52;
  EXPECT_FALSE(SurfaceOverlay(smaller, mesh).impinged({}));
  EXPECT_TRUE(SurfaceOverlay(mesh, smaller).impinged({}));
  EXPECT_FALSE(SurfaceOverlay(smaller, mesh).deepest({}));
  EXPECT_EQ(SurfaceOverlay(mesh, mesh).deepest({})->depth, 0.0);
}

// Two faces that cross like the bars of an X: no corner of either is over the other, the edges cross 1 mm
// too deep.
TEST(Overlay, SeesACrossingOfEdgesThatNoVertexShows) {
  const TriangleMesh ball{{{-8, 1, 21}, {8, 1, 21}, {0, 1, 10}}, {{0, 1, 2}}};
  const TriangleMesh socket{{{0, -7, 20}, {0, 7, 20}, {6, 9, 40}}, {{0, 1, 2}}};
  const SurfaceOverlay overlay(ball, socket);
  ASSERT_TRUE(overlay.impinged({}));
  const auto deepest = overlay.deepest({});
  EXPECT_EQ(deepest->kind, OverlayKind::crossing);
  EXPECT_NEAR(deepest->depth, Vec3(0, 1, 21).norm() * (1.0 - 20.0 / 21.0), 1e-12);
  for (const Vec3& x : ball.vertices)
    EXPECT_FALSE(exactly_impinged(Surface::ball, overlay.faces(Surface::socket), x));
  for (const Vec3& y : socket.vertices)
    EXPECT_FALSE(exactly_impinged(Surface::socket, overlay.faces(Surface::ball), y));
  Pose up;
  up.translation.z() = -1.5;
  EXPECT_FALSE(overlay.impinged(up));
}

// The bars of the X above, so small that all products of three lengths vanish: exact signs tell that they
// cross, and a depth is a length of theirs.
TEST(Overlay, TheDepthOfATinyCrossingIsANumber) {
  constexpr double kTiny = 0x1p-400;
  const OverlayFace ball{{kTiny * Vec3(-8, 1, 21), kTiny * Vec3(8, 1, 21), kTiny * Vec3(0, 1, 10)}, 0};
  const OverlayFace socket{{kTiny * Vec3(0, -7, 20), kTiny * Vec3(0, 7, 20), kTiny * Vec3(6, 9, 40)}, 0};
  const Crossing found = crossing(ball.corner[0], ball.corner[1], socket.corner[0], socket.corner[1]);
  EXPECT_TRUE(found.crosses);
  EXPECT_EQ(found.order, 1);
  EXPECT_LE(std::abs(depth_at(ball, socket, {OverlayKind::crossing, found.order, 0, 0})), kTiny * 8.0);
}

// A moved face is halved eight times at most, also where the surface at rest has more than 4^8 faces. Nearly
// all of these are edge-on: they change no answer.
TEST(Overlay, OfManyFacesAnswersAsOfFew) {
  TriangleMesh socket = octahedron(30.0);
  socket.faces.resize(70'000, Face{0, 1, 2});  // in a plane through the centre
  const SurfaceOverlay overlay(octahedron(20.0), std::move(socket));
  EXPECT_FALSE(overlay.impinged({}));
  for (const double shift : {9.9, 10.1})
    EXPECT_EQ(overlay.impinged({Eigen::Matrix3d::Identity(), Vec3(shift, 0, 0)}), shift > 10.0);
}

TEST(ExactlyImpinged, TheCentreIsInABallThatHasAFace) {
  const TriangleMesh body = octahedron(20.0);
  const TriangleMesh none;
  const NearFaces faces(body, 0.1);
  const NearFaces no_faces(none, 0.1);
  EXPECT_TRUE(exactly_impinged(Surface::socket, faces, Vec3::Zero()));
  EXPECT_FALSE(exactly_impinged(Surface::socket, no_faces, Vec3::Zero()));
  EXPECT_FALSE(exactly_impinged(Surface::ball, faces, Vec3::Zero()));
  EXPECT_FALSE(exactly_impinged(Surface::ball, no_faces, Vec3::Zero()));
}

// A ball that has slipped past the rim is beyond the socket, although the surfaces have no common point;
// where the socket has no surface the ball is free.
TEST(Overlay, KnowsTheRim) {
  const TriangleMesh socket = cup(26.0, 60.0, 400);
  const TriangleMesh pin = sphere(1.0, 40, {0.0, 0.0, 0.0});
  const SurfaceOverlay overlay(pin, socket);
  Pose pose;
  EXPECT_FALSE(overlay.impinged(pose));
  pose.translation = Vec3(0, 0, 30);
  EXPECT_TRUE(overlay.impinged(pose));
  pose.translation = Vec3(0, 0, -30);
  EXPECT_FALSE(overlay.impinged(pose));
  pose.translation = Vec3(30, 0, 0);
  EXPECT_FALSE(overlay.impinged(pose));
}

// The verdict on an octahedron of 20 mm with a flange that reaches beyond one of 60 mm, in a plane through
// the centre and the least bit beside it.
TEST(Overlay, FacesInAPlaneThroughTheirCentreTakeNoPart) {
  for (const double off : {0.0, 0x1p-40}) {
    TriangleMesh ball = octahedron(20.0);
    test::add_face(ball, {12, 0, 4}, {4, off, 12}, {50, 0, 50});
    const SurfaceOverlay of_ball(ball, octahedron(60.0));
    TriangleMesh socket = octahedron(60.0);
    test::add_face(socket, {12, 0, 4}, {4, off, 12}, {50, 0, 50});
    const SurfaceOverlay of_socket(octahedron(20.0), socket);
    for (const Pose& pose : test::random_poses(100, 3.0, 0.0, 6)) {
      EXPECT_EQ(of_ball.impinged(pose), off > 0.0);
      EXPECT_EQ(of_socket.impinged(pose), off > 0.0);
    }
  }
}

// A turn about an axis that is none of the mesh's rounds a face of the socket out of the plane through the
// centre, to either side of it.
TEST(Overlay, DoesNotFlipFromPoseToPose) {
  const TriangleMesh ball{{{25, -20, -20}, {25, 20, -20}, {25, 0, 30}}, {{0, 1, 2}}};
  const TriangleMesh socket{{{5, -3, 0}, {20, 0, 0}, {5, 3, 0}}, {{0, 1, 2}}};
  const SurfaceOverlay overlay(ball, socket);
  for (int k = 0; k <= 1000; ++k) {
    const Eigen::AngleAxisd turn(0.01 * k * kDegree, Vec3(1, 2, 3).normalized());
    ASSERT_FALSE(overlay.impinged({turn.toRotationMatrix(), Vec3::Zero()})) << k;
  }
}

// A face of the ball that is shifted into a plane through the centre of the socket: its sides and corners are
// beyond the socket, or not.
TEST(Overlay, AFaceThatAPoseMakesEdgeOnIsAsked) {
  const TriangleMesh ball{{{-6, 3, 8}, {6, 3, 8}, {0, 3, 22}}, {{0, 1, 2}}};
  const TriangleMesh wide{{{-9, -9, 20}, {9, -9, 20}, {0, 9, 20}}, {{0, 1, 2}}};
  const TriangleMesh narrow{{{-1, -9, 6}, {1, -9, 6}, {0, 9, 9}}, {{0, 1, 2}}};
  Pose pose;
  pose.translation.y() = -3;
  EXPECT_EQ(SurfaceOverlay(ball, wide).deepest(pose)->kind, OverlayKind::ball_corner);
  EXPECT_TRUE(SurfaceOverlay(ball, narrow).impinged(pose));
  pose.translation.z() = -2.5;
  EXPECT_FALSE(SurfaceOverlay(ball, wide).impinged(pose));
  const TriangleMesh bar{{{-40, 3, 20.5}, {40, 3, 20.5}, {0, 3, 8}},
                         {{0, 1, 2}}};  // no corner over the other
  EXPECT_FALSE(SurfaceOverlay(bar, wide).impinged(pose));
  pose.translation.z() = 0.0;
  EXPECT_EQ(SurfaceOverlay(bar, wide).deepest(pose)->kind, OverlayKind::crossing);
}

TEST(Overlay, TheSocketInTheCentreOfTheBallIsWithinIt) {
  const TriangleMesh ball = octahedron(2.0);
  const TriangleMesh socket{{{-50, -40, 9}, {50, -40, 9}, {0, 60, 9}}, {{0, 1, 2}}};
  Pose pose;
  for (const Vec3& shift :
       {Vec3(0, 0, 9), Vec3(0, -40, 9), Vec3(50, -40, 9)}) {  // inside, on a side, a corner
    pose.translation = shift;
    ASSERT_TRUE(SurfaceOverlay(ball, socket).impinged(pose)) << shift.transpose();
    EXPECT_GE(SurfaceOverlay(ball, socket).deepest(pose)->depth, 2.0);
    EXPECT_TRUE(SurfaceOverlay({ball.vertices, {ball.faces[0]}}, socket).impinged(pose));
    EXPECT_FALSE(SurfaceOverlay({}, socket).impinged(pose));
  }
  // Before the socket but for its centre.
  const TriangleMesh below{{{-2, -2, -1}, {2, -2, -1}, {0, 2, -1}}, {{0, 1, 2}}};
  const auto deepest = SurfaceOverlay(below, socket).deepest({Eigen::Matrix3d::Identity(), {0, 0, 9}});
  ASSERT_TRUE(deepest);
  EXPECT_EQ(deepest->kind, OverlayKind::centre);
  EXPECT_EQ(deepest->depth, 3.0);
  // A ball whose face holds the centre of the socket is not beyond it: 2 mm are less than 9.
  const TriangleMesh small{{{-2, -2, 1}, {2, -2, 1}, {0, 2, 1}}, {{0, 1, 2}}};
  EXPECT_FALSE(SurfaceOverlay(small, socket).impinged({Eigen::Matrix3d::Identity(), {0, 0, -1}}));
}

TEST(HoldsCentre, InsideOnASideAndBetweenCornersOnALine) {
  const auto holds = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    EXPECT_EQ(orientation(a, b, c), 0);
    const bool found = holds_centre({{a, b, c}, 0});
    EXPECT_EQ(holds_centre({{c, a, b}, 0}), found);
    EXPECT_EQ(holds_centre({{b, a, c}, 0}), found);
    return found;
  };
  EXPECT_TRUE(holds({3, 0, 1}, {-1, 2, 0}, {-2, -2, -1}));
  EXPECT_TRUE(holds({3, 0, 1}, {-6, 0, -2}, {1, 1, 1}));
  EXPECT_TRUE(holds({0, 0, 0}, {1, 2, 3}, {3, 2, 1}));
  EXPECT_FALSE(holds({3, 0, 1}, {-1, 2, 0}, {2, 2, 1}));
  EXPECT_FALSE(holds({3, 0, 1}, {6, 0, 2}, {1, 1, 1}));  // a side that points at the centre
  EXPECT_FALSE(holds({1, 0, 1}, {1, 1, 1}, {1, 2, 1}));  // without area, beside the centre
  EXPECT_TRUE(holds({1, 0, 1}, {-2, 0, -2}, {3, 0, 3}));
  EXPECT_TRUE(holds({1, 0, 1}, {0, 0, 0}, {3, 0, 3}));
  EXPECT_FALSE(holds({1, 0, 1}, {2, 0, 2}, {3, 0, 3}));
  EXPECT_FALSE(holds({-1, 0, -1}, {-2, 0, -2}, {-3, 0, -3}));
}

// Radial contact against the intersection of the surfaces, by CGAL (reference/meeting_surfaces.hpp):
//   impinged  <=>  the surfaces meet, or have slipped past each other: the ball meets the wall of the rim, is
//                  beyond the socket as a whole, or holds it as a whole
// Each side of the equivalence is asked where its own frame has rounded the other surface.

constexpr double kReach = 200.0;  // mm, beyond all vertices in all poses

class TheoremSlip : public testing::Test, protected test::Dice {
 protected:
  TheoremSlip() : Dice(17) {}
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
TEST_F(TheoremSlip, ImpingedIsToMeetOrToHaveSlippedPast) {
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
