// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "12_scene_needs/needs_study.hpp"

namespace impinge::lab {
namespace {

constexpr double kMicroseconds = 1000.0;  // in a millisecond

// What a scene with nothing left out takes besides answering the question.
struct Extra {
  double bytes = 0.0;
  double us = 0.0;
};

bool is_output(const NeedsCase& timed) {
  return std::ranges::any_of(kOmissions, [&](const OmissionName& known) {
    return known.name == timed.left_out &&
           (known.omission == Omission::distances || known.omission == Omission::error_bounds ||
            known.omission == Omission::exact_verdicts);
  });
}

std::vector<Cell> key_of(const NeedsCase& timed) { return {timed.scene, timed.left_out}; }

Table needs_table() {
  return {
      {{"scene", "", "joint and question"},
       {"left_out", "", "what is left out: one omission, or all that the plan finds"},
       {"bytes_saved", "bytes", "memory of tables and what stands in for them, against leaving nothing out"},
       {"time_saved_us", "us",
        "median of the time, against leaving nothing out; below 0 where it takes longer"},
       {"identical", "",
        "yes: the answer is the same bit for bit, or within the stated accuracy of the exact one; of a "
        "motion "
        "volume, no cell is free in one and blocked in the other"}},
      {}};
}

Table totals_table() {
  return {{{"scene", "", "joint and question"},
           {"everything_bytes", "bytes", "all tables, scans and outputs of a scene"},
           {"everything_us", "us", "median"},
           {"tables_bytes", "bytes", "all tables and scans, without outputs that were not asked for"},
           {"tables_us", "us", "median"},
           {"plan_bytes", "bytes", "with all omissions"},
           {"plan_us", "us", "median"},
           {"bytes_ratio", "1", "everything to plan"},
           {"time_ratio", "1", "everything to plan"},
           {"tables_bytes_ratio", "1", "tables to plan"},
           {"tables_time_ratio", "1", "tables to plan"},
           {"difference_mm", "mm", "largest of a gap from the answer it is compared with"},
           {"identical", "", "as in scene_needs"}},
          {}};
}

}  // namespace

NeedsTables time_needs(const std::vector<NeedsCase>& cases, const NeedsOptions& options, Progress& progress) {
  std::vector<TimedCase> timed;
  for (const NeedsCase& work : cases) {
    TimedCase one;
    one.key = key_of(work);
    one.run = work.run;
    one.rounds = options.rounds;
    timed.push_back(std::move(one));
  }
  TimingOptions protocol;
  protocol.slow_ms = 50.0;  // cases that take longer are long enough to be their own warm-up
  NeedsTables made{needs_table(), totals_table(), run_interleaved(timed, protocol, progress)};
  const auto us = [&](const NeedsCase& work) {
    return kMicroseconds * find(made.timing, key_of(work)).summary.median;
  };
  std::map<std::string, Extra> extra;
  std::map<std::string, const NeedsCase*> everything;
  for (const NeedsCase& work : cases) {
    if (work.left_out == "nothing") everything[work.scene] = &work;
    if (!is_output(work)) continue;
    extra[work.scene].bytes += work.bytes;
    extra[work.scene].us += us(work);
  }
  for (const NeedsCase& work : cases) {
    if (work.left_out == "nothing") continue;
    if (is_output(work)) {
      made.needs.add_row({work.scene, work.left_out, work.bytes, us(work), work.identical});
      continue;
    }
    const NeedsCase& full = *everything.at(work.scene);
    const bool all = work.left_out == "all";
    const Extra more = all ? extra[work.scene] : Extra{};
    made.needs.add_row({work.scene, work.left_out, full.bytes + more.bytes - work.bytes,
                        us(full) + more.us - us(work), work.identical});
    if (!all) continue;
    const double all_bytes = full.bytes + more.bytes;
    const double all_us = us(full) + more.us;
    made.totals.add_row({work.scene, all_bytes, all_us, full.bytes, us(full), work.bytes, us(work),
                         all_bytes / work.bytes, all_us / us(work), full.bytes / work.bytes,
                         us(full) / us(work), work.difference_mm, work.identical});
  }
  return made;
}

}  // namespace impinge::lab
