// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How wrong is every method, and what does it cost to build, to ask and to keep?
// @writes    error_against_time error_against_time_spread error_against_time_samples
// @bones     yes
// @cache     yes
// @timing    yes
// @seconds   32 1200
// @links     harness real_joints reference_cache methods points_methods
//
// The posed ball's vertices are asked against the surface of the socket. Errors are measured before anything
// is timed, on the very tables that are timed, and the largest is held against the proven bound: if it is
// above, the run fails and leaves the direction in error_against_time_witness.json.

#include <algorithm>
#include <array>

#include "10_error_against_time/report.hpp"
#include "10_error_against_time/scenes.hpp"
#include "files/file_bytes.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::array<std::size_t, 4> kLevels{300, 3000, 12000, 100000};  // triangles of each model
constexpr std::size_t kMostInQuick = 12000;
constexpr std::size_t kJointsInQuick = 2;  // the smallest

std::vector<BenchmarkScene> scenes(DriverRun& run) {
  std::vector<BenchmarkScene> all;
  for (const std::size_t n : kLevels) {
    if (!run.quick() || n <= kMostInQuick) all.push_back(generated_scene(n));
  }
  if (!run.bones) return all;
  std::vector<RealJoint> joints = read_real_joints(*run.bones, run.progress);
  std::ranges::stable_sort(joints, {}, [](const RealJoint& j) { return j.meshes.socket.faces.size(); });
  if (run.quick() && joints.size() > kJointsInQuick) joints.resize(kJointsInQuick);
  for (RealJoint& joint : joints) all.push_back(real_scene(joint.subject, std::move(joint.meshes)));
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
  options.radial.seed = options.euclidean.seed = options.timing.seed = run.record.seed;
  BenchmarkTables tables = make_benchmark_tables();
  try {
    for (const BenchmarkScene& scene : scenes(run)) run_benchmark(scene, options, tables, run.progress);
  } catch (const BoundViolated& violated) {
    write_if_changed(run.record.folder / "error_against_time_witness.json",
                     violated.violation().text() + "\n");
    throw;
  }
  Result result;
  result.parameters = parameters_of(options);
  result.labels = tables.labels;
  const auto write = [&](const char* name, const char* question, Table& table) {
    result.name = name;
    result.question = question;
    result.table = std::move(table);
    run.write(result);
  };
  write("error_against_time", "How wrong is every method, and what does it cost?", tables.main);
  write("error_against_time_spread", "What is behind the errors and times of every method?", tables.spread);
  write("error_against_time_samples", "Which samples are behind the times?", tables.samples);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv,
                                  {"10_error_against_time", "Error against time, every method.",
                                   /*takes_bones=*/true, /*takes_cache=*/true},
                                  body);
}
