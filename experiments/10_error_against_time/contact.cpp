// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/contact.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "files/stopwatch.hpp"
#include "gap/overlay.hpp"
#include "methods/heap_use.hpp"
#include "methods/pose_set.hpp"
#include "sphere/infinity.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kSlowStride = 16;  // slow methods answer one of this many poses
constexpr double kExactTests = 3e5;      // vertices looked at in comparisons, for each joint and case
constexpr double kExactPairs = 2e8;  // pairs of vertices up to which the distance of the surfaces is compared
constexpr std::size_t kFewWrong = 8;  // a method in float is wrong in at most one of this many poses

// A joint with everything that says whether it touches.
struct ContactStage {
  ContactStage(const BenchmarkScene& of, std::span<const MadeContact> by)
      : scene(of), pair(of.pair), methods(by), culled(pair) {}
  ContactStage(const ContactStage&) = delete;
  ContactStage& operator=(const ContactStage&) = delete;

  const BenchmarkScene& scene;
  const BallSocketPair& pair;  // mm
  std::span<const MadeContact> methods;
  CulledJoint culled;
  SurfaceOverlay overlay{pair.ball, pair.socket};
};

// What is timed and reported of one method in poses with one gap.
struct AskedContact {
  const MadeContact* method = nullptr;
  std::size_t build = 0;  // index of its building in the timed cases
  std::size_t time = 0;   // index of its answers
  std::size_t poses = 0;
  std::size_t touching = 0;      // poses that touch by this method
  std::size_t wrong = 0;         // poses in which the exact overlay says otherwise
  double least_gap_mm = 0.0;     // median over the poses
  double error_mm = kNoSurface;  // largest error of a gap in the compared poses; NaN for touch
  double own_mm = 0.0;           // largest difference of our own exact gaps from the reference in these
};

// All work on one scene.
struct ContactAsking {
  std::vector<TimedCase> timed = {};
  std::vector<AskedContact> asked = {};
};

// Poses with one gap, and whether the exact overlay finds the ball anywhere beyond the socket.
struct Judged {
  void add(const Pose& pose, bool overlaps_there) {
    poses.push_back(pose);
    overlaps.push_back(overlaps_there);
  }
  std::vector<Pose> poses;
  std::vector<bool> overlaps;
};

std::string_view question_of(const MadeContact& made) {
  if (made.method.contact == Contact::gaps) return "all gaps";
  return made.query->smallest ? "smallest gap" : "touch";
}

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

double least_of(const ExactGaps& exact) {
  double least = kInfinity;
  for (const auto* gaps : {&exact.ball, &exact.socket}) {
    for (const double gap : *gaps)
      if (gap < least) least = gap;
  }
  return least;
}

// Error of a smallest gap, mm; NaN where the truth takes too long.
double smallest_error(const MadeContact& made, const ContactStage& stage, const Pose& pose,
                      const ExactGaps& exact) {
  if (made.method.measure == Measure::radial) return std::abs(made.query->smallest(pose) - least_of(exact));
  const auto pairs = static_cast<double>(stage.pair.ball.vertices.size()) *
                     static_cast<double>(stage.pair.socket.vertices.size());
  if (pairs > kExactPairs) return kNoSurface;
  BenchmarkScene posed = stage.scene;
  posed.pose = pose;
  return std::abs(made.query->smallest(pose) - surface_distance(posed));
}

// The result of comparing answers in some of the poses, mm.
struct Compared {
  std::map<std::string, double> largest = {};  // largest error of a gap, by method
  double own = 0.0;                            // difference of our own exact gaps from the reference
};

Compared compare(const ContactStage& stage, const std::vector<Pose>& poses) {
  Compared found;
  const auto add = [&](const MadeContact& made, double error) {
    double& of = found.largest.try_emplace(made.method.name, error).first->second;
    of = std::max(of, error);
  };
  const auto vertices =
      static_cast<double>(stage.pair.ball.vertices.size() + stage.pair.socket.vertices.size());
  const auto most = static_cast<std::size_t>(kExactTests / vertices) + 1;
  const std::size_t stride = std::max<std::size_t>(1, poses.size() / most);
  for (std::size_t k = 0; k < poses.size(); k += stride) {
    const Pose& pose = poses[k];
    const bool truth = any_impinged(stage.culled, pose);
    const ExactGaps exact = exact_gaps(stage.pair, pose);
    found.own = std::max(found.own, own_difference(stage.culled, exact, pose));
    for (const MadeContact& made : stage.methods) {
      if (made.method.contact == Contact::gaps)
        add(made, gap_error(made, exact, pose));
      else if (made.method.contact == Contact::vertices && made.query->touches(pose) != truth)
        differs(made.method, "all vertices");
      if (made.query->smallest && (made.method.measure == Measure::radial || k == 0))
        add(made, smallest_error(made, stage, pose, exact));
    }
  }
  return found;
}

// Counts poses in which a method contradicts the exact overlay of the faces; a method of faces seldom may.
std::size_t count_wrong(const MadeContact& made, const Judged& judged) {
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < judged.poses.size(); ++k)
    wrong += made.query->touches(judged.poses[k]) != judged.overlaps[k] ? 1U : 0U;
  if (made.method.contact == Contact::faces && wrong * kFewWrong > judged.poses.size())
    differs(made.method, "the exact overlay");
  return wrong;
}

std::function<void()> run_of(const std::shared_ptr<const ContactQuery>& query, std::vector<Pose> poses) {
  if (query->run) return [query, poses = std::move(poses)] { query->run(poses); };
  return [query, poses = std::move(poses)] {
    for (const Pose& pose : poses) benchmark::DoNotOptimize(query->touches(pose));
  };
}

std::vector<Cell> key_of(const ContactStage& stage, const MadeContact& made, std::string_view gap) {
  return {stage.scene.name, made.method.name, gap, stage.pair.ball.faces.size()};
}

void add_cases(const ContactStage& stage, const MotionGap& gap, const BenchmarkOptions& options,
               ContactAsking& asking, Progress& progress) {
  const std::vector<Pose> poses = contact_motions(stage.culled, gap, options.seed);
  if (poses.empty()) {
    progress.say(stage.scene.name + ": no motions with a smallest gap of " + std::string(gap.name));
    return;
  }
  Judged all;
  Judged few;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    all.add(poses[k], stage.overlay.impinged(poses[k]));
    if (k % kSlowStride == 0) few.add(poses[k], all.overlaps[k]);
  }
  const Compared compared = compare(stage, poses);
  for (std::size_t m = 0; m < stage.methods.size(); ++m) {
    const MadeContact& made = stage.methods[m];
    const Judged& judged = made.method.few ? few : all;
    AskedContact added{&made, m, asking.timed.size(), judged.poses.size()};
    added.touching = static_cast<std::size_t>(std::ranges::count_if(judged.poses, made.query->touches));
    added.wrong = count_wrong(made, judged);
    added.least_gap_mm = median_gap(stage.culled, judged.poses);
    const auto error = compared.largest.find(made.method.name);
    if (error != compared.largest.end()) added.error_mm = error->second;
    added.own_mm = compared.own;
    asking.asked.push_back(added);
    TimedCase timed;
    timed.key = key_of(stage, made, gap.name);
    timed.units = static_cast<double>(judged.poses.size());
    timed.rounds = options.pose_timing.rounds;
    timed.run = run_of(made.query, judged.poses);
    asking.timed.push_back(std::move(timed));
  }
}

void add_rows(Table& table, const ContactAsking& asking, const TimingRun& run) {
  constexpr double kMicroseconds = 1e3;  // in a millisecond
  for (const AskedContact& one : asking.asked) {
    const Timing& timing = run.timings[one.time];
    std::vector<Cell> row = timing.key;
    row.insert(row.end(), {question_of(*one.method), run.timings[one.build].summary.median,
                           kMicroseconds * timing.summary.median, kMicroseconds * timing.summary.iqr,
                           timing.summary.count, one.poses, one.touching, one.wrong, one.least_gap_mm,
                           name_of(one.method->method.measure), kMicrometres * one.error_mm,
                           one.method->bytes, kMicrometres * one.own_mm});
    table.add_row(std::move(row));
  }
}

}  // namespace

std::vector<MadeContact> made_contacts(const BallSocketPair& pair) {
  std::vector<MadeContact> all;
  for (ContactCase& method : cases_of(contact_methods(), &Method::contact, pair)) {
    const double before = heap_bytes();
    Stopwatch watch;
    auto query = std::make_shared<const ContactQuery>(method.make());
    const double build_s = watch.lap_s();
    all.push_back({std::move(method), std::move(query), build_s, heap_bytes() - before});
  }
  return all;
}

std::vector<Column> contact_keys() {
  return {
      {"scene", "", "as in error_against_time.csv"},
      {"method", "",
       "fcl_collide: trees of oriented boxes; ode_collide, bullet_collide: OPCODE's and "
       "GImpact's, along the axes, in float; fcl_distance: smallest distance; all_vertices: both scans by "
       "the kernels, all gaps, of tables in 16 bits; culled_faces: radial overlap, edges and all; culled: of "
       "vertices; culled_least_gap: smallest gap of a vertex"},
      {"gap_case", "", "smallest gap in the poses; build, among the samples: everything done once"},
      {"triangles", "1", "of the ball"}};
}

QuestionTable make_contact_table() {
  return question_table(
      contact_keys(),
      {{"question", "", "touch, smallest gap or all gaps"},
       {"build_ms", "ms", "median time of everything that is done once for a joint"},
       {"us_pose", "us", "median time of a pose"},
       {"iqr_us", "us", "interquartile range of it over the rounds"},
       {"rounds", "1", "rounds measured"},
       {"poses", "1", "poses of a round: motions of 16, half a degree from one to the next"},
       {"touching", "1", "of these, by this method"},
       {"wrong", "1",
        "of these, in which it says of the bodies' touch what the exact overlay of the faces does not"},
       {"least_gap_mm", "mm", "median of the smallest gap of a pose"},
       {"measure", "", "radial gaps, or Euclidean distances"},
       {"error_um", "um",
        "largest error of a gap at a vertex, or of the smallest, in those of the poses that were compared "
        "with CGAL"},
       {"bytes", "B", "growth of the heap (mallinfo2) while building"},
       {"own_um", "um", "largest difference of our own exact gaps from CGAL's in these poses"}});
}

void run_contact(const BenchmarkScene& scene, std::span<const MadeContact> methods,
                 const BenchmarkOptions& options, QuestionTable& found, Progress& progress) {
  const ContactStage stage(scene, methods);
  ContactAsking asking;
  const auto built = std::make_shared<std::optional<ContactQuery>>();
  for (const MadeContact& made : stage.methods) {
    add_labels(found.labels, std::vector{made.method});
    asking.timed.push_back(
        build_case(key_of(stage, made, "build"), built, made.method.make, made.build_s, options.pose_timing));
  }
  for (const MotionGap& gap : kMotionGaps) add_cases(stage, gap, options, asking, progress);
  progress.say(scene.name + ": made the poses");
  TimingRun run = run_interleaved(asking.timed, options.pose_timing.options, progress);
  add_rows(found.table, asking, run);
  append(found.timing, std::move(run));
}

}  // namespace impinge::lab
