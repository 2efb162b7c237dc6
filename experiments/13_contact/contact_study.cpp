// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_contact/contact_study.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "13_contact/contact_motions.hpp"
#include "13_contact/exact_gaps.hpp"
#include "gap/overlay.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kSlowStride = 16;  // slow methods are asked in one pose of so many
constexpr double kExactTests = 3e5;      // vertices looked at for each joint and case, to compare
constexpr std::size_t kFewWrong = 8;     // a method in float is wrong in at most one pose of so many

// A joint and all that says whether it touches. It stays where it is made: the methods refer to it.
struct Stage {
  explicit Stage(const BenchmarkScene& of) : scene(of), pair(of.pair), culled(pair) {}
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  const BenchmarkScene& scene;
  const BallSocketPair& pair;  // mm
  CulledJoint culled;
  SurfaceOverlay overlay{pair.ball, pair.socket};
  std::vector<ContactCase> methods = cases_of(contact_methods(), &Method::contact, culled);
};

// What is timed and said of one method in poses of one gap.
struct Measured {
  TimedCase timed;
  std::size_t poses = 0;
  std::size_t touching = 0;      // of these, by this method
  Cell wrong;                    // of these, by the exact overlay; of methods that ask for faces
  double least_gap_mm = 0.0;     // median over the poses
  double error_mm = kNoSurface;  // largest of a gap of a table in the poses compared; NaN for other methods
};

// Poses of one gap, and whether the ball is anywhere beyond the socket in them, by the exact overlay.
struct Asked {
  void add(const Pose& pose, bool overlaps_there) {
    poses.push_back(pose);
    overlaps.push_back(overlaps_there);
  }
  std::vector<Pose> poses;
  std::vector<bool> overlaps;
};

double median_gap(const CulledJoint& joint, const std::vector<Pose>& poses) {
  std::vector<double> gaps;
  gaps.reserve(poses.size());
  for (const Pose& pose : poses) gaps.push_back(joint.least_gap(pose)->gap_mm);
  return summarise(gaps).median;
}

[[noreturn]] void differs(const ContactCase& method, const char* from) {
  throw std::runtime_error(method.name + ": an answer is not that of " + from +
                           ": its time means nothing until that is resolved");
}

// Compares answers in some of the poses. The largest error of a gap, mm, by the method.
std::map<std::string, double> compare(const Stage& stage, const std::vector<Pose>& poses) {
  std::map<std::string, double> largest;
  const auto vertices =
      static_cast<double>(stage.pair.ball.vertices.size() + stage.pair.socket.vertices.size());
  const auto most = static_cast<std::size_t>(kExactTests / vertices) + 1;
  const std::size_t stride = std::max<std::size_t>(1, poses.size() / most);
  for (std::size_t k = 0; k < poses.size(); k += stride) {
    const Pose& pose = poses[k];
    const bool truth = any_impinged(stage.culled, pose);
    const ExactGaps exact = exact_gaps(stage.culled, pose);
    for (const ContactCase& method : stage.methods) {
      if (method.contact == Contact::gaps) {
        double& error = largest[method.name];
        error = std::max(error, gap_error(method, exact, pose));
        continue;
      }
      if (method.contact == Contact::vertices && method.touches(pose) != truth)
        differs(method, "all vertices");
    }
  }
  return largest;
}

// Poses in which a method says of the faces what their exact overlay does not.
std::size_t count_wrong(const ContactCase& method, const Asked& asked) {
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < asked.poses.size(); ++k)
    wrong += method.touches(asked.poses[k]) != asked.overlaps[k] ? 1U : 0U;
  if (wrong * kFewWrong > asked.poses.size()) differs(method, "the exact overlay");
  return wrong;
}

std::function<void()> run_of(const ContactCase& method, std::vector<Pose> poses) {
  if (method.run) return [run = method.run, poses = std::move(poses)] { run(poses); };
  return [touches = method.touches, poses = std::move(poses)] {
    for (const Pose& pose : poses) benchmark::DoNotOptimize(touches(pose));
  };
}

void add_cases(const Stage& stage, const MotionGap& gap, const ContactOptionsTimed& options,
               std::vector<Measured>& cases, Progress& progress) {
  const std::vector<Pose> poses = contact_motions(stage.culled, gap, options.seed);
  if (poses.empty())
    progress.say(stage.scene.name + ": no motions with a smallest gap of " + std::string(gap.name));
  Asked all;
  Asked few;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    all.add(poses[k], stage.overlay.impinged(poses[k]));
    if (k % kSlowStride == 0) few.add(poses[k], all.overlaps[k]);
  }
  const std::map<std::string, double> errors = compare(stage, poses);
  for (const ContactCase& method : stage.methods) {
    if (poses.empty()) break;
    const Asked& asked = method.few ? few : all;
    Measured added;
    added.poses = asked.poses.size();
    added.touching = static_cast<std::size_t>(std::ranges::count_if(asked.poses, method.touches));
    if (method.contact == Contact::faces) added.wrong = count_wrong(method, asked);
    added.least_gap_mm = median_gap(stage.culled, asked.poses);
    if (errors.contains(method.name)) added.error_mm = errors.at(method.name);
    added.timed.key = {stage.scene.name, method.name, gap.name, stage.pair.ball.faces.size()};
    added.timed.units = static_cast<double>(asked.poses.size());
    added.timed.rounds = options.rounds;
    added.timed.run = run_of(method, asked.poses);
    cases.push_back(std::move(added));
  }
}

void add_rows(Table& table, const std::vector<Measured>& cases, const TimingRun& run) {
  constexpr double kMicroseconds = 1e3;  // in a millisecond
  constexpr double kMicrons = 1e3;       // in a millimetre
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Timing& timing = run.timings[k];
    const double median = timing.summary.median;
    std::vector<Cell> row = timing.key;
    row.insert(row.end(), {kMicroseconds * median, kMicroseconds * timing.summary.iqr, timing.summary.count,
                           cases[k].poses, cases[k].touching, cases[k].wrong, cases[k].least_gap_mm,
                           kMicrons * cases[k].error_mm});
    table.add_row(std::move(row));
  }
}

}  // namespace

std::vector<Column> contact_keys() {
  return {
      {"scene", "", "as in error_against_time.csv"},
      {"method", "",
       "fcl_collide, vtk_collide: trees of oriented boxes; ode_collide, bullet_collide: OPCODE's and "
       "GImpact's, "
       "along the axes, in float; "
       "fcl_distance: smallest distance; "
       "all_vertices: both scans by the kernels, all gaps, of tables in 16 bits; all_corners: of tables with "
       "the corners of a cell together and centred errors, as accurate; all_corners_2_threads: the same, two "
       "threads sharing the poses; all_corners_sampled: corners of finer tables, not centred, as accurate; "
       "culled: touch; coherent: touch, from one pose to the next; culled_least_gap: smallest gap"},
      {"gap_case", "", "smallest gap in the poses"},
      {"triangles", "1", "of the ball"}};
}

ContactTables make_contact_tables() {
  ContactTables tables;
  tables.table.columns = contact_keys();
  const std::vector<Column> more{
      {"us_pose", "us", "median time of a pose"},
      {"iqr_us", "us", "interquartile range of it over the rounds"},
      {"rounds", "1", "rounds measured"},
      {"poses", "1", "poses of a round: motions of 16, half a degree from one to the next"},
      {"touching", "1", "of these, by this method"},
      {"wrong", "1", "of these, in which it says of the faces what their exact overlay does not"},
      {"least_gap_mm", "mm", "median of the smallest gap of a pose"},
      {"error_um", "um",
       "largest error of a gap at a vertex, in those of the poses that were compared; of tables alone"}};
  tables.table.columns.insert(tables.table.columns.end(), more.begin(), more.end());
  return tables;
}

void run_contact(const BenchmarkScene& scene, const ContactOptionsTimed& options, ContactTables& tables,
                 Progress& progress) {
  const Stage stage(scene);
  std::vector<Measured> cases;
  add_labels(tables.labels, stage.methods);
  for (const MotionGap& gap : kMotionGaps) add_cases(stage, gap, options, cases, progress);
  progress.say(scene.name + ": made the poses");
  std::vector<TimedCase> timed;
  timed.reserve(cases.size());
  for (const Measured& one : cases) timed.push_back(one.timed);
  TimingRun run = run_interleaved(timed, options.timing, progress);
  add_rows(tables.table, cases, run);
  append(tables.timing, std::move(run));
}

}  // namespace impinge::lab
