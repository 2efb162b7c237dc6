// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/first_contact.hpp"

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "methods/benchmark_scene.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kFaces = 1000;

// Its cells by the names of their columns.
std::map<std::string, std::string> named(const Table& table, const std::vector<Cell>& row) {
  std::map<std::string, std::string> cells;
  for (std::size_t k = 0; k < row.size(); ++k) cells[table.columns[k].name] = row[k].text();
  return cells;
}

// Steps with an exact test of the faces end within the halvings of the proven brackets, of ours and of peers
// alike, and vertices alone touch no sooner than the faces do.
TEST(FirstContact, OfStepsIsThatOfTheBracket) {
  const BenchmarkScene scene = hip_scene("normal", kFaces);
  const std::vector<MadeContact> methods = made_contacts(scene.pair);
  BenchmarkOptions options = quick_benchmark();
  options.seed = 7;
  options.pose_timing.rounds = 1;
  QuestionTable found = make_first_contact_table();
  Progress progress("test", nullptr);
  run_first_contact(scene, methods, /*quick=*/true, options, found, progress);
  std::map<std::string, double> error;
  for (const std::vector<Cell>& row : found.table.rows) {
    const auto cells = named(found.table, row);
    if (cells.at("setting") == "steps of 5 deg") continue;
    error[cells.at("method")] = std::stod(cells.at("error_deg"));
    EXPECT_GE(std::stoi(cells.at("motions")), 2);
    EXPECT_EQ(cells.at("missed"), "0") << cells.at("method");
    EXPECT_EQ(cells.at("bound_deg").empty(), cells.at("method") != "turn_limit");
  }
  EXPECT_LT(error.at("turn_limit"), 1e-5);
  EXPECT_LT(error.at("culled_faces"), 0.002);
  if (error.contains("fcl_collide")) {
    EXPECT_LT(error.at("fcl_collide"), 0.002);
  }
  EXPECT_GT(error.at("culled"), error.at("culled_faces"));
}

}  // namespace
}  // namespace impinge::lab
