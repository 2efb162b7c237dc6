// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/timing_repeats.hpp"

#include <algorithm>
#include <numeric>

namespace impinge::lab {
namespace {

constexpr double kSeconds = 1e-3;  // in a millisecond

TimedCase with_enough_rounds(TimedCase work) {
  work.rounds = std::max(work.rounds, kLeastRepeatRounds);
  return work;
}

// Seconds that a repeat will take: the rounds of the case, and as many of its control.
double repeat_s(const Timing& timing, const TimedCase& work) {
  const double run_s = kSeconds * timing.summary.median * work.units;
  return 2.0 * work.rounds * static_cast<double>(timing.batch) * run_s;
}

void repeat(Timing& timing, const TimedCase& work, int most, const RepeatMeans& means) {
  while (timing.inconclusive && timing.repeats < most) {
    if (means.elapsed_s() + repeat_s(timing, work) > means.budget_s) return;
    const int repeats = timing.repeats + 1;
    timing = means.alone(work).timings.front();
    timing.repeats = repeats;
  }
}

}  // namespace

void repeat_inconclusive(TimingRun& run, const std::vector<TimedCase>& cases, const RepeatMeans& means,
                         Progress& progress) {
  std::vector<std::size_t> doubtful;
  std::vector<double> cost_s;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (run.timings[i].inconclusive) doubtful.push_back(i);
    cost_s.push_back(repeat_s(run.timings[i], with_enough_rounds(cases[i])));
  }
  if (doubtful.empty() || run.options.most_repeats < 1) return;
  progress.say("timing " + std::to_string(doubtful.size()) + " inconclusive cases again, each alone");
  std::ranges::stable_sort(doubtful, {}, [&](std::size_t i) { return cost_s[i]; });
  for (const std::size_t i : doubtful)
    repeat(run.timings[i], with_enough_rounds(cases[i]), run.options.most_repeats, means);
}

}  // namespace impinge::lab
