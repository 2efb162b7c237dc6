// SPDX-License-Identifier: GPL-3.0-or-later
// Culling changes no answer: impinged(pose) is that of SurfaceOverlay, which compares all faces.
#include "contact/culled_overlay.hpp"

#include <gtest/gtest.h>

#include "gap/overlay.hpp"
#include "harness/contact_poses.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

using namespace lab;

// How many poses impinge, and how many of these without a vertex that does.
struct OverlaySeen {
  std::size_t impinged = 0;
  std::size_t between_vertices = 0;
};

OverlaySeen expect_alike(const BallSocketPair& joint, const std::vector<Pose>& poses) {
  const SurfaceOverlay all(joint.ball, joint.socket);
  const CulledJoint vertices(joint);
  const CulledOverlay culled(vertices);
  OverlaySeen seen;
  for (const Pose& pose : poses) {
    const bool expected = all.impinged(pose);
    EXPECT_EQ(culled.impinged(pose), expected);
    if (!expected) continue;
    ++seen.impinged;
    seen.between_vertices += vertices.impinged(pose) ? 0U : 1U;
  }
  return seen;
}

TEST(CulledOverlay, AnswersAsAllFacesDoInRandomPoses) {
  const BallSocketPair joint = make_ball_socket_pair(300, impinging_cam());
  for (const double shift : {0.0, 2.0, 5.0, 30.0}) {
    const OverlaySeen seen = expect_alike(joint, test::random_poses(6, 3.0, shift, 51));
    EXPECT_GT(seen.impinged, 0U);
  }
}

// Within 10^-5 to 10^-0.5 mm of the first contact of the surfaces, which is one of edges in most.
TEST(CulledOverlay, AnswersAsAllFacesDoCloseToContact) {
  const BallSocketPair joint = make_ball_socket_pair(300);
  ContactOptions options;
  options.count = 24;
  options.seed = 52;
  std::vector<Pose> poses;
  for (const ContactPose& one : contact_poses(SurfaceOverlay(joint.ball, joint.socket), options))
    poses.push_back(one.pose);
  const OverlaySeen seen = expect_alike(joint, poses);
  EXPECT_GT(seen.impinged, 3U);
  EXPECT_LT(seen.impinged, 21U);
  EXPECT_GT(seen.between_vertices, 0U);
}

// Faces wider than any look-up, and two surfaces that touch everywhere.
TEST(CulledOverlay, AnswersAsAllFacesDoOfLargeFaces) {
  for (const double radius : {16.0, 24.0}) {
    const BallSocketPair joint{octahedron(16.0), octahedron(radius)};
    const OverlaySeen seen = expect_alike(joint, test::random_poses(30, 3.0, 4.0, 53));
    EXPECT_GT(seen.impinged, 5U);
    expect_alike(joint, {Pose{}});
  }
}

}  // namespace
}  // namespace impinge
