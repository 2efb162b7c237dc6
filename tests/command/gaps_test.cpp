// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps of generated joints of known gap, through files, as a user asks for them.
#include "joint/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "command/joint_options.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/io.hpp"
#include "reference/closest_point.hpp"
#include "support/command_line.hpp"
#include "support/joined.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"
#include "support/turned.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

const Vec3 kScanned(-86.0, 20.5, -580.25);  // where the scanner saw the joint

class Gaps : public ::testing::Test {
 protected:
  // Writes both meshes about kScanned.
  void write(const TriangleMesh& ball, const TriangleMesh& socket) {
    write_mesh(files_.ball, test::moved(ball, kScanned));
    write_mesh(files_.socket, test::moved(socket, kScanned));
  }
  Json document(const std::string& options = "") const {
    return test::document_of("gaps " + files_.ball.string() + " " + files_.socket.string() + " " + options);
  }
  Session session() const { return load_joint(files_, {}); }

  test::TemporaryFolder folder_;
  JointOptions files_{{}, folder_.path() / "ball.ply", folder_.path() / "socket.ply"};
  GapsRequest asked_;
};

Vec3 place(const Json& at) { return Vec3(at[0], at[1], at[2]); }

TriangleMesh opened_to_the_right(TriangleMesh socket) {
  for (Vec3& v : socket.vertices) v = Vec3(-v.z(), v.y(), v.x());
  return socket;
}

TEST_F(Gaps, ConcentricSpheresHaveTheirGapEverywhere) {
  write(sphere(22.0, 20000), opened_to_the_right(cup(25.0, 80.0, 10000)));
  const Json found = document();
  const Json& report = found["answer"];
  const Json& centre = found["joint"]["centre"];
  EXPECT_LT((place(centre["position"]) - kScanned).norm(), 1e-3);
  EXPECT_NEAR(centre["radius_mm"], 22.0, 1e-3);
  EXPECT_NEAR(report["smallest_gap"]["gap_mm"], 3.0, 0.03);
  EXPECT_EQ(report["impingement"][0]["gap_up_to_mm"], 0.0);
  EXPECT_EQ(report["impingement"][0]["ball"]["vertices"], 0);
  EXPECT_EQ(report["impingement"][1]["gap_up_to_mm"], 4.0);
  // All of the socket: 2 pi R^2 (1 - cos 80).
  EXPECT_NEAR(report["impingement"][1]["socket"]["area_mm2"],
              2.0 * kPi * 625.0 * (1.0 - std::cos(80.0 * kDegree)), 10.0);
  EXPECT_EQ(report["impingement"][1]["socket"]["clock_zones"].size(), 1U);
  EXPECT_TRUE(found["joint"]["warnings"].empty());
}

// Flexion turns about the patient's right-left axis. With +x anterior, +y left and +z superior (ALS) it takes
// the cam of the pair, 130 degrees from the pole of the socket on the side of +x, up under the socket: 60
// degrees bring its top to 70.
TEST_F(Gaps, APoseBringsTheCamUnderTheSocket) {
  const PairShape shape = impinging_cam();
  const BallSocketPair pair = make_ball_socket_pair(12000, shape);
  write(pair.ball, pair.socket);
  const std::string frame = "--centre=-86,20.5,-580.25 --axes ALS";
  const Json at_rest = document(frame)["answer"];
  EXPECT_GT(at_rest["smallest_gap"]["gap_mm"], 3.5);
  EXPECT_EQ(at_rest["impingement"][0]["ball"]["vertices"], 0);
  const Json flexed = document(frame + " --pose flexion=60")["answer"];
  EXPECT_NEAR(flexed["smallest_gap"]["gap_mm"], 4.0 - shape.cam_height, 0.05);
  EXPECT_GT(flexed["impingement"][0]["ball"]["vertices"], 0);
  EXPECT_TRUE(flexed["impingement"][0]["ball"]["clock_zones"].is_null()) << "this socket looks straight up";
  const Vec3 direction = place(flexed["smallest_gap"]["position"]) - kScanned;
  EXPECT_NEAR(to_angles(direction).phi, 70.0 * kDegree, 5.0 * kDegree);
  EXPECT_GT(document(frame + " --pose extension=60")["answer"]["smallest_gap"]["gap_mm"], 3.5);
}

// Of every vertex, whether it has a gap or not.
TEST_F(Gaps, DistancesHoldTheExactOnes) {
  const BallSocketPair pair = make_ball_socket_pair(600, impinging_cam());
  write(pair.ball, pair.socket);
  files_.axes = "ALS";
  asked_.pose = parse_motion("flexion=60");
  Session session = this->session();
  const Joint& joint = session.joint->joint;
  const GapsAnswer found = answer(session, asked_);
  std::vector<Vec3> points;
  for (const Vec3& v : joint.ball.mesh.vertices) points.push_back(to_socket(found.pose, v));
  const std::vector<double> distance = closest_distances(joint.socket.mesh, {.points = points});
  double smallest = distance[0];
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LE(found.ball.distance[i].lower_mm, distance[i]);
    EXPECT_GE(found.ball.distance[i].upper_mm, distance[i]);
    smallest = std::min(smallest, distance[i]);
  }
  EXPECT_LE(found.euclidean_distance().value().smallest_between_mm[0], smallest);
}

// The bound of a socket's vertex is that of the ball's surface where the posed vertex looks at it: rough on
// the upper half of this ball, smooth on the lower one.
TEST_F(Gaps, BoundsOfTheSocketAreThoseOfThePosedBall) {
  const TriangleMesh ball = radial_body(4000, [](const Vec3& u) {
    const double bump = std::sin(20.0 * u.x()) * std::sin(20.0 * u.y());
    return 20.0 + (u.z() > 0.0 ? 1.5 * u.z() * bump : 0.0);
  });
  write(ball, cup(26.0, 80.0, 3000));
  files_.centre = kScanned;
  asked_.precision_deg = 5.0;
  asked_.pose = parse_motion("flexion=90");
  Session session = this->session();
  const Joint& joint = session.joint->joint;
  const GapsAnswer found = answer(session, asked_);
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
TEST_F(Gaps, AnAccuracyIsKeptAndProvenAtEveryVertex) {
  const BallSocketPair pair = make_ball_socket_pair(3000, impinging_cam());
  write(pair.ball, pair.socket);
  files_.centre = kScanned;
  files_.axes = "ALS";
  asked_.pose = parse_motion("flexion=60");
  Session session = this->session();
  const Joint& joint = session.joint->joint;
  const RayCaster socket(joint.socket.mesh);
  for (const double accuracy : {1.0, 0.01, 1e-9}) {
    asked_.max_error_mm = accuracy;
    const GapsAnswer found = answer(session, asked_);
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
    EXPECT_LE(found.error_bound->smallest.high - found.error_bound->smallest.low, 1e-9);
    EXPECT_LE(found.error_bound->largest_mm, accuracy);
    EXPECT_EQ(found.error_bound->unbounded, 0U);
    EXPECT_EQ(found.radial_overlap.value().ball.refuted, 0U);
    EXPECT_FALSE(found.precision_deg);
  }
  asked_.max_error_mm = 1e-15;
  const std::string refusal = test::thrown<std::runtime_error>([&] { answer(session, asked_); });
  EXPECT_NE(refusal.find("max_error: 1e-15 mm is less than rounding leaves"), std::string::npos) << refusal;
}

// Cells that look along a steep flank have bounds of millimetres, or none. The faces decide.
TEST_F(Gaps, TheSmallestGapIsProvenWhereBoundsSayNothing) {
  const TriangleMesh ball =
      radial_body(4000, [](const Vec3& u) { return 22.0 + 10.0 * (1.0 + std::tanh(20.0 * (u.x() - 0.4))); });
  write(ball, cup(44.0, 170.0, 3000));
  files_.centre = kScanned;
  asked_.precision_deg = 2.0;
  Session session = this->session();
  const Joint& joint = session.joint->joint;
  const GapsAnswer found = answer(session, asked_);
  EXPECT_GT(std::ranges::count_if(found.socket.bound, [](double bound) { return bound > 1.0; }), 20);
  const RayCaster oracle(joint.ball.mesh);
  double smallest = HUGE_VAL;
  for (const Vec3& x : joint.socket.mesh.vertices)
    smallest = std::fmin(smallest, x.norm() - oracle.cast(x.normalized(), Layer::farthest));
  const RayCaster socket(joint.socket.mesh);
  for (const Vec3& x : joint.ball.mesh.vertices)
    smallest = std::fmin(smallest, socket.cast(x.normalized(), Layer::nearest) - x.norm());
  EXPECT_NEAR(found.error_bound->smallest.low, smallest, 1e-9);
  EXPECT_NEAR(found.error_bound->smallest.high, smallest, 1e-9);
  EXPECT_GT(found.error_bound->smallest.measured, 20U);
}

TEST_F(Gaps, TablesThatDoNotFitAreRefused) {
  write(sphere(22.0, 500), cup(25.0, 80.0, 300));
  files_.centre = kScanned;
  asked_.precision_deg = 0.0005;
  Session session = this->session();
  const std::string said = test::thrown<std::exception>([&] { answer(session, asked_); });
  EXPECT_NE(said.find("GiB"), std::string::npos) << said;
  EXPECT_NE(said.find("coarser"), std::string::npos) << said;
}

// Both sides of the wall: the near one counts, and the share that is met twice is reported.
TEST_F(Gaps, AThickSocketIsReportedAndItsNearLayerUsed) {
  const TriangleMesh wall = test::joined(cup(25.0, 80.0, 2000), test::inside_out(cup(29.0, 80.0, 2000)));
  write(sphere(22.0, 2000), opened_to_the_right(wall));
  const Json found = document();
  const Json& joint = found["joint"];
  EXPECT_NEAR(found["answer"]["smallest_gap"]["gap_mm"], 3.0, 0.1);
  EXPECT_NEAR(joint["socket"]["directions_met_more_than_once"], 0.5 * (1.0 - std::cos(80.0 * kDegree)), 0.01);
  ASSERT_EQ(joint["warnings"].size(), 2U);
  const std::string pieces = joint["warnings"][0];
  EXPECT_NE(pieces.find("socket.ply: has 2 pieces"), std::string::npos) << pieces;
  const std::string warning = joint["warnings"][1];
  EXPECT_NE(warning.find("socket.ply: rays from the centre meet it more than once in 41"), std::string::npos)
      << warning;
  EXPECT_NE(warning.find("gaps are measured to the nearest layer"), std::string::npos) << warning;
}

// And what is left out, with what that saves; in the document alone.
TEST_F(Gaps, TheWayIsSaid) {
  write(sphere(22.0, 500), cup(25.0, 80.0, 300));
  const auto said = [&](const std::string& options) {
    Session session = this->session();
    return test::asked(gaps_question(), options).ask(session, {}).document;
  };
  EXPECT_EQ(said("")["way"].get<std::string>().find("each vertex is measured on the faces near it"), 0U);
  const Json whole = said("--precision 2");
  EXPECT_EQ(whole["way"].get<std::string>().find("whole tables"), 0U) << whole["way"];
  EXPECT_TRUE(whole["left_out"].empty());
  const Json part = said("--precision 0.1 --outputs gaps");
  EXPECT_EQ(part["way"].get<std::string>().find("tables of what the vertices read"), 0U) << part["way"];
  EXPECT_GT(part["left_out"].at(0)["bytes_saved"].get<double>() +
                part["left_out"].at(1)["bytes_saved"].get<double>(),
            0.0);
}

}  // namespace
}  // namespace impinge
