// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <benchmark/benchmark.h>

#include "10_error_against_time/contact.hpp"
#include "files/stopwatch.hpp"
#include "limits/turn_limit.hpp"
#include "methods/heap_use.hpp"
#include "reference/meeting_surfaces.hpp"
#include "sphere/uniform_directions.hpp"

namespace impinge::lab {
namespace {

constexpr double kFarthest = 120.0;     // degrees
constexpr std::size_t kTurns = 8;       // turns of a scene
constexpr std::size_t kTurnTries = 40;  // axes that are tried for them
constexpr double kResolution = 1e-3;    // degrees, of the halvings
constexpr std::size_t kSlowTurns = 2;   // of slow methods
constexpr double kSlowStep = 1.0;       // degrees, of slow methods

const std::vector<double> kQuickSteps{5.0, 1.0};
const std::vector<double> kFullSteps{5.0, 1.0, 0.2};

Pose turned(const Vec3& axis, double angle_deg) {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(angle_deg * kDegree, axis).toRotationMatrix();
  return pose;
}

JointTurn turn_about(const Vec3& axis) {
  JointTurn turn;
  turn.axis = axis;
  return turn;
}

// A motion and its first contact.
struct TrueContact {
  Vec3 axis;  // unit
  double low_deg, high_deg;
};

// Motions that end in contact. CGAL decides exactly whether both ends of a bracket touch.
std::vector<TrueContact> motions_of(const BenchmarkScene& scene, const TurnLimits& limits,
                                    std::uint64_t seed) {
  const auto meet = [&](const Pose& pose) {
    TriangleMesh ball = scene.pair.ball;
    for (Vec3& x : ball.vertices) x = to_socket(pose, x);
    return surfaces_meet(ball, scene.pair.socket);
  };
  std::mt19937_64 random(seed);
  std::vector<TrueContact> motions;
  for (std::size_t k = 0; k < kTurnTries && motions.size() < kTurns; ++k) {
    const Vec3 axis = uniform_direction(random);
    const TurnLimit limit = limits.first_contact(turn_about(axis), kFarthest);
    if (limit.state == LimitState::blocked) break;
    if (limit.state != LimitState::limited) continue;
    if (meet(turned(axis, limit.low_deg)) || !meet(turned(axis, limit.high_deg)))
      throw std::runtime_error(scene.name + ": the exact test contradicts a limit");
    motions.push_back({axis, limit.low_deg, limit.high_deg});
  }
  return motions;
}

// Steps until a pose touches, then halves the last step; kFarthest if none touches.
double march(const Touch& touches, const Vec3& axis, double step_deg) {
  double free = 0.0;
  double touching = step_deg;
  while (!touches(turned(axis, touching))) {
    if (touching >= kFarthest) return kFarthest;
    free = touching;
    touching = std::min(touching + step_deg, kFarthest);
  }
  while (touching - free > kResolution) {
    const double middle = 0.5 * (free + touching);
    (touches(turned(axis, middle)) ? touching : free) = middle;
  }
  return touching;
}

// What is timed and reported of one method.
struct AskedTurn {
  TimedCase timed;
  double build_ms = 0.0;
  double bytes = 0.0;
  std::size_t motions = 0;
  std::size_t missed = 0;  // of these, not found by the method
  std::vector<double> errors_deg;
  Cell bound_deg;
};

std::vector<Cell> key_of(const BenchmarkScene& scene, const std::string& method, const std::string& setting) {
  return {scene.name, method, setting, scene.pair.ball.faces.size()};
}

AskedTurn of_bracket(const BenchmarkScene& scene, const TurnLimits& limits,
                     const std::vector<TrueContact>& motions) {
  AskedTurn asked;
  asked.motions = motions.size();
  double widest = 0.0;
  for (const TrueContact& motion : motions) widest = std::max(widest, motion.high_deg - motion.low_deg);
  asked.errors_deg.assign(motions.size(), widest);
  asked.bound_deg = widest;
  asked.timed.key = key_of(scene, "turn_limit", "bracket");
  asked.timed.run = [&limits, &motions] {
    for (const TrueContact& motion : motions)
      benchmark::DoNotOptimize(limits.first_contact(turn_about(motion.axis), kFarthest));
  };
  return asked;
}

AskedTurn of_steps(const BenchmarkScene& scene, const MadeContact& made, double step_deg,
                   std::span<const TrueContact> motions) {
  AskedTurn asked;
  asked.build_ms = 1e3 * made.build_s;
  asked.bytes = made.bytes;
  asked.motions = motions.size();
  for (const TrueContact& motion : motions) {
    const double angle = march(made.query->touches, motion.axis, step_deg);
    asked.missed += angle >= kFarthest ? 1U : 0U;
    asked.errors_deg.push_back(std::abs(angle - motion.high_deg));
  }
  asked.timed.key = key_of(scene, made.method.name, "steps of " + Cell(step_deg).text() + " deg");
  asked.timed.run = [query = made.query, step_deg, motions] {
    for (const TrueContact& motion : motions)
      benchmark::DoNotOptimize(march(query->touches, motion.axis, step_deg));
  };
  return asked;
}

void add_rows(Table& table, const std::vector<AskedTurn>& all, const TimingRun& run) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Timing& timing = run.timings[k];
    const AskedTurn& asked = all[k];
    std::vector<Cell> row = timing.key;
    row.insert(row.end(), {asked.build_ms, timing.summary.median, timing.summary.iqr, timing.summary.count,
                           asked.motions, asked.missed, std::ranges::max(asked.errors_deg),
                           summarise(asked.errors_deg).median, asked.bound_deg, asked.bytes});
    table.add_row(std::move(row));
  }
}

}  // namespace

std::vector<Column> first_contact_keys() {
  return {
      {"scene", "", "as in error_against_time.csv"},
      {"method", "", "turn_limit: limits/turn_limit.hpp; others: touch as in contact.csv"},
      {"setting", "", "a bracket, or the steps until a pose touches; these are then halved to 0.001 degrees"},
      {"triangles", "1", "of the ball"}};
}

QuestionTable make_first_contact_table() {
  return question_table(
      first_contact_keys(),
      {{"build_ms", "ms", "time of everything that is done once for a joint"},
       {"ms_motion", "ms", "median time of a motion"},
       {"iqr_ms", "ms", "interquartile range of it over the rounds"},
       {"rounds", "1", "rounds measured"},
       {"motions", "1", "turns about random axes, up to 120 degrees, that end in contact"},
       {"missed", "1", "of these, in which it finds no contact"},
       {"error_deg", "deg",
        "largest distance of its angle from the first contact of limits/turn_limit.hpp, from 120 degrees "
        "where it finds none; of turn_limit the widest bracket, whose ends CGAL confirms"},
       {"median_error_deg", "deg", "median of the same"},
       {"bound_deg", "deg", "proven bound on the error; empty where nothing is proven"},
       {"bytes", "B", "growth of the heap (mallinfo2) while building"}});
}

void run_first_contact(const BenchmarkScene& scene, std::span<const MadeContact> methods, bool quick,
                       const BenchmarkOptions& options, QuestionTable& found, Progress& progress) {
  const double before = heap_bytes();
  Stopwatch watch;
  const TurnLimits limits(scene.pair);
  const double build_ms = watch.lap_ms();
  const double bytes = heap_bytes() - before;
  const std::vector<TrueContact> motions = motions_of(scene, limits, options.seed);
  progress.say(scene.name + ": first contact of " + std::to_string(motions.size()) + " motions");
  if (motions.empty()) return;
  std::vector<AskedTurn> all{of_bracket(scene, limits, motions)};
  all.front().build_ms = build_ms;
  all.front().bytes = bytes;
  found.labels.emplace("turn_limit", "bracket, proven");
  const std::span every(motions);
  for (const MadeContact& made : methods) {
    if (made.method.contact == Contact::gaps || made.query->smallest) continue;
    add_labels(found.labels, std::vector{made.method});
    for (const double step : quick ? kQuickSteps : kFullSteps) {
      if (made.method.few && step < (quick ? kQuickSteps.front() : kSlowStep)) continue;
      const std::size_t count = made.method.few ? std::min(kSlowTurns, motions.size()) : motions.size();
      all.push_back(of_steps(scene, made, step, every.first(count)));
    }
  }
  std::vector<TimedCase> cases;
  for (AskedTurn& one : all) {
    one.timed.units = static_cast<double>(one.motions);
    one.timed.rounds = options.pose_timing.rounds;
    cases.push_back(one.timed);
  }
  TimingRun run = run_interleaved(cases, options.pose_timing.options, progress);
  add_rows(found.table, all, run);
  append(found.timing, std::move(run));
}

}  // namespace impinge::lab
