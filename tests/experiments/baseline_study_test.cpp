// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: poses lie on either side of an exact contact; verdicts count what differs from the exact answer;
// every method is built, asked and counted as its header says.
#include "18_baselines/baseline_study.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "methods/cgal.hpp"
#include "support/cells.hpp"

namespace impinge::lab {
namespace {

BaselineJoint small_joint() {
  BaselineJoint joint{"small", make_ball_socket_pair(300), {}, {}};
  joint.sizes = {{4.0, 1.0}, {10, 100}, {12}, {20.0, 0.5}, 300.0 * 100.0};
  joint.ways.count = 3;
  joint.points = 150;
  return joint;
}

TEST(BaselinePoses, LieOnEitherSideOfAContact) {
  const BaselineJoint joint = small_joint();
  const auto poses = baseline_poses(joint.meshes, joint.ways);
  ASSERT_EQ(poses.size(), 3U * 14U);
  const auto oracle = make_cgal_tree(joint.meshes.ball, joint.meshes.socket);
  std::size_t touching = 0;
  for (const BaselinePose& judged : poses) {
    EXPECT_EQ(judged.touches, oracle(judged.pose));
    EXPECT_TRUE(judged.touches == (judged.beyond_mm > 0.0) || std::abs(judged.beyond_mm) > 0.5);
    touching += judged.touches ? 1U : 0U;
  }
  const BaselineVerdicts right = judge(oracle, poses);
  EXPECT_EQ(right.false_touches + right.missed_touches, 0U);
  EXPECT_EQ(right.wrong_within_mm, 0.0);
  const Touch yes = [](const Pose&) { return true; };
  const Touch no = [](const Pose&) { return false; };
  EXPECT_EQ(judge(yes, poses).false_touches, poses.size() - touching);
  EXPECT_EQ(judge(yes, poses).missed_touches, 0U);
  EXPECT_EQ(judge(no, poses).missed_touches, touching);
  EXPECT_EQ(judge(no, poses).wrong_within_mm, 4.0);
}

TEST(BaselineMethods, LoseLessWithMoreResolution) {
  const BaselineJoint joint = small_joint();
  const BaselinePoints points = baseline_points(joint.meshes, joint.points);
  EXPECT_LE(points.on_ball.size(), joint.points);
  EXPECT_GT(points.on_socket.size(), 50U);
  for (std::size_t i = 0; i < points.on_socket.size(); ++i)
    EXPECT_LT(points.radius[i], points.on_socket[i].norm());
  const auto methods = cases_of(baseline_methods(), &Method::baseline, joint.meshes, joint.sizes);
  ASSERT_EQ(methods.size(), 7U);
  const auto at = [&methods](std::string_view name, double size) -> const BaselineCase& {
    return *std::ranges::find_if(methods, [&](const auto& m) { return m.name == name && m.size == size; });
  };
  const BaselineCase& coarse = at("maciel_triangles", 10.0);
  const BaselineCase& fine = at("maciel_triangles", 100.0);
  EXPECT_GE(coarse.missed_faces, 200.0) << "100 rays refer to 100 faces at most";
  EXPECT_EQ(fine.missed_faces, 0.0);
  EXPECT_GT(ask(coarse, points).missed, ask(fine, points).missed);
  EXPECT_TRUE(coarse.build) << "as many pairs as are timed at most";
  EXPECT_FALSE(fine.build);
  EXPECT_EQ(fine.work, 100.0 * coarse.work);
  EXPECT_GT(at("rsid", 20.0).missed_faces, 0.0);
  EXPECT_EQ(at("rsid", 0.5).missed_faces, 0.0);
  EXPECT_LT(ask(at("rsid", 0.5), points).rms_mm, ask(at("rsid", 20.0), points).rms_mm);
  EXPECT_GE(at("rsid", 20.0).bytes, 2.0 * 10 * 18 * 8);
  EXPECT_EQ(at("cartesian_field", 12.0).bytes, 12.0 * 12 * 12 * 4);
  EXPECT_TRUE(std::isnan(at("hu_voxels", 1.0).missed_faces));
}

TEST(BaselineStudy, ScalesTheBuildingThatItDoesNotTime) {
  std::ostringstream told;
  Progress progress("test", &told);
  BaselineJoint joint{
      "small", make_ball_socket_pair(100), {{8.0}, {10, 20}, {}, {20.0}, 100.0 * 100.0}, {}, 30};
  joint.ways.count = 1;
  const BaselineTables tables = baseline_tables({joint}, {1, 1, 3.0}, progress);
  ASSERT_EQ(tables.table.rows.size(), 4U);
  const auto cell = [&](std::size_t row, const char* name) { return test::cell(tables.table, row, name); };
  EXPECT_EQ(cell(1, "build_extrapolated"), "no");
  EXPECT_EQ(cell(2, "build_extrapolated"), "yes");
  EXPECT_NEAR(std::stod(cell(2, "build_ms")), 4.0 * std::stod(cell(1, "build_ms")), 1e-9);
  EXPECT_EQ(cell(2, "build_iqr_ms"), "");
  EXPECT_EQ(cell(0, "points"), "") << "a table of voxels is asked for no distance";
  EXPECT_EQ(cell(3, "gives_distance"), "yes");
  EXPECT_EQ(cell(3, "poses"), "14");
}

}  // namespace
}  // namespace impinge::lab
