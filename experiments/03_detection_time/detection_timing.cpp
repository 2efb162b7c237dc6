// SPDX-License-Identifier: GPL-3.0-or-later
#include "03_detection_time/detection_timing.hpp"

#include <utility>

#include <benchmark/benchmark.h>

#include "harness/timing_report.hpp"

namespace impinge::lab {
namespace {

constexpr int kFewRounds = 3;

bool is_pairwise(const Contender& contender) { return contender.name() == "pairwise"; }

bool is_measured(const RaceJoint& joint, const Contender& contender, const DetectionRaceOptions& options) {
  return !is_pairwise(contender) || joint.pairs <= options.most_pairs;
}

std::vector<Cell> key_of(const RaceJoint& joint, const Contender& contender) {
  std::vector<Cell> key = joint.before;
  key.emplace_back(contender.name());
  key.insert(key.end(), joint.after.begin(), joint.after.end());
  return key;
}

std::vector<TimedCase> race_cases(const std::vector<RaceJoint>& joints, const DetectionRaceOptions& options) {
  std::vector<TimedCase> cases;
  for (const RaceJoint& joint : joints) {
    for (const auto& contender : joint.race.contenders) {
      if (!is_measured(joint, *contender, options)) continue;
      cases.push_back(race_case(key_of(joint, *contender), *contender, joint.race));
      if (is_pairwise(*contender) && joint.pairs > options.most_pairs_often) cases.back().rounds = kFewRounds;
    }
  }
  return cases;
}

}  // namespace

RaceJoint make_race_joint(std::vector<Cell> before, const BallSocketPair& pair, std::vector<Cell> after,
                          double precision_deg) {
  const auto pairs =
      static_cast<double>(pair.ball.faces.size()) * static_cast<double>(pair.socket.faces.size());
  return {std::move(before), std::move(after), pairs, make_detection_race(pair, precision_deg)};
}

TimedCase race_case(std::vector<Cell> key, Contender& contender, const DetectionRace& race) {
  TimedCase timed;
  timed.key = std::move(key);
  timed.units = static_cast<double>(race.poses.size());
  timed.verify = [&contender, &race] { require_agreement(contender, *race.oracle, race.poses); };
  timed.run = [&contender, &race] { benchmark::DoNotOptimize(count_touching(contender, race.poses)); };
  return timed;
}

Timing write_race(DriverRun& driver, Result result, const std::vector<Column>& key_columns,
                  const std::vector<RaceJoint>& joints, const DetectionRaceOptions& options) {
  const TimingRun timed = run_interleaved(race_cases(joints, options), {}, driver.progress);
  Timing pair = options.pair;
  result.table.columns = timing_columns(key_columns);
  result.table.columns.push_back({"gives_distance", "", "yes: the same work yields the gap at every vertex"});
  for (const RaceJoint& joint : joints) {
    for (const auto& contender : joint.race.contenders) {
      const std::vector<Cell> key = key_of(joint, *contender);
      const bool measured = is_measured(joint, *contender, options);
      if (measured && is_pairwise(*contender)) pair = scaled(find(timed, key), 1.0 / joint.pairs);
      auto row =
          measured ? timing_cells(find(timed, key)) : extrapolated_cells(key, scaled(pair, joint.pairs));
      row.emplace_back(contender->gives_distance());
      result.table.add_row(std::move(row));
    }
  }
  write_timed(driver, std::move(result), key_columns, timed);
  return pair;
}

}  // namespace impinge::lab
