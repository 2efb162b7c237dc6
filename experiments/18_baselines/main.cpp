// SPDX-License-Identifier: GPL-3.0-or-later
// @question  What do the methods that the thesis compares itself with cost, lose and get wrong? (Section 3.6)
// @writes    baselines baselines_samples
// @bones     yes
// @timing    yes
// @seconds   20 160
// @links     harness contact_poses real_joints methods baseline_methods reference hip
//
// The methods are Hu's table of voxels, Maciel's table of triangles, a Cartesian distance field, each at
// several resolutions, and RSID. Each is checked against exact distances or radii before it is timed, and
// judged in poses on either side of exact contacts. The joints are the generated pair, the stand-ins for the
// thesis' two patients, and real joints.

#include "18_baselines/baseline_study.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "harness/timing.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/generated_pair.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kFaces = 12000;  // faces of each generated model, as the thesis' patient has
constexpr std::size_t kFacesInQuick = 3000;

BaselineSizes generated_sizes(bool quick) {
  if (quick)
    return {{4.0, 2.0, 1.0, 0.5}, {10, 20, 50, 100, 200, 400, 800}, {16, 32}, {4.0, 2.0, 1.0, 0.5}, 3e7};
  return {{4.0, 2.0, 1.0, 0.5, 0.25},
          {10, 20, 50, 100, 200, 400, 800, 1600},
          {16, 32, 64, 96},
          {4.0, 2.0, 1.0, 0.5, 0.1},
          2e8};
}

// Sizes for hips. Both profiles include the thesis' 400 rays a side and 1 degree.
BaselineSizes hip_sizes(bool quick) {
  if (quick) return {{1.0}, {100, 400}, {16}, {1.0}, 0.0};
  return {{2.0, 1.0, 0.5}, {10, 100, 400, 1600}, {32}, {1.0, 0.1}, 5e7};
}

std::vector<BaselineJoint> joints_of(DriverRun& run) {
  const bool quick = run.quick();
  std::vector<BaselineJoint> joints;
  BaselineWays ways;
  ways.seed = run.record.seed;
  ways.count = quick ? 10 : 40;
  joints.push_back({"generated", make_ball_socket_pair(quick ? kFacesInQuick : kFaces, impinging_cam()),
                    generated_sizes(quick), ways});
  ways.count = quick ? 1 : 10;
  for (const char* patient : {"patient_a", "patient_b"}) {
    Hip hip = make_hip(hip_preset(patient), kFaces);
    joints.push_back({patient,
                      {std::move(hip.ball), std::move(hip.socket)},
                      hip_sizes(quick),
                      ways,
                      quick ? 200U : 2000U});
  }
  if (!run.bones) return joints;
  for (const RealJoint& real : read_real_joints(*run.bones, run.progress))
    joints.push_back({real.subject, real.meshes, hip_sizes(quick), ways, quick ? 200U : 2000U});
  return joints;
}

void body(DriverRun& run) {
  BaselineOptions options;
  if (run.quick()) options = {1, 3, 1.0};
  BaselineTables tables = baseline_tables(joints_of(run), options, run.progress);
  Result result{"baselines",
                "Bytes, times, lost triangles and wrong answers of every method of Section 3.6?"};
  result.parameters = {
      {"faces_of_the_generated_models", run.quick() ? kFacesInQuick : kFaces},
      {"maciel_triangles", "filled by all pairs, as published"},
      {"poses", "0.05, 0.1, 0.2, 0.5, 1, 2 and 4 mm of way before and after exact first contacts"}};
  result.table = std::move(tables.table);
  result.labels = tables.labels;
  write_timed(run, std::move(result), baseline_keys(), tables.timing);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"18_baselines", "Methods that the thesis compares itself with.", /*takes_bones=*/true},
      body);
}
