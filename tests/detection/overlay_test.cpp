// SPDX-License-Identifier: GPL-3.0-or-later
// Ball and socket impinge exactly if some face of the ball meets the shadow of some face of the socket, seen
// from either centre (reference/shadow.hpp).
#include "detection/overlay.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "detection/exact_side.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/bodies.hpp"
#include "reference/shadow.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

bool oracle(const TriangleMesh& ball, const TriangleMesh& socket, const Pose& pose) {
  return ShadowReference(test::ball_in_socket_frame(ball, pose), socket).surfaces_impinged() ||
         ShadowReference(ball, test::socket_in_ball_frame(socket, pose)).surfaces_impinged();
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
TEST(Overlay, AgreesWithTheOracleOnBodiesOfAllKinds) {
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
  for (const Vec3& x : ball.vertices) EXPECT_FALSE(on_or_beyond(socket, overlay.socket_index(), x));
  for (const Vec3& y : socket.vertices) EXPECT_FALSE(on_or_within(ball, overlay.ball_index(), y));
  Pose up;
  up.translation.z() = -1.5;
  EXPECT_FALSE(overlay.impinged(up));
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

}  // namespace
}  // namespace impinge
