// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Which methods miss the first contact of a turn, which report a false one, and how fast are they?
// @writes    turns turn_time turn_time_samples
// @timing    yes
// @seconds   5 600
// @reads     28_turns/turns.py 28_turns/pairs.py 28_turns/meshes.py 28_turns/exact.py
// @links     harness limits method_cgal turns_methods steps_methods
//
// The test set of turns (README.md) has pairs of features and of meshes with the exact angle at which they
// first meet, from easy to degenerate; IMPINGE_TURNS in the environment names the folder of another set. The
// run fails if one of our methods misses a contact. Times are for the first queries of each kind.

#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "28_turns/turn_set.hpp"
#include "28_turns/turn_study.hpp"
#include "files/stopwatch.hpp"
#include "harness/driver.hpp"
#include "harness/timing.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr TurnSetSizes kQuick{1, 72, 9};
constexpr TurnSetSizes kFull{1, 10'000, 200};
constexpr std::size_t kTimedPairs = 360;  // queries of a kind that are timed
constexpr std::size_t kTimedMeshes = 36;

// The prepared queries of one kind with which a setting is timed.
struct Prepared {
  std::vector<FindTurn> asked;
  double building_us = 0.0;  // per query
  double seconds = 0.0;      // for all of them once
  double typical_us = 0.0;   // for one query, the median
  void run() const {
    for (const FindTurn& find : asked) benchmark::DoNotOptimize(find());
  }
};

using Tallies = std::map<std::pair<std::string, std::string>, TurnTally>;  // by kind and family

Tallies tally_of(const TurnCase& one, const std::vector<KnownTurn>& turns) {
  Tallies tallies;
  for (const KnownTurn& turn : turns) {
    if (!one.takes(turn.query.kind)) continue;
    TurnTally& tally = tallies[{turn.kind, turn.family}];
    tally.add(turn, one.make(turn.query)());
    if (tally.missed > 0 && one.name.starts_with("turn_"))
      throw std::runtime_error(one.name + " misses " + tally.missed_first);
  }
  return tallies;
}

Prepared prepared(const TurnCase& one, const std::vector<const KnownTurn*>& turns) {
  Prepared made;
  Stopwatch watch;
  for (const KnownTurn* turn : turns) made.asked.push_back(one.make(turn->query));
  made.building_us = 1e6 * watch.lap_s() / static_cast<double>(turns.size());
  made.run();
  made.seconds = watch.lap_s();
  std::vector<double> each;
  for (const FindTurn& find : made.asked) {
    benchmark::DoNotOptimize(find());
    each.push_back(1e6 * watch.lap_s());
  }
  made.typical_us = summarise(each).median;
  return made;
}

std::vector<Column> time_keys() {
  return {{"kind", "", "vertex_face, edge_edge, face_face or mesh"},
          {"method", "", "as in turns.csv"},
          {"setting", "", "as in turns.csv"}};
}

std::vector<const KnownTurn*> first_of(const std::vector<KnownTurn>& turns, const std::string& kind) {
  std::vector<const KnownTurn*> some;
  for (const KnownTurn& turn : turns) {
    if (turn.kind == kind && some.size() < (kind == "mesh" ? kTimedMeshes : kTimedPairs))
      some.push_back(&turn);
  }
  return some;
}

void time_kind(DriverRun& run, const std::string& kind, const std::vector<TurnCase>& cases,
               const std::vector<KnownTurn>& turns, Table& table, TimingRun& timing) {
  const std::vector<const KnownTurn*> some = first_of(turns, kind);
  std::vector<Prepared> made;
  std::vector<TimedCase> timed;
  made.reserve(cases.size());
  for (const TurnCase& one : cases) {
    if (!one.takes(some.front()->query.kind)) continue;
    made.push_back(prepared(one, some));
    TimedCase ask;
    ask.key = {kind, one.name, one.setting};
    ask.run = [&of = made.back()] { of.run(); };
    ask.units = static_cast<double>(some.size());
    ask.rounds = run.quick() ? 2 : 7;
    if (made.back().seconds > 1.0) {
      ask.expected_s = made.back().seconds;
      ask.rounds = 2;
    }
    timed.push_back(std::move(ask));
  }
  TimingOptions options;
  if (run.quick()) options = {.slow_ms = 200.0, .repeat_share = 0.05, .least_repeat_s = 0.2};
  TimingRun found = run_interleaved(timed, options, run.progress);
  for (std::size_t k = 0; k < timed.size(); ++k) {
    const Timing& one = found.timings[k];
    std::vector<Cell> row = one.key;
    row.insert(row.end(), {some.size(), made[k].building_us, made[k].typical_us, 1e3 * one.summary.median,
                           1e3 * one.summary.iqr, one.summary.count, one.inconclusive});
    table.add_row(std::move(row));
  }
  append(timing, std::move(found));
}

Table time_table() {
  Table table{time_keys()};
  table.columns.insert(
      table.columns.end(),
      {{"queries", "1", "that are timed, the first of their kind"},
       {"building_us", "us", "of what is done once for two features or meshes, a query"},
       {"typical_us", "us", "of asking one, once, median over the queries"},
       {"median_us", "us", "of asking, mean over the queries, median over the rounds"},
       {"iqr_us", "us", "interquartile range of it"},
       {"rounds", "1", "rounds measured"},
       {"inconclusive", "", "yes: the spread or that of the control of its run is too large"}});
  return table;
}

void body(DriverRun& run) {
  TurnSetSizes sizes = run.quick() ? kQuick : kFull;
  if (run.record.seed != 0) sizes.seed = run.record.seed;
  const char* folder = std::getenv("IMPINGE_TURNS");
  const std::vector<KnownTurn> turns = folder != nullptr ? read_turn_set(folder) : make_turn_set(sizes);
  const std::vector<TurnCase> cases = turn_cases(run.quick());
  Result answers{"turns", "Who misses a first meeting while one turns, and who finds a false one?"};
  answers.table.columns = {{"kind", "", "vertex_face, edge_edge, face_face or mesh"},
                           {"family", "", "experiments/28_turns/README.md"},
                           {"method", "", "turn_contact, turn_limit: ours; else a library and its way"},
                           {"setting", "", "of the method"}};
  for (const Column& column : tally_columns()) answers.table.columns.push_back(column);
  for (const TurnCase& one : cases) {
    Stopwatch watch;
    for (const auto& [key, tally] : tally_of(one, turns)) {
      std::vector<Cell> row{key.first, key.second, one.name, one.setting};
      for (Cell& cell : tally_cells(tally)) row.push_back(std::move(cell));
      answers.table.add_row(std::move(row));
    }
    run.progress.say(one.name + " " + one.setting + ": " + duration_text(watch.lap_s()));
  }
  add_labels(answers.labels, cases);
  answers.parameters = {{"seed", sizes.seed},
                        {"pairs", sizes.pairs},
                        {"meshes", sizes.meshes},
                        {"tolerance_rad", kTurnTolerance}};
  run.write(answers);
  Result times{"turn_time", "How long does the first meeting of a turn take?", time_table()};
  times.labels = answers.labels;
  times.parameters = answers.parameters;
  TimingRun timing;
  for (const char* kind : {"vertex_face", "edge_edge", "face_face", "mesh"})
    time_kind(run, kind, cases, turns, times.table, timing);
  write_timed(run, times, time_keys(), timing);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv, {"28_turns", "Who misses a first meeting while one turns."},
                                  body);
}
