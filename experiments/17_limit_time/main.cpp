// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How long do the limits of all motions take, and what do steps miss?
// @writes    limit_time limit_time_samples touch_time touch_time_samples
// @bones     yes
// @timing    yes
// @seconds   30 1300
// @links     harness real_joints hip change phantoms method_cgal steps_methods
//
// The limits of the named motions of a generated hip, of a replaced one and of real joints with whole bones,
// and the known limits of a needle that passes thin spikes. They are found in closed form
// (limits/turn_limit.hpp), alone and with the range for every centre within half a millimetre; and by others'
// tests of touch in steps of 5 to 0.1 degrees, halved to 0.01 where a pose touches. Before anything is timed
// our limit is compared with the smallest angle of any method at which CGAL finds a common point. For the
// same joints it is timed how long a test of one pose takes.

#include "17_limit_time/limit_times.hpp"
#include "17_limit_time/touch_times.hpp"
#include "harness/driver.hpp"
#include "harness/timing.hpp"
#include "limits/told_limit.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

// Faces of ball and socket together.
constexpr std::size_t kHipFacesInQuick = 6000;
constexpr std::size_t kHipFacesInFull = 24000;
constexpr std::size_t kImplantFacesInQuick = 8000;
constexpr std::size_t kImplantFacesInFull = 119000;

void body(DriverRun& run) {
  LimitTimes found = empty_limit_times();
  LimitTimes touch = empty_touch_times();
  const LimitPlan plan = limit_plan(run.quick());
  LimitPlan of_implant = plan;  // head and cup are close all round: others take ten times as long
  of_implant.motions = run.quick() ? 1 : 3;
  of_implant.few_motions = 1;
  if (run.quick()) of_implant.steps_deg.pop_back();
  TouchPlan poses;
  poses.seed = run.record.seed;
  if (run.quick()) poses = {.poses = 10, .rounds = 3, .seed = run.record.seed};
  const auto add = [&](const TurnedJoint& joint, const LimitPlan& so) {
    add_limit_times(joint, so, found, run.progress);
  };
  const auto add_hip = [&](const TurnedJoint& joint, const LimitPlan& so) {
    add(joint, so);
    add_touch_times(joint, poses, so.timing, touch, run.progress);
  };
  add_hip(generated_hip(run.quick() ? kHipFacesInQuick : kHipFacesInFull), plan);
  add_hip(replaced_hip(run.quick() ? kImplantFacesInQuick : kImplantFacesInFull), of_implant);
  add(needle_past_spikes(), plan);
  if (run.bones) {
    for (const TurnedJoint& joint : whole_joints(*run.bones, run.progress)) add_hip(joint, plan);
  }
  Result result{"limit_time", "What do limits of all motions cost, and what do steps miss?", found.table};
  result.parameters = {
      {"labels", found.labels}, {"halved_to_deg", 0.01}, {"centre_within_mm", kErrorOfInput}};
  result.labels = found.labels;
  write_timed(run, result, limit_time_keys(), found.timing);
  Result of_poses{"touch_time", "What does it cost to know whether bones touch in a pose?", touch.table};
  of_poses.parameters = {{"labels", touch.labels}};
  of_poses.labels = touch.labels;
  write_timed(run, of_poses, touch_time_keys(), touch.timing);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv,
      {"17_limit_time", "What limits of motions cost, and what steps miss.", /*takes_bones=*/true}, body);
}
