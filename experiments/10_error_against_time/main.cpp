// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How wrong is every method, and what does it cost to build, to ask and to keep?
// @writes    error_against_time error_against_time_spread error_against_time_samples
// @writes    all_gaps all_gaps_samples contact contact_samples contact_agreement
// @bones     yes
// @timing    yes
// @seconds   100 3600
// @links     harness hip real_joints reference contact_poses contact change benchmark_scene
// @links     methods points_methods gaps_methods contact_methods gap_simd instruction_set
//
// One benchmark with a table per question, on the generated pair, on hips and on real joints.
//   gap of a vertex    vertices of the posed ball, one by one, against the surface of the socket
//   all gaps           of a pose, by kernels with vector instructions, the scalar scan and libraries, in both
//                      directions, over a motion of 24 poses
//   touch, smallest    of poses that have a smallest gap over 2 mm or of 0.5 mm, or that mostly touch; warm
// Answers are verified before anything is timed, on the very tables and trees that are timed. If the largest
// error is above the proven bound, the run fails and writes the direction to
// error_against_time_witness.json.

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>

#include "10_error_against_time/contact.hpp"
#include "10_error_against_time/report.hpp"
#include "files/file_bytes.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "harness/timing.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/benchmark_scene.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kJointsInQuick = 2;    // the smallest ones
constexpr std::size_t kFewTriangles = 1000;  // a real socket with fewer is left out of the main plot

// A scene and its questions. It is made when its turn comes.
struct Planned {
  std::function<BenchmarkScene()> make;
  bool points = false;            // gaps of single vertices?
  bool contact = false;           // touch and smallest gap?
  std::optional<GapPlan> gaps{};  // all gaps of a pose
};

Planned generated(std::size_t faces, bool points, bool contact, std::optional<GapPlan> gaps) {
  return {[faces] { return generated_scene(faces); }, points, contact, std::move(gaps)};
}
Planned hip(const std::string& preset, std::size_t faces, bool points, bool contact, GapPlan gaps) {
  return {[preset, faces] { return hip_scene(preset, faces); }, points, contact, std::move(gaps)};
}

const GapPlan kFew{{{kMainCells}, {0.5}}};

// All methods from coarse to fine, for the lines of the work-precision diagram.
GapPlan lines(bool quick) {
  if (quick) return {{{kMainCells}, {0.5}, {2.0, 0.5}, {{}, 30000, 13000, {1.05, 2000}}}, false};
  return {{{kMainCells}, {0.5}, {2.0, 1.0, 0.5, 0.2, 0.1, 0.05}, {{}, 1100000, 13000, {1.05, 100000}}}, true};
}

std::vector<Planned> quick_scenes() {
  return {generated(3000, false, true, GapPlan{{{kMainCells}, {}}}),
          generated(12000, true, true, lines(true)), hip("normal", kHipFaces, false, true, lines(true))};
}

std::vector<Planned> full_scenes() {
  std::vector<Planned> all{generated(300, false, true, kFew), generated(3000, false, true, kFew),
                           generated(12000, true, true, lines(false)), generated(100000, true, true, kFew),
                           generated(400000, false, true, kFew)};
  for (const std::size_t faces : {std::size_t{3000}, kHipFaces, std::size_t{100000}}) {
    const bool main = faces == kHipFaces;
    all.push_back(hip("normal", faces, main, main, main ? lines(false) : kFew));
  }
  for (const std::string_view preset : hip_preset_names())
    if (preset != "normal") all.push_back(hip(std::string(preset), kHipFaces, false, true, kFew));
  return all;
}

// Real joints come first, since they may be refused; in a quick run only the smallest, without touch. Single
// vertices are asked on the smallest and the largest joint. All methods from coarse to fine run on the
// smallest joint with at least a thousand triangles.
std::vector<Planned> scenes(DriverRun& run) {
  std::vector<Planned> others = run.quick() ? quick_scenes() : full_scenes();
  if (!run.bones) return others;
  std::vector<Planned> all;
  std::vector<RealJoint> joints = read_real_joints(*run.bones, run.progress);
  std::ranges::stable_sort(joints, {}, [](const RealJoint& j) { return j.meshes.socket.faces.size(); });
  if (run.quick() && joints.size() > kJointsInQuick) joints.resize(kJointsInQuick);
  bool drawn = false;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const bool draw = !drawn && joints[k].meshes.socket.faces.size() >= kFewTriangles;
    drawn = drawn || draw;
    const bool points = run.quick() || k == 0 || k + 1 == joints.size();
    all.push_back({[joint = joints[k]] { return real_scene(joint.subject, joint.meshes); }, points,
                   !run.quick(), draw ? lines(run.quick()) : kFew});
  }
  std::ranges::move(others, std::back_inserter(all));
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
          {"query", "vertices of the posed ball against the surface of the socket"},
          {"cold", "flushed_bytes are written before a batch: more than the cores' own caches hold"},
          {"bytes_embree", "its memory monitor: tree, vertices and triangles"},
          {"bytes_cgal_fcl_pairwise", "growth of the heap (mallinfo2) while building"},
          {"bytes_tables", "entries and rim mask"}};
}

// All results, a table per question.
struct Found {
  BenchmarkTables points = make_benchmark_tables();
  QuestionTable gaps = make_gap_table();
  QuestionTable contact = make_contact_table();
};

void ask(const Planned& planned, const BenchmarkOptions& options, Found& found, DriverRun& run) {
  const BenchmarkScene scene = planned.make();
  if (planned.points) run_benchmark(scene, options, found.points, run.progress);
  if (planned.gaps) run_all_gaps(scene, *planned.gaps, options, found.gaps, run.progress);
  if (!planned.contact) return;
  run_contact(scene, made_contacts(scene.pair), options, found.contact, run.progress);
}

void write_agreement(DriverRun& run) {
  AgreementOptions options;
  options.seed = run.record.seed;
  options.poses = run.quick() ? 1000 : 10000;
  Result result{
      "contact_agreement",
      "Do culled answers agree with the exact test of every vertex and with FCL, close to contact too?",
      agreement_table(options, contact_agreement(make_ball_socket_pair(options.triangles), options))};
  run.write(result);
}

// The texts of a result.
struct About {
  const char* name;
  const char* question;
  nlohmann::json parameters;
};

void write(DriverRun& run, const About& about, QuestionTable found, const std::vector<Column>& keys) {
  Result result{about.name, about.question};
  result.parameters = about.parameters;
  result.table = std::move(found.table);
  result.labels = std::move(found.labels);
  write_timed(run, std::move(result), keys, found.timing);
}

void write_points(DriverRun& run, const BenchmarkOptions& options, BenchmarkTables points) {
  Result result{"error_against_time_spread", "What is behind the errors and times of every method?"};
  result.parameters = parameters_of(options);
  result.labels = points.main.labels;
  result.table = std::move(points.spread);
  result.timing = timing_record(points.main.timing);
  run.write(result);
  write(run, {"error_against_time", "How wrong is every method, and what does it cost?", result.parameters},
        std::move(points.main), cost_keys());
}

void body(DriverRun& run) {
  BenchmarkOptions options = run.quick() ? quick_benchmark() : full_benchmark();
  options.radial.seed = options.euclidean.seed = options.seed = run.record.seed;
  write_agreement(run);
  Found found;
  try {
    for (const Planned& planned : scenes(run)) ask(planned, options, found, run);
  } catch (const BoundViolated& violated) {
    write_if_changed(run.record.folder / "error_against_time_witness.json",
                     violated.violation().text() + "\n");
    throw;
  }
  write_points(run, options, std::move(found.points));
  write(run,
        {"all_gaps", "How wrong are all gaps of a pose by every method, and what do they cost?",
         parameters_of(options)},
        std::move(found.gaps), gap_keys());
  write(run,
        {"contact",
         "Does the joint touch, or what is its smallest gap: time of a pose by every method?",
         {{"warm", true}, {"step_deg", 0.5}, {"motions", 16}}},
        std::move(found.contact), contact_keys());
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv,
                                  {"10_error_against_time", "Error against time, every method.",
                                   /*takes_bones=*/true},
                                  body);
}
