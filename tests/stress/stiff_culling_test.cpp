// SPDX-License-Identifier: GPL-3.0-or-later
// The culled answers over the surfaces of the stiff and extreme families, as ball and as socket. Contract, in
// every pose: impinged() as some vertex by exact signs, least_gap() the least of all vertices bit for bit
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "contact/culled_joint.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/infinity.hpp"
#include "stress/slide.hpp"
#include "stress/stiff_surfaces.hpp"
#include "support/every_vertex.hpp"
#include "support/poses.hpp"

namespace impinge::lab {
namespace {

struct Touches {
  std::size_t touching = 0;
  std::size_t free = 0;
};

void expect_as_every_vertex(const BallSocketPair& joint, const std::vector<Pose>& poses, Touches& seen) {
  const CulledJoint culled(joint);
  const test::EveryVertex every(joint);
  for (const Pose& pose : poses) {
    const bool expected = every.impinged(pose);
    EXPECT_EQ(culled.impinged(pose).has_value(), expected) << pose.translation.transpose();
    EXPECT_EQ(culled.least_gap(pose), every.least_gap(pose)) << pose.translation.transpose();
    ++(expected ? seen.touching : seen.free);
  }
}

// Steps along a motion from none at all and 10^-12 to half a turn and 10^6 mm.
std::vector<Pose> tiny_and_huge_steps() {
  std::vector<Pose> poses(2);
  for (const double step : {1e-12, 1e-6, 1e-2, 0.3}) {
    for (int k = 0; k < 2; ++k) {
      Pose pose = poses.back();
      pose.rotation = pose.rotation * Eigen::AngleAxisd(step, Vec3(0.6, 0.0, -0.8)).toRotationMatrix();
      pose.translation += 2.0 * step * Vec3(0.0, 0.6, 0.8);
      poses.push_back(pose);
    }
  }
  for (const Pose& pose : test::random_poses(3, kPi, 4.0, 3)) poses.push_back(pose);
  for (const double far : {30.0, 1e3, 1e6}) {
    poses.push_back({});
    poses.push_back({Eigen::AngleAxisd(kPi, Vec3::UnitX()).toRotationMatrix(), far * Vec3(0.0, -0.8, 0.6)});
  }
  return poses;
}

// Of the vertices, mm.
struct Lengths {
  double least = kInfinity;
  double largest = 0.0;
};
Lengths lengths_of(const TriangleMesh& mesh) {
  Lengths lengths;
  for (const Vec3& v : mesh.vertices) {
    lengths.least = std::fmin(lengths.least, v.norm());
    lengths.largest = std::fmax(lengths.largest, v.norm());
  }
  return lengths;
}

TriangleMesh times(TriangleMesh mesh, double factor) {
  for (Vec3& v : mesh.vertices) v *= factor;
  return mesh;
}

class StiffJoints : public testing::TestWithParam<test::StiffFamily> {};
INSTANTIATE_TEST_SUITE_P(Families, StiffJoints, testing::ValuesIn(test::stiff_families()), test::name_of);

TEST_P(StiffJoints, AnswerAsEveryVertexAlongTinyAndHugeSteps) {
  const std::vector<Pose> poses = tiny_and_huge_steps();
  const BallSocketPair ordinary = make_ball_socket_pair(120);
  const TriangleMesh stiff = GetParam().make().mesh;
  const Lengths lengths = lengths_of(stiff);
  const double wide = 1.1 * lengths.largest / lengths_of(ordinary.socket).least;
  const double small = 0.5 * lengths.least / lengths_of(ordinary.ball).largest;
  Touches seen;
  expect_as_every_vertex({stiff, times(ordinary.socket, wide)}, poses, seen);
  expect_as_every_vertex({times(ordinary.ball, small), stiff}, poses, seen);
  expect_as_every_vertex({ordinary.ball, stiff}, poses, seen);
  EXPECT_GT(seen.touching, 0U);
  EXPECT_GT(seen.free, 0U);
}

// A vertex that slides along the face of an octahedron and is through it at `contact`: angles there and
// beside it, down to neighbouring doubles.
TEST(StiffCulling, AVertexThatSlidesThroughAFaceTouchesAtTheSameAngle) {
  constexpr double kSocketRadius = 26.0;
  Touches seen;
  for (const double degrees : {10.0, 1e-1, 1e-3, 1e-5}) {
    SCOPED_TRACE(degrees);
    const double contact = -degrees * kDegree;
    const Slide slide = slide_touching_at(contact, kSocketRadius);
    BallSocketPair joint{octahedron(1.0), octahedron(kSocketRadius)};
    joint.ball.vertices[0] = slide.vertex(0.0);
    std::vector<Pose> poses;
    for (const double beside : {-1.0, -1e-3, -1e-6, -1e-9, -1e-14, 0.0, 1e-14, 1e-9, 1e-6, 1e-3, 0.5}) {
      const double angle = contact * (1.0 - beside);
      poses.push_back({Eigen::AngleAxisd(angle, slide.axis).toRotationMatrix(), Vec3::Zero()});
    }
    expect_as_every_vertex(joint, poses, seen);
  }
  EXPECT_GT(seen.touching, 10U);
  EXPECT_GT(seen.free, 10U);
}

}  // namespace
}  // namespace impinge::lab
