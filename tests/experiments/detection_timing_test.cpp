// SPDX-License-Identifier: GPL-3.0-or-later
#include "03_detection_time/detection_timing.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "support/temporary_folder.hpp"

namespace impinge::lab {
namespace {

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
