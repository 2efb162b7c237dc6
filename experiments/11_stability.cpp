// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Do stiff and extreme cases break a method?
// @writes    stability stability_detail stability_families
// @timing    no
// @seconds   84 400
// @links     harness stress
//
// Each family of experiments/stress/families/ varies its parameter from harmless to extreme
// (stress/family.hpp) and compares each answer with the exact one. The run writes its results and then fails
// if our method fails in a case that it does not refuse, or if a method made wrong on purpose passes.

#include <stdexcept>
#include <string>
#include <utility>

#include "harness/driver.hpp"
#include "stress/family.hpp"
#include "stress/measure.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kMostLines = 20;

void body(DriverRun& run) {
  const StabilityRun settings{run.quick(), run.record.seed};
  StabilityTables tables = run_stability(settings, run.progress);
  const nlohmann::json parameters = {{"unit_roundoff_float", unit_roundoff(Scalar::float32)},
                                     {"unit_roundoff_double", unit_roundoff(Scalar::float64)},
                                     {"threshold_of_tables_stored_in_float", kStoredThreshold},
                                     {"precision_deg_of_tables", StabilityScene{}.precision_deg},
                                     {"halvings_of_a_bound", measure_options(settings).search.budget},
                                     {"truth", "exact reference along the very double direction"},
                                     {"stiff_above", kStiff},
                                     {"extreme_within", kExtreme}};
  run.write({"stability", "How far off is every method in stiff and extreme cases?", std::move(tables.main),
             parameters});
  run.write({"stability_detail", "In which way does a method fail, and what does it refuse?",
             std::move(tables.detail), parameters});
  run.write({"stability_families", "What is varied in a family, and what is expected?",
             std::move(tables.families), parameters});
  if (tables.broken.empty()) return;
  for (std::size_t k = 0; k < tables.broken.size() && k < kMostLines; ++k) run.progress.say(tables.broken[k]);
  throw std::runtime_error(
      std::to_string(tables.broken.size()) +
      " cases of ours failed outside of what they refuse: 11_stability --out FOLDER lists all of them in "
      "stability_detail.csv");
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv, {"11_stability", "Stiff and extreme cases."}, body);
}
