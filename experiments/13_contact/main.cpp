// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How fast is it told whether a joint touches, and its smallest gap, beside FCL and scans of all
// vertices?
// @writes    contact contact_samples contact_agreement
// @timing    yes
// @seconds   26 250
// @links     harness contact_poses contact_methods methods hip 10_error_against_time
//
// Poses whose smallest gap is over 2 mm, 0.5 mm, or which touch in most; the generated pair of ever more
// triangles, and hips. First
// the answers are compared, close to contact too, with the exact test of every vertex and with FCL; those of
// other libraries with the exact overlay in every pose that is timed. Warm.

#include "10_error_against_time/scenes.hpp"
#include "13_contact/contact_agreement.hpp"
#include "13_contact/contact_study.hpp"
#include "harness/driver.hpp"
#include "harness/timing_report.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/generated_pair.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

const std::vector<std::size_t> kQuick{3000, 12000};  // triangles of each of the generated models
const std::vector<std::size_t> kFull{300, 3000, 12000, 100000, 400000};

void write_agreement(DriverRun& run) {
  AgreementOptions options;
  options.seed = run.record.seed;
  options.poses = run.quick() ? 1000 : 10000;
  Result result;
  result.name = "contact_agreement";
  result.question =
      "Do culled answers agree with the exact test of every vertex and with FCL, close to contact too?";
  result.table =
      agreement_table(options, contact_agreement(make_ball_socket_pair(options.triangles), options));
  run.write(result);
}

void body(DriverRun& run) {
  write_agreement(run);
  ContactOptionsTimed options;
  options.rounds = run.quick() ? 3 : 11;
  options.timing.min_round_ms = 5.0;
  if (run.quick()) options.timing.least_repeat_s = 2.0;
  options.seed = run.record.seed;
  ContactTables tables = make_contact_tables();
  for (const std::size_t faces : run.quick() ? kQuick : kFull)
    run_contact(generated_scene(faces), options, tables, run.progress);
  for (const std::string_view preset : run.quick() ? hip_preset_names().first(1) : hip_preset_names())
    run_contact(hip_scene(std::string(preset), kHipFaces), options, tables, run.progress);
  Result result;
  result.name = "contact";
  result.question = "Time of a pose of every way to say whether the joint touches, or its smallest gap?";
  result.parameters = {{"warm", true}, {"step_deg", 0.5}, {"motions", 16}};
  result.table = std::move(tables.table);
  result.labels = tables.labels;
  write_timed(run, std::move(result), contact_keys(), tables.timing);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv, {"13_contact", "Touch and smallest gap of a pose, beside FCL."},
                                  body);
}
