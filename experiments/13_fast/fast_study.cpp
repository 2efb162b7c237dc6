// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_fast/fast_study.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <thread>
#include <utility>

#include <Eigen/Geometry>
#include <benchmark/benchmark.h>

#include "13_fast/fast_table.hpp"
#include "gap/simd/instruction_set.hpp"
#include "harness/cold_timing.hpp"
#include "mesh/generated_pair.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kKernelQuestions = 1 << 20;  // vertices of one run, about
constexpr std::size_t kOtherQuestions = 1 << 17;
constexpr std::size_t kFewQuestions = 1 << 10;
constexpr int kThreads = 2;

// Some of the points, evenly through all of them.
AskedPoints few_of(const std::vector<Vec3>& all) {
  std::vector<Vec3> few;
  const std::size_t step = all.size() / kFewQuestions + 1;
  for (std::size_t i = 0; i < all.size(); i += step) few.push_back(all[i]);
  return AskedPoints(std::move(few));
}

// A pair with its points, those of the ball first; what is timed refers to it.
struct Stage {
  BallSocketPair pair;
  std::array<AskedPoints, 2> all;
  std::array<AskedPoints, 2> few;

  explicit Stage(std::size_t triangles)
      : pair(make_ball_socket_pair(triangles)),
        all{AskedPoints(pair.ball.vertices), AskedPoints(pair.socket.vertices)},
        few{few_of(pair.ball.vertices), few_of(pair.socket.vertices)} {}
};

struct Work {
  std::shared_ptr<const GapQuery> query;
  const AskedPoints& asked;
  std::string instruction_set;
  int threads;
  int poses;
};

void scan_poses(const Work& work, GapScratch& scratch) {
  for (int k = 0; k < work.poses; ++k) {
    work.query->scan(work.asked, motion_pose(k % kMotionTurns), scratch);
    benchmark::DoNotOptimize(scratch.floats.data());
    benchmark::DoNotOptimize(scratch.doubles.data());
    benchmark::ClobberMemory();
  }
}

// Each thread does all poses of its own.
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

// One pose of the motion after the other, each after what overwrites the caches.
std::function<void()> pose_after_pose(const Work& work) {
  auto scratch = std::make_shared<GapScratch>();
  auto turn = std::make_shared<int>(0);
  return [work, scratch, turn] {
    use_instruction_set(work.instruction_set);
    work.query->scan(work.asked, motion_pose((*turn)++ % kMotionTurns), *scratch);
  };
}

struct Asking {
  const FastOptions& options;
  std::vector<FastCase>& cases;
  std::vector<FastCase>& cold;
  std::map<std::string, std::string>& labels;
};

void add_cold(const Asking& asking, const std::vector<Cell>& key, const Work& work, FastErrors errors) {
  FastCase added;
  added.timed.key = key;
  added.timed.run = pose_after_pose(work);
  added.timed.units = static_cast<double>(work.asked.points.size());
  added.errors = errors;
  added.bytes = work.query->bytes;
  added.measure = work.query->measure;
  asking.cold.push_back(std::move(added));
}

void add_case(const Asking& asking, const std::vector<Cell>& key, const Work& work, FastErrors errors) {
  FastCase added;
  added.timed.key = key;
  added.timed.run = run_of(work);
  added.timed.rounds = asking.options.rounds;
  added.timed.units =
      static_cast<double>(work.threads) * work.poses * static_cast<double>(work.asked.points.size());
  added.errors = errors;
  added.bytes = work.query->bytes;
  added.measure = work.query->measure;
  asking.cases.push_back(std::move(added));
}

struct Thoroughness {
  bool sets;     // with every instruction set
  bool threads;  // with two threads, too
  bool cold;     // cold, too
};

// One method.
void add_method(const Asking& asking, const GapCase& method, const std::vector<Cell>& where, Work work,
                const FastProbes& probes, Thoroughness how) {
  work.query = std::make_shared<const GapQuery>(method.make());
  const FastErrors errors = fast_errors(*work.query, probes, method);
  const std::size_t questions = method.kernel ? kKernelQuestions : method.few ? 1 : kOtherQuestions;
  work.poses = static_cast<int>(questions / work.asked.points.size()) + 1;
  const auto key = [&](const std::string& set, int threads, const char* state) {
    std::vector<Cell> cells{method.name, method.setting, method.storage};
    cells.insert(cells.end(), where.begin(), where.end());
    cells.emplace_back(method.kernel ? Cell(set) : Cell("none"));
    cells.emplace_back(threads);
    cells.emplace_back(state);
    return cells;
  };
  for (const std::string& set : instruction_sets()) {
    work.instruction_set = set;
    work.threads = 1;
    if (set == instruction_sets().front() || how.sets) add_case(asking, key(set, 1, "warm"), work, errors);
  }
  work.instruction_set = instruction_sets().front();
  if (how.cold && !method.few) add_cold(asking, key(work.instruction_set, 1, "cold"), work, errors);
  if (!how.threads) return;
  work.threads = kThreads;
  add_case(asking, key(work.instruction_set, kThreads, "warm"), work, errors);
}

void add_scan(const Asking& asking, const FastJoint& joint, const Stage& stage, Surface scanned) {
  const bool ball = scanned == Surface::ball;
  const Surface met = other(scanned);
  const AskedSurface surface{mesh_of(stage.pair, met), facing_layer(met), scanned};
  const auto faces = static_cast<double>(surface.mesh.faces.size());
  const auto probes =
      fast_probes(surface, static_cast<std::size_t>(asking.options.ray_tests / faces), asking.options.seed);
  const std::vector<Cell> where{joint.triangles, ball ? "ball->socket" : "socket->ball"};
  const std::vector<GapCase> methods = cases_of(gaps_methods(), &Method::gaps, surface, joint.sizes);
  add_labels(asking.labels, methods);
  for (const GapCase& method : methods) {
    const AskedPoints& asked = (method.few ? stage.few : stage.all)[ball ? 0 : 1];
    add_method(asking, method, where, {nullptr, asked, "", 1, 1}, probes,
               {method.widely && joint.thorough, method.widely, joint.thorough});
  }
}

std::vector<Timing> timed_cold(const std::vector<FastCase>& cases, const FastOptions& options) {
  std::vector<ColdCase> asked;
  asked.reserve(cases.size());
  for (const FastCase& one : cases) asked.push_back({one.timed.key, one.timed.run, one.timed.units});
  ColdOptions cold;
  cold.rounds = options.rounds;
  cold.seed = options.seed;
  return time_cold(asked, cold);
}

}  // namespace

Pose motion_pose(int turn) {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(-5.0 * turn * kDegree, Vec3::UnitY()).toRotationMatrix();
  pose.translation = Vec3(0.1, -0.2, 0.05);
  return pose;
}

FastTables fast_tables(const FastOptions& options, Progress& progress) {
  FastTables tables;
  std::vector<FastCase> cases;
  std::vector<FastCase> cold;
  std::vector<std::unique_ptr<Stage>> stages;
  for (const FastJoint& joint : options.joints) {
    stages.push_back(std::make_unique<Stage>(joint.triangles));
    for (const Surface scanned : {Surface::ball, Surface::socket})
      add_scan({options, cases, cold, tables.labels}, joint, *stages.back(), scanned);
  }
  std::vector<TimedCase> timed;
  timed.reserve(cases.size());
  for (const FastCase& one : cases) timed.push_back(one.timed);
  tables.timing = run_interleaved(timed, options.timing, progress);
  std::ranges::move(timed_cold(cold, options), std::back_inserter(tables.timing.timings));
  use_best_instruction_set();
  std::ranges::move(cold, std::back_inserter(cases));
  tables.table = fast_table(cases, tables.timing);
  return tables;
}

}  // namespace impinge::lab
