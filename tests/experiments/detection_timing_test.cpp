// SPDX-License-Identifier: GPL-3.0-or-later
#include "03_detection_time/detection_timing.hpp"

#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "files/file_bytes.hpp"
#include "mesh/generated_pair.hpp"
#include "support/temporary_folder.hpp"

namespace impinge::lab {
namespace {

using test::TemporaryFolder;

DriverRun driver_in(const std::filesystem::path& folder) {
  return {{"test", "test", "quick", 1, folder}, {}, Progress("test", nullptr)};
}

// Lines of a CSV without its header, split at commas.
std::vector<std::vector<std::string>> rows_of(const std::filesystem::path& csv) {
  std::istringstream text(read_bytes(csv));
  std::vector<std::vector<std::string>> rows;
  std::string line;
  for (std::getline(text, line); std::getline(text, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

TEST(DetectionTiming, PairwiseBeyondTheLimitIsScaledByThePairs) {
  const TemporaryFolder folder;
  DriverRun driver = driver_in(folder.path());
  std::vector<BenchmarkJoint> joints;
  for (const std::size_t n : {100U, 200U}) {
    joints.push_back(make_benchmark_joint(make_ball_socket_pair(n), {n}, 2.0));
  }
  Result result;
  result.name = "benchmark";
  DetectionOptions options;
  options.most_pairs = 1e4;
  write_benchmark(driver, result, {{"method", "", ""}, {"triangles", "1", ""}}, joints, options);

  const auto rows = rows_of(folder.path() / "benchmark.csv");
  ASSERT_EQ(rows.size(), 8U);
  EXPECT_EQ(rows[0][0], "pairwise");
  EXPECT_EQ(rows[0][5], "no");
  EXPECT_EQ(rows[4][0], "pairwise");
  EXPECT_EQ(rows[4][1], "200");
  EXPECT_EQ(rows[4][4], rows[0][4]);
  EXPECT_EQ(rows[4][5], "yes");
  EXPECT_EQ(rows[4][6], rows[0][6]);
  EXPECT_DOUBLE_EQ(std::stod(rows[4][2]), 4.0 * std::stod(rows[0][2]));
  for (const auto& row : rows) EXPECT_EQ(row[8], row[0].ends_with("sid") ? "yes" : "no");
  EXPECT_EQ(rows_of(folder.path() / "benchmark_samples.csv").size(), 7U * 15U);
}

// A method that misses a contact must not be timed.
TEST(DetectionTiming, AWrongMethodEndsTheMeasurement) {
  const TemporaryFolder folder;
  DriverRun driver = driver_in(folder.path());
  std::vector<BenchmarkJoint> joints;
  joints.push_back(make_benchmark_joint(make_ball_socket_pair(100), {100}, 2.0));
  joints[0].methods.push_back({{"blind"}, [](const Pose&) { return false; }});
  EXPECT_THROW(write_benchmark(driver, {}, {}, joints, {}), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace impinge::lab
