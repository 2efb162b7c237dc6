// SPDX-License-Identifier: GPL-3.0-or-later
// What of a user's ball, or socket, would have to go, and where a cut is refused.
#include "session/resection.hpp"

#include <utility>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

using test::thrown;

const Vec3 kAt(10.0, -20.0, 30.0);

// A right hip about kAt in a frame LPS.
Session scanned_hip(const HipParameters& parameters, std::size_t faces = 1500) {
  const Hip hip = make_hip(parameters, faces);
  const Eigen::Matrix3d back = input_to_joint("LPS").transpose();
  JointInput input;
  input.ball = {"ball", hip.ball};
  input.socket = {"socket", hip.socket};
  for (TriangleMesh* mesh : {&input.ball.mesh, &input.socket.mesh}) {
    for (Vec3& x : mesh->vertices) x = back * x + kAt;
  }
  input.centre = kAt;
  input.side = Side::right;
  input.axes = "LPS";
  return {assemble_joint(std::move(input)), Side::right, "LPS"};
}

ResectionRequest asked(std::string_view motion, double clearance = 0.5) {
  return {{parse_motion(motion)}, clearance, {}, false};
}

TEST(SessionResection, ReachesWhatIsRequiredInTheFrameOfTheFiles) {
  Session session = scanned_hip(hip_preset("cam"));
  const ResectionAnswer found = answer_resection(session, asked("flexion=90,internal_rotation=30"));
  EXPECT_GT(found.cut.volume_mm3.low, 10.0);
  ASSERT_EQ(found.legs.size(), 2U);
  EXPECT_EQ(found.legs[1].before.state, LimitState::limited);
  for (const ReachedLeg& reached : found.legs) EXPECT_GT(reached.after.low_deg, reached.leg.largest_deg);
  const Vec3 joint_place = found.cut.before.vertices[found.cut.deepest];
  EXPECT_TRUE((input_to_joint("LPS") * (found.deepest - kAt)).isApprox(joint_place, 1e-12));
  ASSERT_TRUE(found.neck);
  EXPECT_GT(found.neck->after, found.neck->least);
  EXPECT_NEAR(found.neck->least, 0.7 * 2.0 * (24.0 - 9.1), 1.0);
}

// A neck that a rim passes stays whole beyond it; and a socket that is a sheet has no such cut.
TEST(SessionResection, LeavesBoneBeyondAWall) {
  HipParameters walled = hip_preset("cam");
  walled.wall_thickness = 2.0;
  ResectionRequest request = asked("flexion=110,internal_rotation=50");
  request.least_neck_mm = 5.0;
  request.least = true;
  Session session = scanned_hip(walled, 500);
  const ResectionAnswer found = answer_resection(session, request);
  ASSERT_TRUE(found.least);
  EXPECT_GT(found.least->volume_mm3.low, 100.0);
  EXPECT_LT(found.least->volume_mm3.high, found.cut.volume_mm3.low);
  EXPECT_LE(found.least->area_mm2.high, found.cut.area_mm2.high);
  EXPECT_FALSE(found.least->cells.empty());
  Session sheet = scanned_hip(hip_preset("cam"), 500);
  EXPECT_EQ(thrown<std::runtime_error>([&] { answer_resection(sheet, request); }).substr(0, 28),
            "the socket is no closed mesh");
}

// With more motions no bone comes back.
TEST(SessionResection, GrowsWithTheMotions) {
  Session session = scanned_hip(hip_preset("cam"));
  const ResectionAnswer one = answer_resection(session, asked("flexion=90,internal_rotation=25"));
  ResectionRequest more = asked("flexion=90,internal_rotation=25");
  more.required.push_back(parse_motion("flexion=90,adduction=15,internal_rotation=25"));
  EXPECT_GT(answer_resection(session, more).cut.volume_mm3.high, one.cut.volume_mm3.low);
}

TEST(SessionResection, IsRefusedWithTheReasonAndThePlace) {
  Session session = scanned_hip(hip_preset("cam"));
  const auto refused = [&](const ResectionRequest& request) {
    return thrown<std::runtime_error>([&] { answer_resection(session, request); });
  };
  EXPECT_EQ(refused(asked("flexion=20", 5.0)).substr(0, 34), "the pose of the scan has a gap of ");
  const std::string thin = refused({{parse_motion("flexion=90,internal_rotation=30")}, 0.5, 60.0, false});
  EXPECT_NE(thin.find("about the axis of the neck at ("), std::string::npos) << thin;
  EXPECT_NE(thin.find("less than 60.0 mm"), std::string::npos) << thin;
  const std::string far = refused(asked("flexion=150,internal_rotation=90"));
  EXPECT_NE(far.find("the axis of the neck at ("), std::string::npos) << far;
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
      thrown<std::runtime_error>([&] { answer_resection(session, asked("flexion=60", gap - 0.05)); });
  EXPECT_NE(said.find("the bearing surface of the ball at ("), std::string::npos) << said;
}

ResectionRequest asked_of_rim(std::string_view motion, double most_rim_mm = kMostRim) {
  ResectionRequest request = asked(motion);
  request.cut = Surface::socket;
  request.most_rim_mm = most_rim_mm;
  return request;
}

HipParameters pincer(double wall_mm) {
  HipParameters parameters = hip_preset("pincer");
  parameters.wall_thickness = wall_mm;
  return parameters;
}

TEST(SessionRimResection, ReachesWhatIsRequiredInTheFrameOfTheFiles) {
  Session session = scanned_hip(pincer(4.0));
  const ResectionAnswer found = answer_resection(session, asked_of_rim("flexion=90,internal_rotation=25"));
  EXPECT_EQ(found.cut.of, Surface::socket);
  EXPECT_GT(found.cut.volume_mm3.low, 10.0);
  EXPECT_LT(found.cut.volume_mm3.high, 100.0);
  ASSERT_EQ(found.legs.size(), 2U);
  EXPECT_EQ(found.legs[1].before.state, LimitState::limited);
  for (const ReachedLeg& reached : found.legs) EXPECT_GT(reached.after.low_deg, reached.leg.largest_deg);
  const Vec3 joint_place = found.cut.before.vertices[found.cut.deepest];
  EXPECT_TRUE((input_to_joint("LPS") * (found.deepest - kAt)).isApprox(joint_place, 1e-12));
  EXPECT_FALSE(found.neck);
}

TEST(SessionRimResection, OfASheetHasNoVolume) {
  Session session = scanned_hip(pincer(0.0));
  const ResectionAnswer found = answer_resection(session, asked_of_rim("flexion=90,internal_rotation=25"));
  EXPECT_GT(found.cut.area_mm2.low, 10.0);
  EXPECT_EQ(found.cut.volume_mm3.high, HUGE_VAL);
}

// More than may go of the rim, by little or by much.
TEST(SessionRimResection, LeavesTheBearingSurfaceAlone) {
  Session session = scanned_hip(pincer(0.0));
  const auto refused = [&](const ResectionRequest& request) {
    return thrown<std::runtime_error>([&] { answer_resection(session, request); });
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
  Session session = scanned_hip(pincer(0.0));
  for (const double most_rim_mm : {174.5, 175.5, 1e9})
    EXPECT_NO_THROW(answer_resection(session, asked_of_rim("flexion=90,internal_rotation=25", most_rim_mm)));
}

TEST(SessionRimResection, IsRefusedWithTheReason) {
  Session session = scanned_hip(pincer(0.0), 500);
  const auto refused = [&](const ResectionRequest& request) {
    return thrown<std::runtime_error>([&] { answer_resection(session, request); });
  };
  ResectionRequest least = asked_of_rim("flexion=20");
  least.least = true;
  EXPECT_EQ(refused(least), "the least cut of all is one of the ball; cut the ball, or leave it out");
  ResectionRequest wide = asked_of_rim("flexion=20");
  wide.clearance_mm = 5.0;
  EXPECT_EQ(refused(wide).substr(0, 34), "the pose of the scan has a gap of ");
}

TEST(SessionResection, SaysThatTheBonesTouchBeforeAnyMotion) {
  Joint joint = scanned_hip(hip_preset("normal")).joint->joint;
  for (Vec3& x : joint.ball.mesh.vertices) x *= 1.25;
  Session session(std::move(joint), Side::right, "LPS");
  EXPECT_EQ(thrown<std::runtime_error>([&] { answer_resection(session, asked("flexion=30")); }).substr(0, 49),
            "the ball meets the socket in the pose of the scan");
}

TEST(SessionResection, SaysWhereTheBallsMeshEnds) {
  Session session = scanned_hip(hip_preset("normal"), 3000);
  Joint joint = session.joint->joint;
  TriangleMesh& ball = joint.ball.mesh;
  std::erase_if(ball.faces, [&](const Face& f) { return corner(ball, f, 0).norm() > 26.0; });
  Session cap(std::move(joint), Side::right, "LPS");
  const std::string said = thrown<std::runtime_error>([&] { answer_resection(cap, asked("flexion=140")); });
  EXPECT_NE(said.find("the ball's mesh ends under the socket from "), std::string::npos) << said;
}

}  // namespace
}  // namespace impinge
