// SPDX-License-Identifier: GPL-3.0-or-later
// A whole scene on generated joints of known gap, through files, as a user runs it.
#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/io.hpp"
#include "reference/closest_point.hpp"
#include "scene/report.hpp"
#include "support/joined.hpp"
#include "support/scene_run.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"
#include "support/turned.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

const Vec3 kScanned(-86.0, 20.5, -580.25);  // where the scanner saw the joint

class Scene : public ::testing::Test {
 protected:
  // Writes both meshes about kScanned and asks for the default scene.
  SceneOptions joint_of(const TriangleMesh& ball, const TriangleMesh& socket) {
    SceneOptions options;
    options.ball = folder_.path() / "ball.ply";
    options.socket = folder_.path() / "socket.ply";
    options.out = folder_.path() / "out";
    write_mesh(options.ball, test::moved(ball, kScanned));
    write_mesh(options.socket, test::moved(socket, kScanned));
    return options;
  }

  test::TemporaryFolder folder_;
};

TriangleMesh opened_to_the_right(TriangleMesh socket) {
  for (Vec3& v : socket.vertices) v = Vec3(-v.z(), v.y(), v.x());
  return socket;
}

TEST_F(Scene, ConcentricSpheresHaveTheirGapEverywhere) {
  SceneOptions options = joint_of(sphere(22.0, 20000), opened_to_the_right(cup(25.0, 80.0, 10000)));
  const auto report = test::run_scene(options);
  EXPECT_LT((Vec3(report["centre"]["x"], report["centre"]["y"], report["centre"]["z"]) - kScanned).norm(),
            1e-3);
  EXPECT_NEAR(report["centre"]["radius_mm"], 22.0, 1e-3);
  EXPECT_NEAR(report["smallest_gap"]["gap_mm"], 3.0, 0.03);
  EXPECT_EQ(report["impingement"][0]["gap_up_to_mm"], 0.0);
  EXPECT_EQ(report["impingement"][0]["ball"]["vertices"], 0);
  EXPECT_EQ(report["impingement"][1]["gap_up_to_mm"], 4.0);
  // All of the socket: 2 pi R^2 (1 - cos 80).
  EXPECT_NEAR(report["impingement"][1]["socket"]["area_mm2"],
              2.0 * kPi * 625.0 * (1.0 - std::cos(80.0 * kDegree)), 10.0);
  EXPECT_EQ(report["impingement"][1]["socket"]["clock_zones"].size(), 1U);
  EXPECT_TRUE(report["warnings"].empty());
}

// Flexion turns about the patient's right-left axis. With +x anterior, +y left and +z superior (ALS) it takes
// the cam of the pair, 130 degrees from the pole of the socket on the side of +x, up under the socket: 60
// degrees bring its top to 70.
TEST_F(Scene, APoseBringsTheCamUnderTheSocket) {
  const PairShape shape = impinging_cam();
  const BallSocketPair pair = make_ball_socket_pair(12000, shape);
  SceneOptions options = joint_of(pair.ball, pair.socket);
  options.centre = kScanned;
  options.axes = "ALS";
  const auto at_rest = test::run_scene(options);
  EXPECT_GT(at_rest["smallest_gap"]["gap_mm"], 3.5);
  EXPECT_EQ(at_rest["impingement"][0]["ball"]["vertices"], 0);
  options.motion = parse_motion("flexion=60");
  const auto flexed = test::run_scene(options);
  EXPECT_NEAR(flexed["smallest_gap"]["gap_mm"], 4.0 - shape.cam_height, 0.05);
  EXPECT_GT(flexed["impingement"][0]["ball"]["vertices"], 0);
  EXPECT_TRUE(flexed["impingement"][0]["ball"]["clock_zones"].is_null()) << "this socket looks straight up";
  const auto& where = flexed["smallest_gap"]["position"];
  const Vec3 direction = Vec3(where["x"], where["y"], where["z"]) - kScanned;
  EXPECT_NEAR(to_angles(direction).phi, 70.0 * kDegree, 5.0 * kDegree);
  options.motion = parse_motion("extension=60");
  EXPECT_GT(test::run_scene(options)["smallest_gap"]["gap_mm"], 3.5);
}

// Of every vertex, whether it has a gap or not.
TEST_F(Scene, DistancesHoldTheExactOnes) {
  const BallSocketPair pair = make_ball_socket_pair(600, impinging_cam());
  SceneOptions options = joint_of(pair.ball, pair.socket);
  options.axes = "ALS";
  options.motion = parse_motion("flexion=60");
  Session session = load_joint(options);
  const Joint& joint = session.joint->joint;
  const Measurement found = measure(session, options);
  std::vector<Vec3> points;
  for (const Vec3& v : joint.ball.mesh.vertices) points.push_back(to_socket(found.pose, v));
  const std::vector<double> distance = closest_distances(joint.socket.mesh, {.points = points});
  double smallest = distance[0];
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LE(found.ball.distance[i].lower_mm, distance[i]);
    EXPECT_GE(found.ball.distance[i].upper_mm, distance[i]);
    smallest = std::min(smallest, distance[i]);
  }
  const auto report = test::run_scene(options);
  EXPECT_LE(report["euclidean_distance_mm"]["smallest_between"][0], smallest);
}

// The bound of a socket's vertex is that of the ball's surface where the posed vertex looks at it: rough on
// the upper half of this ball, smooth on the lower one.
TEST_F(Scene, BoundsOfTheSocketAreThoseOfThePosedBall) {
  const TriangleMesh ball = radial_body(4000, [](const Vec3& u) {
    const double bump = std::sin(20.0 * u.x()) * std::sin(20.0 * u.y());
    return 20.0 + (u.z() > 0.0 ? 1.5 * u.z() * bump : 0.0);
  });
  SceneOptions options = joint_of(ball, cup(26.0, 80.0, 3000));
  options.centre = kScanned;
  options.precision_deg = 5.0;
  options.motion = parse_motion("flexion=90");
  Session session = load_joint(options);
  const Joint& joint = session.joint->joint;
  const Measurement found = measure(session, options);
  const RayCaster oracle(joint.ball.mesh);
  double largest = 0.0;
  double least_bound = HUGE_VAL;
  for (std::size_t i = 0; i < found.socket.gap.size(); ++i) {
    if (std::isnan(found.socket.gap[i])) continue;
    const Vec3 x = to_ball(found.pose, joint.socket.mesh.vertices[i]);
    const double gap = x.norm() - oracle.cast(x.normalized(), Layer::farthest);
    const double error = std::abs(gap - found.socket.gap[i]);
    ASSERT_LE(error, found.socket.bound[i] + 1e-11) << "vertex " << i;
    largest = std::max(largest, error);
    least_bound = std::min(least_bound, found.socket.bound[i]);
  }
  EXPECT_GT(largest, 0.3) << "the rough half is seen";
  EXPECT_LT(least_bound, 0.5 * largest) << "and so is the smooth one, where the bound is smaller";
}

// On the faces where no table keeps it, and with a proven bound at every vertex.
TEST_F(Scene, AnAccuracyIsKeptAndProvenAtEveryVertex) {
  const BallSocketPair pair = make_ball_socket_pair(3000, impinging_cam());
  SceneOptions options = joint_of(pair.ball, pair.socket);
  options.centre = kScanned;
  options.axes = "ALS";
  options.motion = parse_motion("flexion=60");
  Session session = load_joint(options);
  const Joint& joint = session.joint->joint;
  const RayCaster socket(joint.socket.mesh);
  for (const double accuracy : {1.0, 0.01, 1e-9}) {
    options.max_error_mm = accuracy;
    const Measurement found = measure(session, options);
    std::size_t gaps = 0;
    for (std::size_t i = 0; i < found.ball.gap.size(); ++i) {
      const Vec3 x = to_socket(found.pose, joint.ball.mesh.vertices[i]);
      const double gap = socket.cast(x.normalized(), Layer::nearest) - x.norm();
      ASSERT_EQ(std::isnan(gap), std::isnan(found.ball.gap[i])) << i;
      if (std::isnan(gap)) continue;
      ++gaps;
      EXPECT_LE(found.ball.bound[i], accuracy);
      EXPECT_LE(std::abs(gap - found.ball.gap[i]), found.ball.bound[i] + 1e-11);
    }
    EXPECT_GT(gaps, 100U);
    EXPECT_LE(found.proven->smallest.high - found.proven->smallest.low, 1e-9);
    const auto report = summary(options, *session.joint, found);
    EXPECT_LE(report["error_bound_mm"]["largest"].get<double>(), accuracy);
    EXPECT_EQ(report["error_bound_mm"]["vertices_without_bound"], 0);
    EXPECT_EQ(report["radial_overlap"]["ball"]["bounds_refuted"], 0);
    EXPECT_TRUE(report["precision_deg"].is_null());
  }
  options.max_error_mm = 1e-15;
  const std::string refusal = test::thrown<std::runtime_error>([&] { measure(session, options); });
  EXPECT_NE(refusal.find("option --max-error: 1e-15 mm is less than rounding leaves"), std::string::npos)
      << refusal;
}

// Cells that look along a steep flank have bounds of millimetres, or none. The faces decide.
TEST_F(Scene, TheSmallestGapIsProvenWhereBoundsSayNothing) {
  const TriangleMesh ball =
      radial_body(4000, [](const Vec3& u) { return 22.0 + 10.0 * (1.0 + std::tanh(20.0 * (u.x() - 0.4))); });
  SceneOptions options = joint_of(ball, cup(44.0, 170.0, 3000));
  options.centre = kScanned;
  options.precision_deg = 2.0;
  Session session = load_joint(options);
  const Joint& joint = session.joint->joint;
  const Measurement found = measure(session, options);
  EXPECT_GT(std::ranges::count_if(found.socket.bound, [](double bound) { return bound > 1.0; }), 20);
  const RayCaster oracle(joint.ball.mesh);
  double smallest = HUGE_VAL;
  for (const Vec3& x : joint.socket.mesh.vertices)
    smallest = std::fmin(smallest, x.norm() - oracle.cast(x.normalized(), Layer::farthest));
  const RayCaster socket(joint.socket.mesh);
  for (const Vec3& x : joint.ball.mesh.vertices)
    smallest = std::fmin(smallest, socket.cast(x.normalized(), Layer::nearest) - x.norm());
  EXPECT_NEAR(found.proven->smallest.low, smallest, 1e-9);
  EXPECT_NEAR(found.proven->smallest.high, smallest, 1e-9);
  EXPECT_GT(found.proven->smallest.measured, 20U);
}

TEST_F(Scene, TablesThatDoNotFitAreRefused) {
  SceneOptions options = joint_of(sphere(22.0, 500), cup(25.0, 80.0, 300));
  options.centre = kScanned;
  options.precision_deg = 0.0005;
  Session session = load_joint(options);
  const std::string said = test::thrown<std::exception>([&] { measure(session, options); });
  EXPECT_NE(said.find("GiB"), std::string::npos) << said;
  EXPECT_NE(said.find("coarser"), std::string::npos) << said;
}

// Both sides of the wall: the near one counts, and the share that is met twice is reported.
TEST_F(Scene, AThickSocketIsReportedAndItsNearLayerUsed) {
  const TriangleMesh wall = test::joined(cup(25.0, 80.0, 2000), test::inside_out(cup(29.0, 80.0, 2000)));
  SceneOptions options = joint_of(sphere(22.0, 2000), opened_to_the_right(wall));
  const auto report = test::run_scene(options);
  EXPECT_NEAR(report["smallest_gap"]["gap_mm"], 3.0, 0.1);
  EXPECT_NEAR(report["socket"]["directions_met_more_than_once"], 0.5 * (1.0 - std::cos(80.0 * kDegree)),
              0.01);
  ASSERT_EQ(report["warnings"].size(), 2U);
  const std::string pieces = report["warnings"][0];
  EXPECT_NE(pieces.find("socket.ply: has 2 pieces"), std::string::npos) << pieces;
  const std::string warning = report["warnings"][1];
  EXPECT_NE(warning.find("socket.ply: rays from the centre meet it more than once in 41"), std::string::npos)
      << warning;
  EXPECT_NE(warning.find("gaps are to the nearest layer"), std::string::npos) << warning;
}

}  // namespace
}  // namespace impinge
