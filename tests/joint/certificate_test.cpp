// SPDX-License-Identifier: GPL-3.0-or-later
// A certificate does not depend on how good the gaps are that it starts from.
#include "joint/certificate.hpp"

#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/gap_scan.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

struct Evidence {
  std::vector<double> gap;
  std::vector<double> bound;
  operator GapEvidence() const { return {gap, bound}; }
};

Evidence nothing(const TriangleMesh& mesh) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  return {std::vector<double>(mesh.vertices.size(), unknown),
          std::vector<double>(mesh.vertices.size(), unknown)};
}

TEST(Certificate, IsTheSameWithGoodGapsAndWithNone) {
  const BallSocketPair pair = make_ball_socket_pair(1000, impinging_cam());
  const SurfaceOverlay overlay(pair.ball, pair.socket);
  const auto table = fill_exact(pair.socket, Rsid::with_precision(1.0), Layer::nearest);
  for (const double degrees : {0.0, -50.0}) {
    const Pose pose{Eigen::AngleAxisd(degrees * kDegree, Vec3::UnitY()).toRotationMatrix(), Vec3::Zero()};
    Evidence ball = nothing(pair.ball);
    scan_gaps(table, pair.ball.vertices, pose, Surface::ball, ball.gap);
    ball.bound.assign(ball.gap.size(), 0.2);
    const Certificate known = certify(overlay, pose, ball, nothing(pair.socket));
    const Certificate unknown = certify(overlay, pose, nothing(pair.ball), nothing(pair.socket));
    const bool impinged = degrees < 0.0;
    EXPECT_EQ(known.surfaces_impinged, impinged);
    EXPECT_EQ(known.vertices_impinged(), impinged);
    EXPECT_EQ(known.ball.impinged, unknown.ball.impinged);
    EXPECT_EQ(known.socket.impinged, unknown.socket.impinged);
    EXPECT_LT(known.ball.by_bound.undecided, 20U + pair.ball.vertices.size() / 4);
    EXPECT_LT(known.ball.without_gap, pair.ball.vertices.size());
    EXPECT_EQ(unknown.ball.without_gap, pair.ball.vertices.size());
    EXPECT_EQ(known.ball.refuted, 0U);
    if (!impinged) continue;
    EXPECT_GT(known.ball.by_bound.impinged, 0U);
    EXPECT_NEAR(known.deepest->depth, 1.0, 0.2);
  }
}

// A gap that is wrong by more than its bound is found out.
TEST(Certificate, RefutesABoundThatDoesNotHold) {
  const TriangleMesh ball = sphere(20.0, 100);
  const TriangleMesh socket = sphere(24.0, 100);
  Evidence wrong = nothing(ball);
  wrong.gap[5] = -1.0;
  wrong.bound[5] = 0.5;
  const Certificate found = certify({ball, socket}, {}, wrong, nothing(socket));
  EXPECT_EQ(found.ball.refuted, 1U);
  EXPECT_EQ(found.ball.impinged, 0U);
  EXPECT_FALSE(found.surfaces_impinged);
}

// Surfaces may impinge with every vertex clear; a vertex of no face is no part of them.
TEST(Certificate, TellsSurfacesFromVertices) {
  const TriangleMesh ball{{{-8, 1, 21}, {8, 1, 21}, {0, 1, 10}, {0, 0, 25}}, {{0, 1, 2}}};
  const TriangleMesh socket{{{0, -7, 20}, {0, 7, 20}, {6, 9, 40}}, {{0, 1, 2}}};
  const Certificate found = certify({ball, socket}, {}, nothing(ball), nothing(socket));
  EXPECT_FALSE(found.vertices_impinged());
  EXPECT_TRUE(found.surfaces_impinged);
  EXPECT_EQ(found.ball.without_gap, 3U);
  EXPECT_EQ(found.deepest->kind, OverlayKind::crossing);
}

}  // namespace
}  // namespace impinge
