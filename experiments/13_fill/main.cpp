// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How long do the tables of a joint take to fill, beside Embree's tree and coherent rays?
// @writes    fill fill_samples
// @timing    yes
// @seconds   12 150
// @links     harness fill_methods
//
// Cube maps of both surfaces of the generated pair. Each way is held against the exact rasteriser first.
// Fresh memory comes from the system in each run, as in a program's first; else the C library keeps it
// between runs.

#include "13_fill/fill_study.hpp"
#include "harness/driver.hpp"
#include "harness/timing_report.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

void fill_body(DriverRun& run) {
  FillOptions options{{3000, 12000, 100000, 400000}, {128, 256, 512, 1024}, 5, {}};
  if (run.quick()) options = {{3000, 12000}, {128, 256}, 5, {}};
  options.timing.min_round_ms = 5.0;
  const std::vector<FillCase> methods = cases_of(fill_methods(), &Method::fill);
  const TimingRun timed = time_filling(options, methods, run.progress);
  Result result;
  add_labels(result.labels, methods);
  result.name = "fill";
  result.question = "How long do the tables of ball and socket take to fill?";
  result.parameters = {{"pair", "generated, default shape"},
                       {"counted", "both tables, with their rim masks (Embree: without)"}};
  result.table.columns = timing_columns(fill_keys());
  for (const Timing& timing : timed.timings) result.table.add_row(timing_cells(timing));
  write_timed(run, result, fill_keys(), timed);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"13_fill", "Filling the tables of a joint, beside Embree's tree and rays."}, fill_body);
}
