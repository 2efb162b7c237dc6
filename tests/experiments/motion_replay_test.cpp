// SPDX-License-Identifier: GPL-3.0-or-later
// A head of 22 mm with a bump of 3 mm in a socket of 26 mm, turned so that the socket looks lateral and
// abduction brings the bump under it, at 12 o'clock. Contract: where the bump is under the socket
//   gap = 26 - 22 - 3 cos^2(pi/2 * a / 30 degrees)     a degrees from its top
// and 4 mm elsewhere, up to the faces' chords (0.1 mm here).
#include "21_motion_frames/motion_replay.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "support/cells.hpp"

namespace impinge::lab {
namespace {

using test::cell;
using test::number;

constexpr double kChords = 0.1;  // mm
constexpr double kAbduction = 80.0;

// The pole of the socket (+z) to medial of a right hip (-x), the bump (at azimuth +x) to superior.
TriangleMesh turned(TriangleMesh mesh) {
  for (Vec3& x : mesh.vertices) x = Vec3(-x.z(), x.y(), x.x());
  return mesh;
}

ReplayedHip hip() {
  BallSocketPair pair = make_ball_socket_pair(3000);
  return {"bumped", Side::right, turned(std::move(pair.ball)), turned(std::move(pair.socket))};
}

const ReplayTables& replayed() {
  static const ReplayTables once = [] {
    ReplayTables tables = replay_tables();
    replay(hip(), {{"abduction", kAbduction}}, {.precision_deg = 1.0, .step_deg = 25.0}, tables);
    return tables;
  }();
  return once;
}

TEST(MotionReplay, GoesEvenlyToTheAngleRecorded) {
  const Table& frames = replayed().frames;
  ASSERT_EQ(frames.rows.size(), 5U);
  const std::vector<double> angles{0.0, 20.0, 40.0, 60.0, 80.0};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(number(frames, k, "angle_deg"), angles[k]);
    EXPECT_EQ(cell(frames, k, "at_end"), k == 4 ? "yes" : "no");
    EXPECT_EQ(cell(frames, k, "motion"), k == 0 ? "neutral" : "abduction");
  }
}

// Moved forward by d, the head is within 4 - d of the socket in front, and the bump stays outside.
TEST(HipScan, OfTheBallMovedForward) {
  const ReplayedHip bumped = hip();
  const PosedHip posed = scan(hip_scanner(bumped, 1.0), {Eigen::Matrix3d::Identity(), 5.0 * Vec3::UnitY()});
  EXPECT_NEAR(posed.ball.within(0.0).smallest_gap, -1.0, 2 * kChords);
}

TEST(MotionReplay, FindsTheBumpWhereItComesUnderTheSocket) {
  const Table& frames = replayed().frames;
  EXPECT_NEAR(number(frames, 0, "smallest_gap_mm"), 4.0, kChords);
  EXPECT_NEAR(number(frames, 4, "smallest_gap_mm"), 1.0, kChords);
  const double hours = number(frames, 4, "clock_hours");
  EXPECT_LT(std::min(hours, 12.0 - hours), 0.25);
}

// Within 2 mm: where the bump is 2 mm high or higher, a cap of 11.75 degrees about its top, on the ball at
// some 24 mm from the centre. Its top is 50 degrees from the axis, so the zone reaches asin(sin 11.75 / sin
// 50) = 15.4 degrees, half an hour, to either side.
TEST(MotionReplay, ToldInHoursAndArea) {
  const Table& zones = replayed().zones;
  std::size_t found = 0;
  for (std::size_t k = 0; k < zones.rows.size(); ++k) {
    if (cell(zones, k, "within_mm") != "2" || cell(zones, k, "motion") != "abduction") continue;
    EXPECT_GT(number(zones, k, "angle_deg"), 31.0) << "that part of the bump is not under the socket yet";
    if (cell(zones, k, "at_end") != "yes" || cell(zones, k, "surface") != "ball") continue;
    ++found;
    EXPECT_NEAR(number(zones, k, "from_hours"), 11.375, 0.126);
    EXPECT_NEAR(number(zones, k, "to_hours"), 0.625, 0.126);
    const double cap = 2.0 * kPi * 24.5 * 24.5 * (1.0 - std::cos(11.75 * kPi / 180.0));
    EXPECT_NEAR(number(zones, k, "area_mm2"), cap, 0.2 * cap);
  }
  EXPECT_EQ(found, 1U);
}

TEST(MotionReplay, RefusesASocketWithoutADial) {
  ReplayTables tables = replay_tables();
  BallSocketPair pair = make_ball_socket_pair(100);  // looks straight up
  const ReplayedHip vertical{"vertical", Side::right, std::move(pair.ball), std::move(pair.socket)};
  EXPECT_THROW(replay(vertical, {}, {.precision_deg = 10.0}, tables), std::invalid_argument);
}

}  // namespace
}  // namespace impinge::lab
