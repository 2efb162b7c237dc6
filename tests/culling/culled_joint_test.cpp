// SPDX-License-Identifier: GPL-3.0-or-later
// Culling changes no answer:
//   impinged(pose)   iff some vertex x of the ball is on or beyond the socket or some y of the socket on or
//   within
//                    the ball, by the exact test of every vertex
//   least_gap(pose)  = the first of the least of all vertices' gaps S - |x|, |y| - B, bit for bit
#include "culling/culled_joint.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "detection/exact_side.hpp"
#include "mesh/bodies.hpp"
#include "sampling/near_faces.hpp"
#include "sphere/infinity.hpp"
#include "studies/contact_poses.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

// Every vertex of both surfaces, in the order of scans and vertices, with its place in the frame of the other
// one.
template <class Visit>
void for_each_vertex(const BallSocketPair& joint, const Pose& pose, Visit&& visit) {
  for (std::size_t v = 0; v < joint.ball.vertices.size(); ++v)
    visit(ScannedVertex{ScannedSurface::ball, v}, to_socket(pose, joint.ball.vertices[v]));
  for (std::size_t v = 0; v < joint.socket.vertices.size(); ++v)
    visit(ScannedVertex{ScannedSurface::socket, v}, to_ball(pose, joint.socket.vertices[v]));
}

class EveryVertex {
 public:
  explicit EveryVertex(const BallSocketPair& joint)
      : joint_(joint),
        index_{FaceIndex(joint.ball), FaceIndex(joint.socket)},
        near_{NearFaces(joint.ball, 0.0), NearFaces(joint.socket, 0.0)} {}

  bool impinged(const ScannedVertex& at, const Vec3& x) const {
    return at.scanned == ScannedSurface::ball ? on_or_beyond(joint_.socket, index_[1], x)
                                              : on_or_within(joint_.ball, index_[0], x);
  }
  bool impinged(const Pose& pose) const {
    bool found = false;
    for_each_vertex(joint_, pose,
                    [&](const ScannedVertex& at, const Vec3& x) { found = found || impinged(at, x); });
    return found;
  }
  std::optional<LeastGap> least_gap(const Pose& pose) const {
    std::optional<LeastGap> least;
    for_each_vertex(joint_, pose, [&](const ScannedVertex& at, const Vec3& x) {
      const bool ball = at.scanned == ScannedSurface::ball;
      if (x.isZero(0.0)) return;
      const double radius = ball ? near_[1].radius(x.normalized(), Layer::nearest)
                                 : near_[0].radius(x.normalized(), Layer::farthest);
      const double gap = ball ? radius - x.norm() : x.norm() - radius;
      if (gap < (least ? least->gap_mm : kInfinity)) least = LeastGap{gap, at};
    });
    return least;
  }

 private:
  const BallSocketPair& joint_;
  std::array<FaceIndex, 2> index_;
  std::array<NearFaces, 2> near_;
};

// Poses that touch, and poses that do not, of all of them.
struct Seen {
  std::size_t touching = 0;
  std::size_t free = 0;
};

Seen expect_all_alike(const BallSocketPair& joint, const std::vector<Pose>& poses) {
  const CulledJoint culled(joint);
  const EveryVertex every(joint);
  Seen seen;
  for (const Pose& pose : poses) {
    const bool expected = every.impinged(pose);
    const auto found = culled.impinged(pose);
    EXPECT_EQ(found.has_value(), expected);
    if (found) {
      const bool ball = found->scanned == ScannedSurface::ball;
      const Vec3 x = ball ? to_socket(pose, joint.ball.vertices[found->vertex])
                          : to_ball(pose, joint.socket.vertices[found->vertex]);
      EXPECT_TRUE(every.impinged(*found, x));
    }
    EXPECT_EQ(culled.least_gap(pose), every.least_gap(pose));
    ++(expected ? seen.touching : seen.free);
  }
  return seen;
}

TEST(CulledJoint, AnswersAsEveryVertexDoesInRandomPoses) {
  for (const std::size_t faces : {100U, 1000U}) {
    const BallSocketPair joint = make_ball_socket_pair(faces, impinging_cam());
    for (const double shift : {0.0, 1.0, 5.0}) {
      const Seen seen = expect_all_alike(joint, test::random_poses(faces < 1000 ? 24 : 3, 3.0, shift, 21));
      EXPECT_GT(seen.free + (shift > 1.0 ? 1U : 0U), 0U);
      EXPECT_GT(seen.touching, 0U);
    }
  }
}

// Within 10^-5 to 10^-0.5 mm of the first contact.
TEST(CulledJoint, AnswersAsEveryVertexDoesCloseToContact) {
  const BallSocketPair joint = make_ball_socket_pair(300);
  const SurfaceOverlay overlay(joint.ball, joint.socket);
  ContactOptions options;
  options.count = 40;
  options.seed = 22;
  std::vector<Pose> poses;
  for (const ContactPose& one : contact_poses(overlay, options)) poses.push_back(one.pose);
  const Seen seen = expect_all_alike(joint, poses);
  EXPECT_GT(seen.free, 10U);
  EXPECT_GT(seen.touching, 10U);
}

// A translation as long as the vertices' distances leaves no caps to speak of.
TEST(CulledJoint, AnswersAsEveryVertexDoesFarOffTheCentre) {
  const BallSocketPair joint = make_ball_socket_pair(100);
  for (const double shift : {21.9, 30.0, 200.0}) {
    std::vector<Pose> poses = test::random_poses(20, 3.0, 1.0, 23);
    for (Pose& pose : poses) pose.translation *= shift / pose.translation.norm();
    expect_all_alike(joint, poses);
  }
}

// A vertex exactly on the other surface, in either scan, and one beside it by a unit of the last place.
TEST(CulledJoint, ATouchingVertexIsFound) {
  BallSocketPair joint{octahedron(16.0), octahedron(16.0)};
  EXPECT_TRUE(CulledJoint(joint).impinged({}));
  for (Vec3& x : joint.ball.vertices) x *= 1.0 - 0x1p-53;
  EXPECT_FALSE(CulledJoint(joint).impinged({}));
  EXPECT_GT(CulledJoint(joint).least_gap({})->gap_mm, 0.0);
  joint.ball.vertices[3] *= 1.0 + 0x1p-50;
  EXPECT_TRUE(CulledJoint(joint).impinged({}));
}

TEST(CulledJoint, AVertexAtTheCentreIsWithinTheBallAndNeverBeyondTheSocket) {
  const BallSocketPair joint = make_ball_socket_pair(100);
  BallSocketPair centre_in_socket = joint;
  centre_in_socket.socket.vertices[0].setZero();
  EXPECT_EQ(CulledJoint(centre_in_socket).impinged({}), (ScannedVertex{ScannedSurface::socket, 0}));
  expect_all_alike(centre_in_socket, test::random_poses(10, 1.0, 0.5, 24));
  BallSocketPair centre_in_ball = joint;
  centre_in_ball.ball.vertices[0].setZero();
  EXPECT_FALSE(CulledJoint(centre_in_ball).impinged({}));
  expect_all_alike(centre_in_ball, test::random_poses(10, 1.0, 0.5, 24));
}

TEST(CulledJoint, SurfacesThatDoNotMeetHaveNoGap) {
  const BallSocketPair empty{sphere(20.0, 100), {}};
  EXPECT_FALSE(CulledJoint(empty).impinged({}));
  EXPECT_FALSE(CulledJoint(empty).least_gap({}));
  BallSocketPair apart{cup(20.0, 30.0, 50), cup(24.0, 30.0, 50)};
  for (Vec3& x : apart.ball.vertices) x.z() = -x.z();
  EXPECT_FALSE(CulledJoint(apart).impinged({}));
  EXPECT_FALSE(CulledJoint(apart).least_gap({}));
}

// Vertices of no face are of no surface.
TEST(CulledJoint, StrayVerticesAreNotAsked) {
  BallSocketPair joint = make_ball_socket_pair(100);
  joint.ball.vertices.emplace_back(0.0, 0.0, 40.0);
  EXPECT_FALSE(CulledJoint(joint).impinged({}));
}

}  // namespace
}  // namespace impinge
