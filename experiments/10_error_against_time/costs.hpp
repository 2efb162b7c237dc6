// SPDX-License-Identifier: GPL-3.0-or-later
// How the costs of a method are timed and kept, the same for every question.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files/csv.hpp"
#include "harness/timing.hpp"

namespace impinge::lab {

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

}  // namespace impinge::lab
