// SPDX-License-Identifier: GPL-3.0-or-later
// A vertex asked alone, on one scene after the other: errors first, with every bound checked, then the costs.
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

// How the costs of a method are timed and kept, the same for every question.

inline constexpr double kMicrometres = 1e3;  // in a millimetre
inline constexpr double kNanoseconds = 1e6;  // in a millisecond

// How often and how long everything is timed.
struct BenchmarkTiming {
  int rounds = 7;                                   // of each cost of a method
  double batch_ms = 50.0;                           // one batch of questions takes about so long at most
  double slow_build_ms = 300.0;                     // what is slower to build is built in one round
  std::size_t flush_bytes = std::size_t{64} << 20;  // written before a cold question
  TimingOptions options = {};                       // of the rounds
};

// What comes out of one question.
struct QuestionTable {
  Table table;                                     // a row a method, setting and scene
  TimingRun timing = {};                           // of all scenes
  std::map<std::string, std::string> labels = {};  // of the methods
};
QuestionTable question_table(std::vector<Column> keys, const std::vector<Column>& values);  // without a row

// What was built last: let go before the next is built, so that one alone is there.
template <class Query>
using Built = std::shared_ptr<std::optional<Query>>;

// Everything that is done once for a surface, by `make`, which took first_s seconds before.
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

// What runs, where errors are measured, and how costs are timed.
struct BenchmarkOptions {
  PointSizes sizes;             // of the methods
  ProbeOptions radial;          // of methods that answer radii
  ProbeOptions euclidean;       // of methods that answer distances
  AscentOptions ascent;         // from the worst probes
  std::uint64_t seed = 0;       // of motions
  BenchmarkTiming timing;       // of the costs of a vertex asked alone
  BenchmarkTiming gap_timing;   // of those of all gaps of a pose
  BenchmarkTiming pose_timing;  // of touch, of smallest gaps, and of the first contact of a motion
};

// What small machines and short runs can do, and the whole of it.
BenchmarkOptions quick_benchmark();
BenchmarkOptions full_benchmark();  // the latter

// The results, row by row.
struct BenchmarkTables {
  QuestionTable main;  // error_against_time.csv; keys as in cost_keys()
  Table spread;        // error_against_time_spread.csv
};
BenchmarkTables make_benchmark_tables();  // with their columns, and no row
std::vector<Column> cost_keys();          // scene, method, setting and which cost

// All methods on the scene: adds their rows. Throws BoundViolated.
void run_benchmark(const BenchmarkScene& scene, const BenchmarkOptions& options, BenchmarkTables& tables,
                   Progress& progress);

// All gaps of a pose: how far off they are by every method and how fast they are found, beside the least that
// a look-up can do.

// What is tried on a scene.
struct GapPlan {
  GapSizes sizes;         // of the tables
  bool thorough = false;  // are its methods asked cold, too, and with every instruction set?
};

QuestionTable make_gap_table();  // all_gaps.csv

// scene, triangles, direction, method, setting, storage, instruction_set, threads, state.
std::vector<Column> gap_keys();

// Both directions: adds their rows. std::runtime_error for a method whose errors are too large for its time
// to mean anything.
void run_all_gaps(const BenchmarkScene& scene, const GapPlan& plan, const BenchmarkOptions& options,
                  QuestionTable& found, Progress& progress);

}  // namespace impinge::lab
