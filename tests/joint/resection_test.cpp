// SPDX-License-Identifier: GPL-3.0-or-later
// Where a cut of a user's ball, or socket, is refused; what it leaves: tests/motion,
// tests/e2e/test_frames.py.
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "joint/resect.hpp"
#include "mesh/edges.hpp"
#include "mesh/validation.hpp"
#include "support/joined.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

using test::thrown;

Session scanned_hip(const HipParameters& parameters, std::size_t faces = 1500) {
  const Hip hip = make_hip(parameters, faces);
  JointInput input;
  input.ball = {"ball", hip.ball};
  input.socket = {"socket", hip.socket};
  input.centre = Vec3::Zero();
  input.side = Side::right;
  return {assemble_joint(std::move(input)), Side::right, "RAS"};
}

ResectRequest asked(std::string_view motion, double clearance = 0.5) {
  return {{parse_motion(motion)}, clearance};
}

// A head that is longer than wide, in a socket with its centre in front of it: flexion takes the long end to
// the wall that is nearest, within a clearance that the pose of the scan just has.
TEST(SessionResection, LeavesTheBearingSurfaceAlone) {
  HipParameters oval = hip_preset("normal");
  oval.head_axis_ratio = 1.02;
  oval.shift_anterior = 2.0;
  Session session = scanned_hip(oval);
  const Hip hip = make_hip(oval, 1500);
  const TurnLimits limits({hip.ball, hip.socket});
  const double gap = limits.smallest_gap(joint_turn({}, motion_name("flexion"), Side::right), 0.0)->gap_mm;
  const std::string said =
      thrown<std::runtime_error>([&] { answer(session, asked("flexion=60", gap - 0.05)); });
  EXPECT_NE(said.find("the bearing surface of the ball at ("), std::string::npos) << said;
}

ResectRequest asked_of_rim(std::string_view motion, double most_rim_mm = kMostRim) {
  ResectRequest request = asked(motion);
  request.cut = Surface::socket;
  request.rim_mm = most_rim_mm;
  return request;
}

// More than may go of the rim, by little or by much.
TEST(SessionRimResection, LeavesTheBearingSurfaceAlone) {
  Session session = scanned_hip(hip_preset("pincer"));
  const auto refused = [&](const ResectRequest& request) {
    return thrown<std::runtime_error>([&] { answer(session, request); });
  };
  const std::string said = refused(asked_of_rim("flexion=90,internal_rotation=30", 1.0));
  EXPECT_EQ(said.find("the cut would reach the bearing surface of the socket at ("), 0U) << said;
  EXPECT_NE(said.find("), more than 1.0 mm inside its rim; "), std::string::npos) << said;
  EXPECT_NE(refused(asked_of_rim("flexion=110,internal_rotation=60")).find("more than 5.0 mm inside its rim"),
            std::string::npos);
}

// No place is farther inside the rim than half round the sphere, and from once round on all would begin
// again.
TEST(SessionRimResection, MayBeAllowedAsMuchAsOneLikes) {
  Session session = scanned_hip(hip_preset("pincer"));
  for (const double most_rim_mm : {174.5, 175.5, 1e9})
    EXPECT_NO_THROW(answer(session, asked_of_rim("flexion=90,internal_rotation=25", most_rim_mm)));
}

TEST(SessionRimResection, IsNoLeastCut) {
  Session session = scanned_hip(hip_preset("pincer"), 500);
  ResectRequest least = asked_of_rim("flexion=20");
  least.least = true;
  EXPECT_EQ(thrown<std::invalid_argument>([&] { answer(session, least); }),
            "least: applies only to a cut of the ball; cut the ball, or leave it out");
  least.neck_mm = 20.0;
  EXPECT_EQ(thrown<std::invalid_argument>([&] { answer(session, least); }),
            "neck_mm: applies only to a cut of the ball; cut the ball, or leave it out");
  ResectRequest rim = asked("flexion=20");
  rim.rim_mm = 3.0;
  EXPECT_EQ(thrown<std::invalid_argument>([&] { answer(session, rim); }),
            "rim_mm: applies only to a cut of the socket; cut the socket, or leave it out");
}

TEST(SessionResection, SaysThatTheBonesTouchBeforeAnyMotion) {
  Joint joint = scanned_hip(hip_preset("normal")).joint->joint;
  for (Vec3& x : joint.ball.mesh.vertices) x *= 1.25;
  Session session(std::move(joint), Side::right, "RAS");
  EXPECT_EQ(thrown<std::runtime_error>([&] { answer(session, asked("flexion=30")); }).substr(0, 49),
            "the ball meets the socket in the pose of the scan");
}

// Of a femur with its shaft all is tested, and written: the cut, and what continues it.
TEST(SessionResection, CutsAWholeBone) {
  HipParameters cam = hip_preset("cam");
  cam.shaft_length = 200.0;
  Session session = scanned_hip(cam, 6000);
  ASSERT_TRUE(session.joint->joint.ball.taken.has_value());
  const ResectAnswer found = answer(session, asked("flexion=90,internal_rotation=35"));
  EXPECT_LT(found.legs.back().before.low_deg, 35.0);
  EXPECT_EQ(found.depth.size(), found.mesh.vertices.size());
  EXPECT_GT(found.mesh.vertices.size(), session.joint->joint.ball.mesh.vertices.size() - 200);
  EXPECT_TRUE(boundary_edges(found.mesh).empty());
  const TurnLimits after({found.mesh, session.joint->joint.socket.mesh});
  for (const ResectLeg& leg : found.legs)
    EXPECT_EQ(after.first_contact(leg.turn, leg.largest_deg).state, LimitState::free) << describe(leg);
}

// Landmarks turn the ball back from where it was scanned; the cut goes along rays of the scan.
TEST(SessionResection, LiesInTheFrameOfTheFilesWhereLandmarksTurnTheBall) {
  Joint joint = scanned_hip(hip_preset("cam"), 800).joint->joint;
  const Eigen::Matrix3d femur = Eigen::AngleAxisd(0.4, Vec3(1.0, 0.5, -0.2).normalized()).toRotationMatrix();
  for (Vec3& x : joint.ball.mesh.vertices) x = femur * x;
  const std::vector<Vec3> scanned = joint.ball.mesh.vertices;
  AnatomicalFrames frames;
  frames.femur = femur.transpose();
  use_frames(joint, frames);
  Session session(std::move(joint), Side::right, "RAS");
  const ResectAnswer cut = answer(session, asked("flexion=90,internal_rotation=40"));
  double deepest = 0.0;
  for (std::size_t v = 0; v < scanned.size(); ++v) {
    deepest = std::max(deepest, cut.depth[v]);
    const Vec3 before = cut.mesh.vertices[v] + cut.depth[v] * scanned[v].normalized();
    ASSERT_LT((before - scanned[v]).norm(), 1e-6) << v;
  }
  EXPECT_GT(deepest, 0.1);
  const auto on_ray = [&](const Vec3& x) { return cut.deepest->cross(x).norm() < 1e-6 * x.squaredNorm(); };
  EXPECT_TRUE(std::any_of(cut.mesh.vertices.begin(), cut.mesh.vertices.end(), on_ray));
}

Session cam_in_a_wall(const std::function<void(Joint&)>& change) {
  HipParameters cam = hip_preset("cam");
  cam.wall_thickness = 2.0;
  Joint joint = scanned_hip(cam, 1500).joint->joint;
  change(joint);
  return {std::move(joint), Side::right, "RAS"};
}

// A ball that is not closed has a volume of the cut if all it lacks is elsewhere, as here the end of its
// neck.
TEST(SessionResection, SaysWhyThereIsNoVolume) {
  ResectRequest request = asked("flexion=90,internal_rotation=35");
  request.least = true;
  const auto open_neck = [](Joint& joint) {
    TriangleMesh& ball = joint.ball.mesh;
    double farthest = 0.0;
    for (const Vec3& x : ball.vertices) farthest = std::max(farthest, x.norm());
    std::erase_if(ball.faces,
                  [&](const Face& face) { return corner(ball, face, 0).norm() > 0.97 * farthest; });
  };
  Session whole = cam_in_a_wall(open_neck);
  ASSERT_FALSE(validate(whole.joint->joint.ball.mesh).volume);
  const ResectAnswer known = answer(whole, request);
  EXPECT_GT(known.volume_mm3.low, 10.0);
  EXPECT_FALSE(known.volume_why);
  Session open = cam_in_a_wall([&](Joint& joint) {
    open_neck(joint);
    const Vec3 at = 0.3 * *known.deepest;
    const Vec3 across = at.unitOrthogonal();
    test::add_face(joint.ball.mesh, at, at + across, at + at.normalized().cross(across));
  });
  const ResectAnswer unknown = answer(open, request);
  EXPECT_FALSE(known_ends(unknown.volume_mm3));
  EXPECT_FALSE(known_ends(unknown.least->volume_mm3));
  EXPECT_EQ(unknown.volume_why.value().substr(0, 50), "along rays of the cut the ball's mesh is open or n");
  EXPECT_TRUE(std::isnan(unknown.mesh_volume_mm3));
  EXPECT_EQ(unknown.area_mm2.low, known.area_mm2.low);
}

// Of a wall that is inside out the outer side looks to the centre.
TEST(SessionRimResection, LeavesTheBearingSurfaceOfAWallInsideOutAlone) {
  for (const double thickness : {2.0, 20.0}) {
    HipParameters pincer = hip_preset("pincer");
    pincer.wall_thickness = thickness;
    Joint joint = scanned_hip(pincer).joint->joint;
    joint.socket.mesh = test::inside_out(std::move(joint.socket.mesh));
    Session session(std::move(joint), Side::right, "RAS");
    const std::string said = thrown<std::runtime_error>(
        [&] { answer(session, asked_of_rim("flexion=90,internal_rotation=30", 1.0)); });
    EXPECT_EQ(said.find("the cut would reach the bearing surface of the socket at ("), 0U) << said;
  }
}

TEST(SessionResection, SaysWhereTheBallsMeshEnds) {
  Session session = scanned_hip(hip_preset("normal"), 3000);
  Joint joint = session.joint->joint;
  TriangleMesh& ball = joint.ball.mesh;
  std::erase_if(ball.faces, [&](const Face& f) { return corner(ball, f, 0).norm() > 26.0; });
  Session cap(std::move(joint), Side::right, "RAS");
  const std::string said = thrown<std::runtime_error>([&] { answer(cap, asked("flexion=140")); });
  EXPECT_NE(said.find("the ball's mesh ends under the socket from "), std::string::npos) << said;
}

}  // namespace
}  // namespace impinge
