// SPDX-License-Identifier: GPL-3.0-or-later
// One session answers a page and the program scene alike: the same gaps, bounds and verdicts.
#include "joint/session.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "joint/limits.hpp"
#include "joint/pose_answer.hpp"
#include "joint/poses.hpp"
#include "joint/touch.hpp"
#include "mesh/generated_pair.hpp"

namespace impinge {
namespace {

// With a vertex of no face, and one of a face whose plane holds the centre.
Session session_with_strays() {
  const BallSocketPair pair = make_ball_socket_pair(800, impinging_cam());
  Joint joint;
  joint.ball.mesh = pair.ball;
  joint.socket.mesh = pair.socket;
  auto& [vertices, faces] = joint.ball.mesh;
  vertices.insert(vertices.end(), {{3.0, 4.0, 20.0}, {0.0, 0.0, 21.0}, {0.0, 0.0, 22.0}, {0.0, 1.0, 23.0}});
  const auto last = static_cast<VertexIndex>(vertices.size() - 1);
  faces.push_back({last - 2, last - 1, last});
  return {std::move(joint), std::nullopt, "ALS"};
}

std::vector<double> known(const std::vector<double>& numbers) {
  std::vector<double> found;
  for (const double number : numbers) {
    if (!std::isnan(number)) found.push_back(number);
  }
  return found;
}

TEST(Session, APoseIsAnsweredAlikeWhoeverAsks) {
  Session session = session_with_strays();
  GapsRequest asked;
  asked.precision_deg = 2.0;
  asked.pose.flexion = 60.0;
  const GapsAnswer measured = answer(session, asked);
  EXPECT_EQ(session.tables.settings.scheme, asked.scheme_name())
      << "whose tables are those of the session now";
  const GapsAnswer posed = answer_pose(session, {asked.pose, Vec3::Zero(), asked.cartilage_mm});
  for (const Surface of : kSurfaces) {
    EXPECT_EQ(known(posed.of(of).gap), known(measured.of(of).gap));
    EXPECT_EQ(posed.of(of).bone.area_mm2, measured.of(of).bone.area_mm2);
    EXPECT_EQ(posed.of(of).cartilage.vertices, measured.of(of).cartilage.vertices);
  }
  const PoseVerdicts verdicts = answer_verdicts(session, {asked.pose, Vec3::Zero(), asked.cartilage_mm});
  for (std::size_t k = 1; k <= 4; ++k)
    EXPECT_TRUE(std::isnan(*(measured.ball.gap.end() - static_cast<long>(k))));
  EXPECT_LT(measured.smallest_gap->gap_mm, 0.0);
  EXPECT_EQ(posed.smallest_gap->gap_mm, measured.smallest_gap->gap_mm);
  EXPECT_EQ(verdicts.largest_mm, measured.error_bound->largest_mm);
  EXPECT_EQ(verdicts.smallest.low, measured.error_bound->smallest.low);
  VerdictCount by_bound = measured.radial_overlap->ball.by_bound;
  by_bound += measured.radial_overlap->socket.by_bound;
  EXPECT_EQ(verdicts.vertices.impinged, by_bound.impinged);
  EXPECT_EQ(verdicts.vertices.undecided, by_bound.undecided);
  EXPECT_EQ(verdicts.vertices.clear, by_bound.clear);
}

// A shift moves the ball's centre; back again everything is as before.
TEST(Session, AShiftIsTakenBack) {
  Session session = session_with_strays();
  fill_tables(session, {.scheme = "cube_gnomonic", .precision_deg = 2.0});
  const GapsAnswer before = answer_pose(session, {});
  const GapsAnswer shifted = answer_pose(session, {{}, Vec3(0.0, 0.0, 1.0), 4.0});
  EXPECT_NEAR(shifted.smallest_gap->gap_mm, before.smallest_gap->gap_mm - 1.0, 0.3);
  EXPECT_EQ(known(answer_pose(session, {}).socket.gap), known(before.socket.gap));
}

// Whatever was asked before, or refused: abduction needs a side.
TEST(Session, AShiftIsOfOneQuestion) {
  Session session = session_with_strays();
  const double gap = answer(session, TouchRequest()).smallest_gap->gap_mm;
  const Vec3 shift(0.0, 0.0, 1.0);
  const LimitsAnswer limits = answer(session, LimitsRequest{{"flexion"}, {}, 10.0, shift});
  EXPECT_EQ(limits.limits[0].centre_of_rotation, shift);
  EXPECT_TRUE(session.joint->shift.isZero(0.0));
  EXPECT_THROW(answer(session, LimitsRequest{{"abduction"}, {}, 10.0, shift}), std::invalid_argument);
  EXPECT_TRUE(session.joint->shift.isZero(0.0));
  fill_tables(session, {.scheme = "cube_gnomonic", .precision_deg = 4.0});
  answer_pose(session, {{}, shift, 4.0});
  EXPECT_EQ(answer(session, TouchRequest()).smallest_gap->gap_mm, gap);
  answer_pose(session, {{}, shift, 4.0});
  EXPECT_NEAR(answer(session, GapsRequest()).smallest_gap->gap_mm, gap, 1e-9);
}

// A vertex of no face that lies on the socket says nothing of the distance between the bones.
TEST(Session, DistancesAreThoseOfSurfaces) {
  Session session = session_with_strays();
  const auto smallest = [](Session& of) {
    GapsRequest request;
    request.outputs = {Output::distances};
    return answer(of, request).euclidean_distance()->smallest_between_mm;
  };
  Joint joint = session.joint->joint;
  joint.ball.mesh.vertices.push_back(joint.socket.mesh.vertices.front());
  Session more(std::move(joint), std::nullopt, "ALS");
  EXPECT_GT(smallest(session)[0], 0.1);
  EXPECT_EQ(smallest(more), smallest(session));
  GapsRequest request;
  request.outputs = {Output::distances};
  const auto distance = answer(session, request).ball.distance;
  const std::size_t last = distance.size() - 1;
  EXPECT_TRUE(std::isnan(distance[last - 3].upper_mm)) << "of no face";
  for (std::size_t v = last - 2; v <= last; ++v) EXPECT_LT(distance[v].upper_mm, 10.0) << "of a face edge-on";
}

// As everywhere, vertices that are on no face, or on none but edge-on ones, have no gap.
TEST(Session, AreasOfPosesAreOfVerticesOnTheSurface) {
  Session session = session_with_strays();
  const SessionJoint& joint = *session.joint;
  const PoseSeries series(joint, {.outputs = {PosesOutput::areas}, .cartilage_mm = 100.0});
  const GapsAnswer gaps = answer(session, GapsRequest());
  ASSERT_EQ(gaps.ball.gap.size(), joint.ball.area.size());
  double area = 0.0;
  for (std::size_t v = 0; v < gaps.ball.gap.size(); ++v)
    area += std::isnan(gaps.ball.gap[v]) ? 0.0 : joint.ball.area[v];
  EXPECT_NEAR(series.answer({}).areas->cartilage_ball_mm2, area, 1e-6 * area);
}

}  // namespace
}  // namespace impinge
