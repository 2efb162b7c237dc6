// SPDX-License-Identifier: GPL-3.0-or-later
// Which rim is trusted is one rule: orient takes the angles that measure has, and refuses what it refuses.
#include "joint/orient.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip_presets.hpp"
#include "joint/measures.hpp"
#include "mesh/bodies.hpp"
#include "support/joined.hpp"
#include "support/thrown.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

OrientRequest free_in_flexion(const char* angle) {
  OrientRequest request;
  request.require = {parse_motion(std::string("flexion=") + angle)};
  request.resolution_deg = 3.0;
  return request;
}

MeasureRow measured(Session& session, const std::string& name) {
  for (const MeasureRow& row : answer(session, MeasureRequest{}).measures)
    if (row.name == name) return row;
  return {};
}

TEST(Orient, TurnsTheSocketThatMeasureHasIntoAFreeOne) {
  Session session;
  use_hip(session, hip_preset("cam"));
  const OrientAnswer found = answer(session, free_in_flexion("160"));
  EXPECT_NEAR(found.as_scanned.inclination_deg, measured(session, "inclination").value.value(), 1e-9);
  EXPECT_EQ(found.as_scanned.angles, measured(session, "version").state);
  ASSERT_NE(found.as_scanned.state, CellState::free);
  EXPECT_TRUE(found.by_radii);  // the hip's socket is a sheet
  const NearestFree& nearest = found.nearest_free.value();
  EXPECT_GT(nearest.turn_deg, 1.0);
  EXPECT_LE(nearest.at_least_deg, nearest.turn_deg);
  // The mesh of the socket is free when it is turned so, and as it is it is not.
  const auto flexes = [&](double turn_deg) {
    const Joint& joint = session.joint->joint;
    const Eigen::AngleAxisd turn(turn_deg * kDegree, nearest.axis.value());
    const Eigen::Matrix3d& axes = session.joint->axes;
    const TurnLimits limits(
        {in_joint_frame(*session.joint, joint.ball.mesh),
         test::turned(in_joint_frame(*session.joint, joint.socket.mesh), axes * turn * axes.transpose())});
    return limits.first_contact(joint_turn({}, motion_name("flexion"), session.joint->side), 160.0).state;
  };
  EXPECT_EQ(flexes(nearest.turn_deg), LimitState::free);
  EXPECT_EQ(flexes(0.0), LimitState::limited);
}

TEST(Orient, RefusesARimThatMeasureRefuses) {
  Joint joint;
  joint.ball.mesh = sphere(20.0, 200);
  joint.socket.mesh = test::inside_out(sphere(24.0, 200));
  Session session(std::move(joint), Side::right, "RAS");
  const MeasureRow inclination = measured(session, "inclination");
  ASSERT_EQ(inclination.state.rfind("refused: ", 0), 0U);
  EXPECT_EQ(test::thrown<std::runtime_error>([&] { answer(session, free_in_flexion("90")); }),
            "the socket's inclination is " + inclination.state +
                "; give inclination and anteversion of the socket");
  OrientRequest given = free_in_flexion("90");
  given.inclination_deg = 40.0;
  EXPECT_EQ(test::thrown<std::invalid_argument>([&] { answer(session, given); }),
            "inclination_deg: inclination and anteversion go together; give the other, too, or leave both "
            "out");
  given.anteversion_deg = 15.0;
  const OrientAnswer found = answer(session, given);
  EXPECT_EQ(found.as_scanned.angles, "given");
  EXPECT_EQ(found.nearest_free.value().turn_deg, 0.0);
  EXPECT_FALSE(found.nearest_free->axis);
}

}  // namespace
}  // namespace impinge
