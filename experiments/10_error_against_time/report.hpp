// SPDX-License-Identifier: GPL-3.0-or-later
// Single vertices on one scene after the other: first the errors, with every bound checked, then the costs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "10_error_against_time/errors.hpp"
#include "files/csv.hpp"
#include "harness/timing.hpp"
#include "methods/gaps.hpp"

namespace impinge::lab {

// How the costs of a method are timed and kept; the same for every question.

inline constexpr double kMicrometres = 1e3;  // in a millimetre
inline constexpr double kNanoseconds = 1e6;  // in a millisecond

// How often and how long everything is timed.
struct BenchmarkTiming {
  int rounds = 7;                                   // of each cost of a method
  double batch_ms = 50.0;                           // one batch of questions takes at most about this long
  double slow_build_ms = 300.0;                     // what takes longer to build is built in one round
  std::size_t flush_bytes = std::size_t{64} << 20;  // written before a cold question
  TimingOptions options = {};                       // of the rounds
};

// The result of one question.
struct QuestionTable {
  Table table;                                     // a row for each method, setting and scene
  TimingRun timing = {};                           // of all scenes
  std::map<std::string, std::string> labels = {};  // of the methods
};
QuestionTable question_table(std::vector<Column> keys, const std::vector<Column>& values);  // without a row

// The query that was built last. It is released before the next is built, so that only one exists.
template <class Query>
using Built = std::shared_ptr<std::optional<Query>>;

// Times everything that is done once for a surface. `make` took first_s seconds before.
template <class Query>
TimedCase build_case(std::vector<Cell> key, const Built<Query>& built, std::function<Query()> make,
                     double first_s, const BenchmarkTiming& timing) {
  TimedCase build;
  build.key = std::move(key);
  build.before = [built] { built->reset(); };
  build.run = [built, make = std::move(make)] { built->emplace(make()); };
  build.rounds = timing.rounds;
  if (1e3 * first_s <= timing.slow_build_ms) return build;
  build.rounds = 1;
  build.expected_s = first_s;
  return build;
}

// The sizes, the points where errors are measured, and how costs are timed.
struct BenchmarkOptions {
  PointSizes sizes;             // of the methods
  ProbeOptions radial;          // of methods that answer radii
  ProbeOptions euclidean;       // of methods that answer distances
  AscentOptions ascent;         // from the worst probes
  std::uint64_t seed = 0;       // for motions
  BenchmarkTiming timing;       // for the costs of single vertices
  BenchmarkTiming gap_timing;   // for all gaps of a pose
  BenchmarkTiming pose_timing;  // for touch, smallest gaps and the first contact of a motion
};

// A benchmark for small machines and short runs.
BenchmarkOptions quick_benchmark();
BenchmarkOptions full_benchmark();  // the complete one

// The results, row by row.
struct BenchmarkTables {
  QuestionTable main;  // error_against_time.csv; keys as in cost_keys()
  Table spread;        // error_against_time_spread.csv
};
BenchmarkTables make_benchmark_tables();  // with columns and no rows
std::vector<Column> cost_keys();          // scene, method, setting and kind of cost

// Adds the rows of all methods on the scene. Throws BoundViolated.
void run_benchmark(const BenchmarkScene& scene, const BenchmarkOptions& options, BenchmarkTables& tables,
                   Progress& progress);

// All gaps of a pose: the error and time of every method, beside the least work that a look-up can do.

// The methods that are tried on a scene.
struct GapPlan {
  GapSizes sizes;         // of the tables
  bool thorough = false;  // ask its methods cold, too, and with every instruction set?
};

QuestionTable make_gap_table();  // all_gaps.csv

// The key columns scene, triangles, direction, method, setting, storage, instruction_set, threads, state.
std::vector<Column> gap_keys();

// Adds the rows of both directions. Throws std::runtime_error if a method's errors make its time meaningless.
void run_all_gaps(const BenchmarkScene& scene, const GapPlan& plan, const BenchmarkOptions& options,
                  QuestionTable& found, Progress& progress);

}  // namespace impinge::lab
