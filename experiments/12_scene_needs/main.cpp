// SPDX-License-Identifier: GPL-3.0-or-later
// @question  What does a scene save by leaving out what it does not need, at the same answer?
// @writes    scene_needs scene_needs_totals scene_needs_samples
// @bones     yes
// @timing    yes
// @seconds   27 420
// @links     harness real_joints methods session answer_difference local_refill
//
// Everything is done with RSID tables at 0.1 degrees, for four questions about each joint: all gaps in one
// pose, the smallest gap in it, touch along a motion there and back in 19 poses, and all gaps along it in 181
// within 0.05 mm. Two more: after a local change a table is filled anew only where it changed, and of the
// rotations without contact a motion volume splits open cells alone. Each omission runs by itself and all of
// them together; every answer is compared before anything is timed, and one that is not the same fails the
// run.

#include <algorithm>
#include <stdexcept>

#include "12_scene_needs/needs_study.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "harness/timing_report.hpp"
#include "mesh/generated_pair.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kFaces = 12000;  // of each generated model
constexpr std::size_t kFacesInQuick = 3000;
constexpr std::size_t kJointsInQuick = 1;  // the smallest
constexpr int kRounds = 5;
constexpr int kRoundsInQuick = 3;

void add(const std::vector<NeedsCase>& more, std::vector<NeedsCase>& cases) {
  cases.insert(cases.end(), more.begin(), more.end());
}

void add_joint(const std::string& name, const BallSocketPair& joint, const Vec3& axis,
               const NeedsOptions& options, DriverRun& run, std::vector<NeedsCase>& cases) {
  for (const NeedsScene& scene : scenes_of(name, joint, axis)) {
    add(cases_of(scene, options), cases);
    if (scene.needs.poses.size() == 1) add(outputs_of(scene, options), cases);
  }
  add(local_change_of(name, joint, options), cases);
  add(motion_volume_of(name, joint), cases);
  run.progress.say("compared the answers of " + name);
}

void require_identical(const std::vector<NeedsCase>& cases) {
  for (const NeedsCase& work : cases) {
    if (work.identical) continue;
    throw std::runtime_error(work.scene + ", left out " + work.left_out +
                             ": the answer is not the same, it differs by " +
                             std::to_string(work.difference_mm) + " mm");
  }
}

void body(DriverRun& run) {
  NeedsOptions options;
  options.rounds = run.quick() ? kRoundsInQuick : kRounds;
  std::vector<NeedsCase> cases;
  const std::size_t faces = run.quick() ? kFacesInQuick : kFaces;
  add_joint("generated", make_ball_socket_pair(faces, impinging_cam()), -Vec3::UnitY(), options, run, cases);
  if (run.bones) {
    std::vector<RealJoint> joints = read_real_joints(*run.bones, run.progress);
    if (run.quick() && joints.size() > kJointsInQuick) {
      std::ranges::stable_sort(joints, {}, [](const RealJoint& j) { return j.meshes.ball.faces.size(); });
      joints.resize(kJointsInQuick);
    }
    for (const RealJoint& joint : joints)
      add_joint(joint.subject, joint.meshes, Vec3::UnitX(), options, run, cases);
  }
  require_identical(cases);
  NeedsTables tables = time_needs(cases, options, run.progress);
  Result result{"scene_needs_totals", "What does a scene save with all omissions together?",
                std::move(tables.totals)};
  result.parameters = {{"scheme", "rsid"},
                       {"precision_deg", options.precision_deg},
                       {"faces_of_the_generated_models", faces},
                       {"bytes", "counted by the structures; of outputs, growth of the heap (mallinfo2)"}};
  result.timing = timing_record(tables.timing);
  run.write(result);
  result.name = "scene_needs";
  result.question = "What does each omission save, and is the answer the same?";
  result.table = std::move(tables.needs);
  write_timed(run, result, {{"scene", "", "joint and question"}, {"left_out", "", "the omission"}},
              tables.timing);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv,
      {"12_scene_needs", "What a scene saves by leaving out what it does not need.", /*takes_bones=*/true},
      body);
}
