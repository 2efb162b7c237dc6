// SPDX-License-Identifier: GPL-3.0-or-later
// Times inconclusive cases of a run again, each alone, so that no other case disturbs its caches.
#pragma once

#include <functional>
#include <vector>

#include "harness/timing.hpp"

namespace impinge::lab {

// What repeats may cost, and the functions that make them (replaced in tests).
struct RepeatMeans {
  double budget_s = 0.0;                             // for all repeats together
  std::function<TimingRun(const TimedCase&)> alone;  // a run of this case and its control, nothing else
  std::function<double()> elapsed_s;                 // since the first repeat could begin
};

// Fewest rounds of a repeat: one has no spread, and two tell little about it.
inline constexpr int kLeastRepeatRounds = 3;

// Times each inconclusive timing of the run again, the cheapest first, up to options.most_repeats times,
// until it is conclusive by its own control and spread. The last timing is kept, conclusive or not. A repeat
// that is not expected to end within the budget is not begun.
void repeat_inconclusive(TimingRun& run, const std::vector<TimedCase>& cases, const RepeatMeans& means,
                         Progress& progress);

}  // namespace impinge::lab
