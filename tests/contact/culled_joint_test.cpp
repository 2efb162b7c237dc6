// SPDX-License-Identifier: GPL-3.0-or-later
// Culling changes no answer:
//   impinged(pose)   iff some vertex x of the ball is on or beyond the socket or some y of the socket on or
//   within
//                    the ball, by the exact test of every vertex
//   least_gap(pose)  = the first of the least of all vertices' gaps S - |x|, |y| - B, bit for bit
#include "contact/culled_joint.hpp"

#include <cmath>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "contact/culled_overlay.hpp"
#include "gap/overlay.hpp"
#include "harness/contact_poses.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/every_vertex.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

using namespace lab;

using test::EveryVertex;

// What is kept by reference is no temporary.
static_assert(!std::is_constructible_v<CulledJoint, BallSocketPair>);
static_assert(!std::is_constructible_v<CulledOverlay, BallSocketPair>);

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
      const bool ball = found->scanned == Surface::ball;
      const Vec3 x = ball ? to_socket(pose, joint.ball.vertices[found->vertex])
                          : to_ball(pose, joint.socket.vertices[found->vertex]);
      EXPECT_TRUE(every.impinged(*found, x));
    }
    EXPECT_EQ(culled.least_gap(pose), every.least_gap(pose));
    ++(expected ? seen.touching : seen.free);
  }
  return seen;
}

TEST(TheoremCaps, AnswersAsEveryVertexDoesInRandomPoses) {
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
TEST(TheoremCaps, AnswersAsEveryVertexDoesCloseToContact) {
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
TEST(TheoremCaps, AnswersAsEveryVertexDoesFarOffTheCentre) {
  const BallSocketPair joint = make_ball_socket_pair(100);
  for (const double shift : {21.9, 30.0, 200.0}) {
    std::vector<Pose> poses = test::random_poses(20, 3.0, 1.0, 23);
    for (Pose& pose : poses) pose.translation *= shift / pose.translation.norm();
    expect_all_alike(joint, poses);
  }
}

// More vertices in one of the deepest cells than a node has children.
TEST(TheoremCaps, AnswersAsEveryVertexDoesOfACrowd) {
  const BallSocketPair joint{cup(20.0, 4.0, 800), cup(21.0, 6.0, 800)};
  for (const double turn : {0.0, 0.1}) expect_all_alike(joint, test::random_poses(40, turn, 2.0, 25));
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

// The pose that takes a vertex to the centre of the other surface. A vertex at its own centre is of no face
// that counts.
TEST(CulledJoint, AVertexAtTheCentreIsWithinTheBallAndNeverBeyondTheSocket) {
  const BallSocketPair joint = make_ball_socket_pair(100);
  for (const bool ball : {false, true}) {
    const Vec3& v = (ball ? joint.ball : joint.socket).vertices[7];
    const CulledJoint culled(joint);
    const Vec3 at_centre = Vec3::Zero();
    EXPECT_TRUE(culled.exactly_impinged(Surface::socket, at_centre));
    EXPECT_FALSE(culled.exactly_impinged(Surface::ball, at_centre));
    expect_all_alike(joint, {Pose{Eigen::Matrix3d::Identity(), ball ? Vec3(-v) : v}});
  }
  BallSocketPair centre_in_socket = joint;
  centre_in_socket.socket.vertices[0].setZero();
  EXPECT_FALSE(CulledJoint(centre_in_socket).impinged({}));
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

TriangleMesh in_units(TriangleMesh mesh, double unit) {
  for (Vec3& v : mesh.vertices) v *= unit;
  return mesh;
}

// Neither surface may be longer than a float's square is, whichever is scanned.
TEST(CulledScan, LengthsOfEitherSurfaceAreChecked) {
  const TriangleMesh body = octahedron(20.0);
  const TriangleMesh longest = octahedron(0x1p61);
  EXPECT_NO_THROW(CulledScan(Surface::ball, body, octahedron(26.0)));
  EXPECT_THROW(CulledScan(Surface::ball, body, longest), std::invalid_argument);
  EXPECT_THROW(CulledScan(Surface::ball, longest, body), std::invalid_argument);
}

// All lengths times a power of two: the same answers, or a refusal of one line.
TEST(CulledJoint, UnitsOfAPowerOfTwoAreTheSameBitsOrRefused) {
  const BallSocketPair joint = make_ball_socket_pair(120, impinging_cam());
  const CulledJoint culled(joint);
  for (const int exponent : {-200, -110, -90, -66, -40, -10, 10, 40, 66, 90, 110, 200}) {
    SCOPED_TRACE(exponent);
    const double unit = std::ldexp(1.0, exponent);
    const BallSocketPair scaled{in_units(joint.ball, unit), in_units(joint.socket, unit)};
    try {
      const CulledJoint asked(scaled);
      for (Pose pose : test::random_poses(12, 3.0, 4.0, 8)) {
        const auto impinged = culled.impinged(pose);
        const auto gap = culled.least_gap(pose);
        pose.translation *= unit;
        EXPECT_EQ(asked.impinged(pose).has_value(), impinged.has_value());
        const auto same = asked.least_gap(pose);
        ASSERT_EQ(same.has_value(), gap.has_value());
        EXPECT_EQ(same->gap_mm, unit * gap->gap_mm);
        EXPECT_EQ(same->at, gap->at);
      }
    } catch (const std::exception& refused) {
      EXPECT_EQ(std::string(refused.what()).find('\n'), std::string::npos) << refused.what();
      EXPECT_GT(std::abs(exponent), 40) << refused.what();
    }
  }
}

// Culling changes no answer: impinged(pose) is that of SurfaceOverlay, which compares all faces.

using namespace lab;

// How many poses impinge, and how many of these without a vertex that does.
struct OverlaySeen {
  std::size_t impinged = 0;
  std::size_t between_vertices = 0;
};

OverlaySeen expect_alike(const BallSocketPair& joint, const std::vector<Pose>& poses) {
  const SurfaceOverlay all(joint.ball, joint.socket);
  const CulledJoint vertices(joint);
  const CulledOverlay culled(joint);
  OverlaySeen seen;
  for (const Pose& pose : poses) {
    const bool expected = all.impinged(pose);
    EXPECT_EQ(culled.impinged(pose), expected);
    EXPECT_EQ(culled.impinged(pose, vertices), expected);
    if (!expected) continue;
    ++seen.impinged;
    seen.between_vertices += vertices.impinged(pose) ? 0U : 1U;
  }
  return seen;
}

TEST(TheoremCaps, AnswersAsAllFacesDoInRandomPoses) {
  const BallSocketPair joint = make_ball_socket_pair(300, impinging_cam());
  for (const double shift : {0.0, 2.0, 5.0, 30.0}) {
    const OverlaySeen seen = expect_alike(joint, test::random_poses(6, 3.0, shift, 51));
    EXPECT_GT(seen.impinged, 0U);
  }
}

// Within 10^-5 to 10^-0.5 mm of the first contact of the surfaces, which is one of edges in most.
TEST(TheoremCaps, AnswersAsAllFacesDoCloseToContact) {
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

// A surface whose faces are all edge-on is none, whichever of the two it is.
TEST(TheoremCaps, AnswersAsAllFacesDoOfAnEmptySurface) {
  TriangleMesh edge_on{{{9, 0, 0}, {0, 9, 0}, {-9, -9, 0}}, {{0, 1, 2}}};
  for (const TriangleMesh& none : {TriangleMesh{}, edge_on}) {
    for (const BallSocketPair& joint :
         {BallSocketPair{octahedron(16.0), none}, BallSocketPair{none, octahedron(16.0)}}) {
      EXPECT_EQ(expect_alike(joint, test::random_poses(10, 3.0, 30.0, 54)).impinged, 0U);
      expect_alike(joint, {Pose{}});
    }
  }
}

TEST(CulledOverlay, GrowsWithTheFaces) {
  const auto bytes = [](std::size_t faces) {
    const BallSocketPair joint{sphere(20.0, faces), sphere(24.0, faces)};
    const std::size_t kept = joint.ball.faces.size() + joint.socket.faces.size();
    const std::size_t found = CulledOverlay(joint).bytes();
    EXPECT_GT(found, kept * (sizeof(Face) + sizeof(int) + sizeof(std::uint32_t)));
    return found;
  };
  EXPECT_LT(bytes(800), 10 * bytes(200));
  EXPECT_GT(bytes(800), 3 * bytes(200));
}

TEST(CulledJoint, BytesAreThoseOfItsParts) {
  const BallSocketPair meshes{sphere(20.0, 100), sphere(24.0, 2000)};
  const CulledJoint joint(meshes);
  EXPECT_EQ(joint.bytes(), joint.faces(Surface::ball).bytes() + joint.faces(Surface::socket).bytes() +
                               joint.scans()[0].bytes() + joint.scans()[1].bytes());
}

// Faces wider than any look-up, and two surfaces that touch everywhere.
TEST(TheoremCaps, AnswersAsAllFacesDoOfLargeFaces) {
  for (const double radius : {16.0, 24.0}) {
    const BallSocketPair joint{octahedron(16.0), octahedron(radius)};
    const OverlaySeen seen = expect_alike(joint, test::random_poses(30, 3.0, 4.0, 53));
    EXPECT_GT(seen.impinged, 5U);
    expect_alike(joint, {Pose{}});
  }
}

}  // namespace
}  // namespace impinge
