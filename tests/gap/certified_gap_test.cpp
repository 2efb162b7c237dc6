// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts of poses, and on which side of a face a point lies, exactly.
#include "gap/certified_gap.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "gap/exact_side.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "reference/shadow.hpp"
#include "support/directions.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

TEST(CertifiedGap, OneImpingedVertexIsEnoughForThePose) {
  EXPECT_EQ((VerdictCount{5, 0, 0}).pose(), Verdict::clear);
  EXPECT_EQ((VerdictCount{5, 0, 1}).pose(), Verdict::undecided);
  EXPECT_EQ((VerdictCount{5, 1, 1}).pose(), Verdict::impinged);
}

TEST(ExactSide, OfTheCentreIsWithinTheBallAndNeverBeyondTheSocket) {
  const TriangleMesh mesh = sphere(20.0, 100);
  const NearFaces faces(mesh, 0.0);
  EXPECT_FALSE(exactly_impinged(Surface::ball, faces, Vec3::Zero()));
  EXPECT_TRUE(exactly_impinged(Surface::socket, faces, Vec3::Zero()));
}

// A vertex of the ball impinges if it is in the shadow of a face of the socket, one of the socket if it is in
// the pyramid of a face of the ball.
TEST(ExactSide, IsThatOfTheOracleInEveryPose) {
  const BallSocketPair joint = make_ball_socket_pair(400, impinging_cam());
  const NearFaces ball_faces(joint.ball, 0.0);
  const NearFaces socket_faces(joint.socket, 0.0);
  std::size_t clear = 0;
  std::size_t impinged = 0;
  const auto check = [&](Surface of, const NearFaces& faces, const TriangleMesh& posed,
                         const std::vector<bool>& expected) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(exactly_impinged(of, faces, posed.vertices[i]), expected[i]) << i;
      ++(expected[i] ? impinged : clear);
    }
  };
  for (const Pose& pose : test::random_poses(60, 3.0, 5.0, 7)) {
    const TriangleMesh ball = test::ball_in_socket_frame(joint.ball, pose);
    check(Surface::ball, socket_faces, ball, ShadowReference(ball, joint.socket).ball_vertices_impinged());
    const TriangleMesh socket = test::socket_in_ball_frame(joint.socket, pose);
    check(Surface::socket, ball_faces, socket,
          ShadowReference(joint.ball, socket).socket_vertices_impinged());
  }
  EXPECT_GT(clear, 1000U);
  EXPECT_GT(impinged, 100U);
}

// At a vertex of the mesh itself the gap is zero: on it is impinged, a unit of the last place before it
// clear.
TEST(ExactSide, TellsNeighbouringDoublesApart) {
  const TriangleMesh mesh = octahedron(16.0);
  const NearFaces faces(mesh, 0.0);
  for (const Vec3& u : test::random_directions(500, 12)) {
    const Vec3 x = u * (octahedron_mesh_radius(u, 16.0));
    EXPECT_TRUE(exactly_impinged(Surface::ball, faces, (1.0 + 0x1p-48) * x));
    EXPECT_FALSE(exactly_impinged(Surface::ball, faces, (1.0 - 0x1p-48) * x));
    EXPECT_FALSE(exactly_impinged(Surface::socket, faces, (1.0 + 0x1p-48) * x));
    EXPECT_TRUE(exactly_impinged(Surface::socket, faces, (1.0 - 0x1p-48) * x));
  }
  for (const Vec3& x : {Vec3(8, 8, 0), Vec3(16, 0, 0), Vec3(4, 4, 8), Vec3(-1, 7, -8)}) {
    EXPECT_TRUE(exactly_impinged(Surface::ball, faces, x));
    EXPECT_TRUE(exactly_impinged(Surface::socket, faces, x));
    const Vec3 less(std::nextafter(x.x(), 0.0), x.y(), x.z());
    EXPECT_FALSE(exactly_impinged(Surface::ball, faces, less));
  }
}

}  // namespace
}  // namespace impinge
