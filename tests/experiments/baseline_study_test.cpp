// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: poses lie on either side of an exact contact; verdicts count what differs from the exact answer.
#include "18_baselines/baseline_study.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "03_detection_time/detection_timing.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/cgal.hpp"
#include "support/temporary_folder.hpp"

namespace impinge::lab {
namespace {

TEST(BaselinePoses, LieOnEitherSideOfAContact) {
  BaselineJoint joint{"small", make_ball_socket_pair(300), {}, {}};
  joint.ways.count = 3;
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

// A method that misses a contact must not be timed.
TEST(DetectionTiming, AWrongMethodEndsTheMeasurement) {
  const test::TemporaryFolder folder;
  DriverRun driver{{"test", "test", "quick", 1, folder.path()}, {}, Progress("test", nullptr)};
  std::vector<BenchmarkJoint> joints;
  joints.push_back(make_benchmark_joint(make_ball_socket_pair(100), {100}, 2.0));
  joints[0].methods.push_back({{"blind"}, [](const Pose&) { return false; }});
  EXPECT_THROW(write_benchmark(driver, {}, {}, joints, {}), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace impinge::lab
