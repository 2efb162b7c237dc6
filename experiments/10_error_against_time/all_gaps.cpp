// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

#include <benchmark/benchmark.h>

#include "10_error_against_time/report.hpp"
#include "files/stopwatch.hpp"
#include "methods/benchmark_scene.hpp"
#include "methods/instruction_set.hpp"
#include "reference/exact_radius.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kKernelQuestions = 1 << 20;  // vertices in one run, about
constexpr std::size_t kOtherQuestions = 1 << 17;
constexpr std::size_t kFewQuestions = 1 << 10;
constexpr std::size_t kAlone = 256;  // vertices that are asked one by one
constexpr int kComparedTurns = 12;   // poses in which all gaps are compared: up to 55 degrees
constexpr int kThreads = 2;
constexpr double kDistance = 25.0;       // mm, of the probes in float: as far as the joint space
constexpr double kMostError = 1.0;       // mm: with the coarsest table here 99 of 100 probes have less
constexpr double kMostFalseHits = 0.02;  // share of the probes: those on the rim itself, in float

// A method with its errors.
struct Examined {
  GapCase method;
  std::shared_ptr<const GapQuery> query;
  double build_s = 0.0;  // of the query, at first use
  BenchmarkErrors errors;
  MethodBound bound;
  double scan_mm = 0.0;          // largest error of a gap over the poses of a motion
  std::size_t scan_missing = 0;  // gaps in these poses without an answer, though the surface is met
};

// Some of the points, evenly spread through the list.
AskedPoints few_of(const std::vector<Vec3>& all) {
  std::vector<Vec3> few;
  const std::size_t step = all.size() / kFewQuestions + 1;
  for (std::size_t i = 0; i < all.size(); i += step) few.push_back(all[i]);
  return AskedPoints(std::move(few));
}

ProbeOptions in_float(ProbeOptions options) {
  options.float_at = kDistance;
  return options;
}

// A direction of the scan: the vertices of one surface against the other.
struct Direction {
  const BenchmarkScene& scene;
  AskedSurface surface;  // the other surface
  AskedPoints all;
  AskedPoints few;
  BenchmarkProbes radial;
  BenchmarkProbes euclidean;
  std::vector<std::vector<double>> exact;  // gaps of all vertices in some poses of the motion, by CGAL, mm

  Direction(const BenchmarkScene& of, Surface scanned, const BenchmarkOptions& options)
      : scene(of),
        surface{mesh_of(of.pair, other(scanned)), facing_layer(other(scanned)), scanned},
        all(mesh_of(of.pair, scanned).vertices),
        few(few_of(all.points)),
        radial(radial_probes(surface.mesh, surface.layer, in_float(options.radial))),
        euclidean(euclidean_probes(surface.mesh, kDistance, options.euclidean)) {
    for (int turn = 0; turn < kComparedTurns; ++turn) {
      std::vector<Vec3> moved;
      for (const Vec3& x : all.points) moved.push_back(to_other(scanned, motion_pose(of.axis, turn), x));
      exact.push_back(exact_radii(surface.mesh, {moved, surface.layer, {}}));
      for (std::size_t i = 0; i < moved.size(); ++i)
        exact.back()[i] = signed_gap(scanned, exact.back()[i], moved[i].norm());
    }
  }

  std::string name() const { return scanned_ball() ? "ball->socket" : "socket->ball"; }
  bool scanned_ball() const { return surface.scanned == Surface::ball; }
};

// The radii of a surface from a method's gaps in the socket's own pose; distances if the method gives these.
PointQuery radii_by(const GapQuery& query, Surface scanned) {
  return {[&query, scanned](std::span<const Vec3> points, std::span<double> out) {
    const bool radial = query.measure == Measure::radial;
    const AskedPoints asked({points.begin(), points.end()});
    GapScratch scratch;
    query.scan(asked, {}, scratch);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double gap = scratch.gap(i);
      out[i] = radial ? asked.points[i].norm() + gap_sign<double>(scanned) * gap : gap;
    }
  }};
}

void require_good(const Examined& found, const Direction& direction) {
  const BenchmarkErrors& errors = found.errors;
  const double false_share = static_cast<double>(errors.false_hits) / static_cast<double>(errors.directions);
  if (errors.p99 <= kMostError && (false_share <= kMostFalseHits || found.method.maskless)) return;
  throw std::runtime_error(direction.scene.name + ", " + direction.name() + ": " + found.method.name + " " +
                           found.method.setting + " " + found.method.storage + " is off by " +
                           std::to_string(errors.p99) + " mm, with " + std::to_string(errors.false_hits) +
                           " false hits: its time means nothing until its answers are right");
}

// The errors of the scans themselves.
void compare_scans(Examined& found, const Direction& direction) {
  GapScratch scratch;
  for (std::size_t turn = 0; turn < direction.exact.size(); ++turn) {
    found.query->scan(direction.all, motion_pose(direction.scene.axis, static_cast<int>(turn)), scratch);
    for (std::size_t i = 0; i < direction.all.points.size(); ++i) {
      const double exact = direction.exact[turn][i];
      const double error = std::abs(scratch.gap(i) - exact);
      if (error > found.scan_mm) found.scan_mm = error;  // a NaN is not larger
      found.scan_missing += !std::isnan(exact) && std::isnan(error) ? 1U : 0U;
    }
  }
}

Examined examine(const GapCase& method, const Direction& direction, const AscentOptions& ascent) {
  Examined found{method, {}, 0.0, {}, {}, 0.0, 0};
  Stopwatch watch;
  found.query = std::make_shared<const GapQuery>(method.make());
  found.build_s = watch.lap_s();
  if (!found.query->answers) return found;
  const bool radial = found.query->measure == Measure::radial;
  found.errors = measure_errors(radii_by(*found.query, direction.surface.scanned),
                                radial ? direction.radial : direction.euclidean, ascent);
  if (radial) compare_scans(found, direction);
  if (method.bound) found.bound.bound_mm = method.bound();
  require_good(found, direction);
  require_bound(found.errors, found.bound, {direction.scene.name, method.name, method.setting});
  return found;
}

struct Work {
  std::shared_ptr<const GapQuery> query;
  const AskedPoints& asked;
  Vec3 axis;  // of the motion
  std::string instruction_set;
  int threads;
  int poses;
};

void scan_poses(const Work& work, GapScratch& scratch) {
  for (int k = 0; k < work.poses; ++k) {
    work.query->scan(work.asked, motion_pose(work.axis, k), scratch);
    benchmark::DoNotOptimize(scratch.floats.data());
    benchmark::DoNotOptimize(scratch.doubles.data());
    benchmark::ClobberMemory();
  }
}

// Each thread answers some poses alone.
std::function<void()> run_of(const Work& work) {
  auto scratches = std::make_shared<std::vector<GapScratch>>(work.threads);
  return [work, scratches] {
    use_instruction_set(work.instruction_set);
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < scratches->size(); ++t)
      others.emplace_back([&work, &scratch = (*scratches)[t]] { scan_poses(work, scratch); });
    scan_poses(work, scratches->front());
  };
}

// Asks each vertex by itself, in a pose of its own.
std::function<void()> one_after_one(const Work& work) {
  auto alone = std::make_shared<std::vector<AskedPoints>>();
  const std::vector<Vec3>& points = work.asked.points;
  for (std::size_t k = 0; k < kAlone; ++k)
    alone->emplace_back(std::vector{points[k * points.size() / kAlone]});
  std::vector<Pose> poses;
  poses.reserve(kAlone);
  for (int turn = 0; turn < static_cast<int>(kAlone); ++turn) poses.push_back(motion_pose(work.axis, turn));
  auto scratch = std::make_shared<GapScratch>();
  return [work, alone, poses = std::move(poses), scratch] {
    use_instruction_set(work.instruction_set);
    for (std::size_t k = 0; k < kAlone; ++k) {
      work.query->scan((*alone)[k], poses[k], *scratch);
      benchmark::ClobberMemory();
    }
  };
}

// Answers one pose of the motion after the other.
std::function<void()> pose_after_pose(const Work& work) {
  auto scratch = std::make_shared<GapScratch>();
  auto turn = std::make_shared<int>(0);
  return [work, scratch, turn] {
    use_instruction_set(work.instruction_set);
    work.query->scan(work.asked, motion_pose(work.axis, (*turn)++), *scratch);
  };
}

// A row of the table, as indices of the cases.
struct Row {
  std::size_t time = 0;
  std::size_t build = 0;
  std::size_t method = 0;  // index in the examined methods
  std::size_t vertices = 0;
};

// All work on one scene.
struct Asking {
  const BenchmarkTiming& timing;
  std::function<void()> flush;
  Built<GapQuery> built = std::make_shared<std::optional<GapQuery>>();
  std::vector<Examined> examined = {};
  std::vector<TimedCase> cases = {};
  std::vector<Row> rows = {};
};

std::vector<Cell> key_of(const Direction& direction, const GapCase& method, const Work& work,
                         const char* state) {
  return {direction.scene.name,
          direction.scene.pair.ball.faces.size(),
          direction.name(),
          method.name,
          method.setting,
          method.storage,
          method.kernel ? work.instruction_set : std::string("none"),
          work.threads,
          state};
}

void add_case(Asking& asking, std::vector<Cell> key, const Work& work, std::string_view state) {
  const bool cold = state == "cold";
  const bool alone = state == "alone";
  TimedCase timed;
  timed.key = std::move(key);
  timed.run = cold ? pose_after_pose(work) : alone ? one_after_one(work) : run_of(work);
  if (cold) timed.before = asking.flush;
  timed.rounds = asking.timing.rounds;
  timed.units = static_cast<double>(work.asked.points.size()) * (cold ? 1 : work.threads * work.poses);
  if (alone) timed.units = static_cast<double>(kAlone);
  asking.cases.push_back(std::move(timed));
}

// Adds the building of a method, and each way of asking that suits it.
void add_method(Asking& asking, const Direction& direction, const GapCase& method, const GapPlan& plan) {
  const Examined& found = asking.examined.back();
  const AskedPoints& asked = method.few ? direction.few : direction.all;
  const std::size_t questions = method.kernel ? kKernelQuestions : method.few ? 1 : kOtherQuestions;
  Work work{found.query,
            asked,
            direction.scene.axis,
            instruction_sets().front(),
            1,
            static_cast<int>(questions / asked.points.size()) + 1};
  const std::size_t build = asking.cases.size();
  asking.cases.push_back(build_case(key_of(direction, method, work, "build"), asking.built, method.make,
                                    found.build_s, asking.timing));
  const auto add = [&](const char* state) {
    asking.rows.push_back(
        {asking.cases.size(), build, asking.examined.size() - 1, direction.all.points.size()});
    add_case(asking, key_of(direction, method, work, state), work, state);
  };
  for (const std::string& set : instruction_sets()) {
    work.instruction_set = set;
    if (set == instruction_sets().front() || (method.widely && plan.thorough)) add("warm");
  }
  work.instruction_set = instruction_sets().front();
  if (!plan.sizes.degrees.empty()) add("alone");
  if (plan.thorough && !method.few) add("cold");
  work.threads = kThreads;
  if (method.widely) add("warm");
}

void add_rows(Table& table, const Asking& asking, const TimingRun& run) {
  for (const Row& place : asking.rows) {
    const Timing& timing = run.timings[place.time];
    const Examined& of = asking.examined[place.method];
    const BenchmarkErrors& errors = of.errors;
    const auto microns = [&](double mm) { return of.query->answers ? Cell(kMicrometres * mm) : Cell(); };
    std::vector<Cell> row = timing.key;
    row.insert(row.end(),
               {run.timings[place.build].summary.median, kNanoseconds * timing.summary.median,
                kNanoseconds * timing.summary.iqr, timing.summary.count, name_of(of.query->measure),
                microns(errors.max_over), microns(errors.max_under), microns(errors.rms), microns(errors.p99),
                std::isfinite(of.bound.bound_mm) ? Cell(kMicrometres * of.bound.bound_mm) : Cell(),
                errors.misses, errors.false_hits, errors.directions, of.query->bytes, place.vertices,
                of.query->measure == Measure::radial ? microns(of.scan_mm) : Cell(), of.scan_missing});
    table.add_row(std::move(row));
  }
}

}  // namespace

std::vector<Column> gap_keys() {
  return {
      {"scene", "", "as in error_against_time.csv"},
      {"triangles", "1", "of the ball"},
      {"direction", "", "whose vertices are looked up -> in whose surface"},
      {"method", "",
       "embree_rayN: N rays at a time; floor: a memory-bound baseline, the least a look-up does; "
       "SCHEME_scalar: the library in double; SCHEME_thesis: the tables of the thesis, filled as it does; "
       "conchoid, icosahedral_gnomonic_mesh_exact: look-ups in double; cgal_, embree_closest: trees; "
       "cube_no_mask: without the bits of the rim; others: kernels of that scheme"},
      {"setting", "",
       "cells along an edge of the cube (n=) or for a face, degrees of the grid, or Embree's quality"},
      {"storage", "", "double, float, uint16 or none"},
      {"instruction_set", "", "of a kernel, in Highway's names; none: as compiled"},
      {"threads", "1", "that ask at the same time"},
      {"state", "",
       "warm: pose after pose; cold: after a block larger than all caches was overwritten, each pose "
       "timed alone; alone: one vertex asked by itself, each in a pose of its own"}};
}

QuestionTable make_gap_table() {
  return question_table(
      gap_keys(),
      {{"build_ms", "ms", "median time of everything that is done once for a surface"},
       {"ns_vertex", "ns",
        "median time of one vertex, its share of the pose included; of all threads together"},
       {"iqr_ns", "ns", "interquartile range of it over the rounds"},
       {"rounds", "1", "rounds measured"},
       {"measure", "", "radial gaps, or Euclidean distances, whose errors are those of distances"},
       {"max_over_um", "um", "largest error of a radius to the far side; none for the floor"},
       {"max_under_um", "um", "to the near side"},
       {"rms_um", "um", "root mean square over directions uniform on the sphere: by solid angle"},
       {"p99_um", "um", "quantile 0.99 of the same errors without sign"},
       {"bound_um", "um",
        "proven bound on the error of a radius, rounding of the kernels included; empty where there is none "
        "that says anything. An error above it ends the run"},
       {"misses", "1", "directions without an answer where there is a surface: cells of the rim"},
       {"false_hits", "1", "directions with an answer where there is no surface"},
       {"directions", "1", "in which the error was looked at"},
       {"bytes", "B", "of table and mask, or of a library's tree"},
       {"vertices", "1", "of the surface that is looked up: a pose takes so many times ns_vertex"},
       {"scan_um", "um",
        "largest error of the gaps of all vertices in 12 poses, 0 to 55 degrees of the motion, against CGAL"},
       {"scan_missing", "1", "of these gaps, those without an answer where the surface is met"}});
}

void run_all_gaps(const BenchmarkScene& scene, const GapPlan& plan, const BenchmarkOptions& options,
                  QuestionTable& found, Progress& progress) {
  progress.say(scene.name + ": all gaps of a pose");
  const Direction directions[] = {{scene, Surface::ball, options}, {scene, Surface::socket, options}};
  Asking asking{options.gap_timing, overwrite_caches(options.gap_timing.flush_bytes)};
  for (const Direction& direction : directions) {
    const auto methods = cases_of(gaps_methods(), &Method::gaps, direction.surface, plan.sizes);
    add_labels(found.labels, methods);
    for (const GapCase& method : methods) {
      Examined examined = examine(method, direction, options.ascent);
      asking.examined.push_back(std::move(examined));
      add_method(asking, direction, method, plan);
    }
  }
  TimingRun run = run_interleaved(asking.cases, options.gap_timing.options, progress);
  use_best_instruction_set();
  add_rows(found.table, asking, run);
  append(found.timing, std::move(run));
}

}  // namespace impinge::lab
