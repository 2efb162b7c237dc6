// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How wrong is every method, and what does it cost to build, to ask and to keep?
// @writes    error_against_time error_against_time_spread error_against_time_samples all_gaps
// all_gaps_samples
// @bones     yes
// @cache     yes
// @timing    yes
// @seconds   59 1500
// @links     harness hip real_joints reference_cache methods points_methods gaps_methods gap_simd
//
// On the generated pair, on hips and on real joints. A vertex asked alone: those of the posed ball against
// the surface of the socket. All gaps of a pose: kernels with vector instructions, the scalar scan and
// libraries, in both directions, over a motion of 24 poses; closest points and voxels are Euclidean
// distances. Errors are measured before anything is timed, on the very tables that are timed, and the largest
// is held against the proven bound: if it is above, the run fails and leaves the direction in
// error_against_time_witness.json.

#include <algorithm>
#include <functional>
#include <optional>

#include "10_error_against_time/all_gaps.hpp"
#include "10_error_against_time/scenes.hpp"
#include "files/file_bytes.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "harness/timing_report.hpp"
#include "hip/hip_presets.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kJointsInQuick = 2;  // the smallest

// A scene, made when its turn comes, and what is asked there.
struct Planned {
  std::function<BenchmarkScene()> make;
  bool points = false;            // a vertex alone?
  std::optional<GapPlan> gaps{};  // all of a pose
};

Planned generated(std::size_t faces, bool points, std::optional<GapPlan> gaps) {
  return {[faces] { return generated_scene(faces); }, points, std::move(gaps)};
}
Planned hip(const std::string& preset, std::size_t faces, bool points, GapPlan gaps) {
  return {[preset, faces] { return hip_scene(preset, faces); }, points, std::move(gaps)};
}

const GapPlan kFew{{{kMainCells}, {0.5}}};

std::vector<Planned> quick_scenes() {
  return {generated(300, true, {}), generated(3000, true, GapPlan{{{kMainCells}, {}, {}, false}}),
          generated(12000, true, GapPlan{{{kMainCells, 1100}, {0.5}, {0.5}, true, {0.5}}, true}),
          hip("normal", 12000, false, {{{kMainCells}, {}, {}, false}})};
}

std::vector<Planned> full_scenes() {
  const std::vector<std::size_t> corners{128, kCornersOfAMebibyte, kMainCells, 728};
  const GapSizes every{
      {64, 128, kMainCells, 512, 1100}, {1.0, 0.5, 0.25, 0.1}, {0.5, 0.1}, true, {1.0, 0.5, 0.25}, corners};
  const GapPlan uncertified{{{kMainCells}, {0.5}, {}, false}};
  std::vector<Planned> all{generated(300, true, kFew), generated(3000, true, kFew),
                           generated(12000, true, GapPlan{every, true}), generated(100000, true, kFew),
                           generated(400000, false, uncertified)};
  for (const std::size_t faces : {3000U, 12000U, 100000U})
    all.push_back(hip("normal", faces, faces == 12000, kFew));
  for (const std::string_view preset : hip_preset_names())
    if (preset != "normal") all.push_back(hip(std::string(preset), 12000, false, kFew));
  return all;
}

// Real joints last; in a quick run the smallest.
std::vector<Planned> scenes(DriverRun& run) {
  std::vector<Planned> all = run.quick() ? quick_scenes() : full_scenes();
  if (!run.bones) return all;
  std::vector<RealJoint> joints = read_real_joints(*run.bones, run.progress);
  std::ranges::stable_sort(joints, {}, [](const RealJoint& j) { return j.meshes.socket.faces.size(); });
  if (run.quick() && joints.size() > kJointsInQuick) joints.resize(kJointsInQuick);
  for (const RealJoint& joint : joints)
    all.push_back({[joint] { return real_scene(joint.subject, joint.meshes); }, true,
                   GapPlan{{{kMainCells}, {0.5}, {}, false}}});
  return all;
}

nlohmann::json parameters_of(const BenchmarkOptions& options) {
  return {{"precisions_deg", options.sizes.tables.precisions},
          {"grid_nodes", options.sizes.grid_nodes},
          {"most_entries_of_a_searched_bound", options.sizes.tables.most_entries},
          {"most_faces_of_a_searched_bound", options.sizes.tables.most_faces},
          {"halvings_of_a_bound", options.sizes.tables.search.budget},
          {"bound_of_other_tables", "of first order"},
          {"uniform_directions", options.radial.uniform},
          {"directions_of_each_feature", options.radial.each_feature},
          {"euclidean_uniform_points", options.euclidean.uniform},
          {"ascents", options.ascent.starts},
          {"steps_of_an_ascent", options.ascent.steps},
          {"rounds", options.timing.rounds},
          {"flushed_bytes", options.timing.flush_bytes},
          {"truth_radial",
           "exact reference; during an ascent the nearest crossing among all triangles, in double"},
          {"truth_euclidean",
           "exact reference; during an ascent the least distance among all triangles, in double"},
          {"truth_pose", "least distance among the pairs of triangles that can matter, in double"},
          {"query", "vertices of the posed ball against the surface of the socket"},
          {"cold", "flushed_bytes are written before a batch: more than the cores' own caches hold"},
          {"bytes_embree", "its memory monitor: tree, vertices and triangles"},
          {"bytes_cgal_fcl_pairwise", "growth of the heap (mallinfo2) while building"},
          {"bytes_tables", "entries and rim mask"}};
}

void body(DriverRun& run) {
  BenchmarkOptions options = run.quick() ? quick_benchmark() : full_benchmark();
  options.radial.cache = options.euclidean.cache = run.cache;
  options.radial.seed = options.euclidean.seed = run.record.seed;
  BenchmarkTables points = make_benchmark_tables();
  GapTables gaps = make_gap_tables();
  try {
    for (const Planned& planned : scenes(run)) {
      const BenchmarkScene scene = planned.make();
      if (planned.points) run_benchmark(scene, options, points, run.progress);
      if (planned.gaps) run_all_gaps(scene, *planned.gaps, options, gaps, run.progress);
    }
  } catch (const BoundViolated& violated) {
    write_if_changed(run.record.folder / "error_against_time_witness.json",
                     violated.violation().text() + "\n");
    throw;
  }
  Result result;
  result.parameters = parameters_of(options);
  result.labels = points.labels;
  result.name = "error_against_time_spread";
  result.question = "What is behind the errors and times of every method?";
  result.table = std::move(points.spread);
  result.timing = timing_record(points.timing);
  run.write(result);
  result.name = "error_against_time";
  result.question = "How wrong is every method, and what does it cost?";
  result.table = std::move(points.main);
  write_timed(run, result, cost_keys(), points.timing);
  result.name = "all_gaps";
  result.question = "How wrong are all gaps of a pose by every method, and what do they cost?";
  result.table = std::move(gaps.table);
  result.labels = gaps.labels;
  write_timed(run, result, gap_keys(), gaps.timing);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv,
                                  {"10_error_against_time", "Error against time, every method.",
                                   /*takes_bones=*/true, /*takes_cache=*/true},
                                  body);
}
