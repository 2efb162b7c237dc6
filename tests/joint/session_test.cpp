// SPDX-License-Identifier: GPL-3.0-or-later
// One session answers a page and the program scene alike: the same gaps, bounds and verdicts.
#include "joint/session.hpp"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "joint/measurement.hpp"
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
  PoseQuestion asked;
  asked.precision_deg = 2.0;
  asked.motion.flexion = 60.0;
  const Measurement measured = measure(session, asked);
  EXPECT_EQ(session.tables.settings.scheme, asked.scheme) << "whose tables are those of the session now";
  const PoseAnswer answer = answer_pose(session, {asked.motion, Vec3::Zero(), asked.cartilage_mm});
  const PoseVerdicts verdicts = answer_verdicts(session, {asked.motion, Vec3::Zero(), asked.cartilage_mm});
  for (const Surface of : kSurfaces) {
    EXPECT_EQ(known(answer.of(of).gap), known(measured.of(of).gap));
    EXPECT_EQ(answer.of(of).bone.impinged_area, measured.of(of).bone.impinged_area);
    EXPECT_EQ(answer.of(of).cartilage.impinged, measured.of(of).cartilage.impinged);
  }
  for (std::size_t k = 1; k <= 4; ++k)
    EXPECT_TRUE(std::isnan(*(answer.ball.gap.end() - static_cast<long>(k))));
  EXPECT_LT(answer.smallest->gap_mm, 0.0);
  EXPECT_EQ(answer.smallest->gap_mm, measured.smallest->gap_mm);
  EXPECT_EQ(verdicts.largest_mm, measured.proven->largest_mm);
  EXPECT_EQ(verdicts.smallest.low, measured.proven->smallest.low);
  VerdictCount by_bound = measured.certificate->ball.by_bound;
  by_bound += measured.certificate->socket.by_bound;
  EXPECT_EQ(verdicts.vertices.impinged, by_bound.impinged);
  EXPECT_EQ(verdicts.vertices.undecided, by_bound.undecided);
  EXPECT_EQ(verdicts.vertices.clear, by_bound.clear);
}

// A shift moves the ball's centre; back again everything is as before.
TEST(Session, AShiftIsTakenBack) {
  Session session = session_with_strays();
  fill_tables(session, {.scheme = "cube_gnomonic", .precision_deg = 2.0});
  const PoseAnswer before = answer_pose(session, {});
  const PoseAnswer shifted = answer_pose(session, {{}, Vec3(0.0, 0.0, 1.0), 4.0});
  EXPECT_NEAR(shifted.smallest->gap_mm, before.smallest->gap_mm - 1.0, 0.3);
  EXPECT_EQ(known(answer_pose(session, {}).socket.gap), known(before.socket.gap));
}

}  // namespace
}  // namespace impinge
