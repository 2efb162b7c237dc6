// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Do the claims hold that the thesis makes without showing them? (Chapter 6)
// @writes    claims claims_samples
// @timing    yes
// @seconds   5 40
// @links     harness face_crossings hip local_refill reference
//
// A deforming surface updated in place, self-collision found while sampling, and several layers. Each is a
// small experiment with an exact or bit-for-bit check before anything is timed.

#include "20_claims/claims_study.hpp"
#include "harness/driver.hpp"
#include "harness/timing.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

void body(DriverRun& run) {
  ClaimsOptions options;
  if (run.quick()) {
    options.faces = 3000;
    options.precision_deg = 1.0;
    options.collision_precisions = {1.0, 0.5};
    options.rounds = 3;
  } else {
    options.collision_precisions.push_back(0.1);
  }
  ClaimsStudy study;
  add_deforming(study, options);
  add_self_collision(study, options);
  add_layers(study, options);
  ClaimsTables tables = claims_tables(study, run.progress);
  Result result{"claims", "Do the claims of Chapter 6 hold?"};
  result.parameters = {{"faces_of_each_surface", options.faces}, {"precision_deg", options.precision_deg}};
  result.table = std::move(tables.table);
  write_timed(run, std::move(result), claims_keys(), tables.timing);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv,
                                  {"20_claims", "Claims that the thesis never showed (Chapter 6)."}, body);
}
