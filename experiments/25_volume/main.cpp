// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How long does it take to know all rotations of a joint at once, beside asking pose after pose?
// @writes    motion_volume motion_volume_methods motion_volume_rotations
// @bones     yes
// @timing    yes
// @seconds   7 800
// @links     harness real_joints contact_methods 17_motion
//
// Every generated hip and real joint: the share of all rotations that is free of contact, between proven
// ends, and how soon these are how near to each other, making the joint ready included. Beside it a grid of
// poses with the reach of the finest cells, by FCL, ODE and Bullet, extrapolated from random rotations; and
// random rotations asked of our own test of a pose, which find the share soon and prove nothing. Internal
// rotation by flexion, read off the cells.

#include "25_volume/volume_study.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

void body(DriverRun& run) {
  VolumeStudyOptions options;
  options.widths = {0.2, 0.1, 0.05};
  if (!run.quick()) options.widths.insert(options.widths.end(), {0.02, 0.01});
  options.poses = run.quick() ? 5000 : 100000;
  options.few_poses = run.quick() ? 500 : 100000;
  options.seed = run.record.seed;
  VolumeTables tables = make_volume_tables();
  for (const std::string_view preset : hip_preset_names()) {
    const HipParameters parameters = hip_preset(preset);
    Hip hip = make_hip(parameters, kHipFaces);
    const bool peers = preset == hip_preset_names().front();
    if (run.quick() && !peers) options.widths = {0.1};
    add_volume({std::string(preset), {std::move(hip.ball), std::move(hip.socket)}, parameters.side}, options,
               peers, tables);
    run.progress.say("motion volume of " + std::string(preset));
  }
  if (run.bones) {
    for (const RealJoint& joint : read_real_joints(*run.bones, run.progress)) {
      add_volume({joint.subject, in_joint_frame(joint), joint.side}, options, /*peers=*/false, tables);
      run.progress.say("motion volume of " + joint.subject);
    }
  }
  const nlohmann::json parameters = {
      {"faces", kHipFaces}, {"threads", options.threads}, {"threads_of_peers", 1}, {"gap_mm", 0.0}};
  run.write({"motion_volume",
             "Which share of all rotations is free, between which ends, and after which time?",
             std::move(tables.volumes), parameters});
  run.write({"motion_volume_methods", "How long does a pose take that is asked by itself?",
             std::move(tables.methods), parameters});
  run.write({"motion_volume_rotations", "How does internal rotation depend on flexion?",
             std::move(tables.rotations), parameters});
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"25_volume", "All rotations of a joint at once.", /*takes_bones=*/true}, body);
}
