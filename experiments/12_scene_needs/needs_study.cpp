// SPDX-License-Identifier: GPL-3.0-or-later
#include "12_scene_needs/needs_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <benchmark/benchmark.h>

#include "gap/gap_scan.hpp"
#include "harness/answer_difference.hpp"
#include "methods/heap_use.hpp"
#include "methods/local_refill.hpp"
#include "motion/euclidean_distance.hpp"
#include "session/certificate.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/error_bound.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

// Those of the plan's omissions that can matter to the scene.
std::vector<Omission> omissions_of(const SceneNeeds& needs) {
  if (needs.accuracy_mm) return {Omission::fine_table};
  std::vector<Omission> found{Omission::vertices, Omission::entries};
  if (needs.question != Question::all_gaps) found.push_back(Omission::second_scan);
  return found;
}

// The exact gaps of every vertex in one pose, by every ray against every face.
PoseGaps gaps_by_exact_faces(const BallSocketPair& joint, const Pose& pose) {
  const RayCaster socket(joint.socket);
  const RayCaster ball(joint.ball);
  PoseGaps gaps;
  for (const Vec3& v : joint.ball.vertices) {
    const Vec3 x = to_socket(pose, v);
    gaps.ball.push_back(socket.cast(x.normalized(), Layer::nearest) - x.norm());
  }
  for (const Vec3& v : joint.socket.vertices) {
    const Vec3 x = to_ball(pose, v);
    gaps.socket.push_back(x.norm() - ball.cast(x.normalized(), Layer::farthest));
  }
  return gaps;
}

// Of the poses that are compared with exact gaps.
constexpr std::size_t kEveryPose = 30;
std::vector<PoseGaps> truth_of(const NeedsScene& scene) {
  std::vector<PoseGaps> truth;
  for (std::size_t p = 0; p < scene.needs.poses.size(); p += kEveryPose)
    truth.push_back(gaps_by_exact_faces(*scene.joint, scene.needs.poses[p]));
  return truth;
}

double difference_from(const std::vector<PoseGaps>& truth, const SceneAnswer& answer) {
  double largest = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k)
    largest = std::max(largest, gap_difference(truth[k], answer.gaps[k * kEveryPose]));
  return largest;
}

NeedsCase case_of(const NeedsScene& scene, const NeedsOptions& options, std::string left_out,
                  Omissions omissions) {
  NeedsCase made;
  made.scene = scene.name;
  made.left_out = std::move(left_out);
  made.run = [scene, omissions, given = AnyScheme(Rsid::name, options.precision_deg)] {
    const SceneAnswer answer = answer_scene(*scene.joint, scene.needs, given, omissions);
    benchmark::DoNotOptimize(answer.cost.look_ups);
  };
  return made;
}

SceneAnswer answer_of(const NeedsScene& scene, const NeedsOptions& options, Omissions omissions) {
  return answer_scene(*scene.joint, scene.needs, AnyScheme(Rsid::name, options.precision_deg), omissions);
}

std::string name_of(Omission omission) {
  return std::string(kOmissions[static_cast<std::size_t>(omission)].name);
}

// One of the outputs: it makes something, which is kept while its memory is counted.
template <class Make>
NeedsCase output_case(const NeedsScene& scene, Omission omission, const Make& make) {
  NeedsCase made;
  made.scene = scene.name;
  made.left_out = name_of(omission);
  const double before = heap_bytes();
  {
    const auto product = make();
    made.bytes = heap_bytes() - before;
    benchmark::DoNotOptimize(&product);
  }
  made.run = [make] {
    const auto product = make();
    benchmark::DoNotOptimize(&product);
  };
  return made;
}

struct Bounds {
  std::vector<float> slopes;
  std::vector<double> of_vertices;
};

Bounds bounds_against(const RadialTable<Rsid>& table, const TriangleMesh& asked, const TriangleMesh& scanned,
                      const Pose& pose, Surface of) {
  Bounds bounds{largest_slopes(asked, table.scheme()), {}};
  for (const Vec3& v : scanned.vertices)
    bounds.of_vertices.push_back(error_bound_at(table, bounds.slopes, to_other(of, pose, v)));
  return bounds;
}

// Changes the vertices within 10 degrees of a direction.
TriangleMesh pushed(TriangleMesh mesh, const Vec3& direction) {
  constexpr double kWidth = 10.0 * kDegree;
  constexpr double kDepth = 0.5;  // mm
  for (Vec3& v : mesh.vertices) {
    const double off = angle_between(v, direction) / kWidth;
    if (off < 1.0) v *= 1.0 - kDepth * (1.0 - off * off) / v.norm();
  }
  return mesh;
}

bool same_table(const RadialTable<Rsid>& a, const RadialTable<Rsid>& b) {
  const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  bool rims = true;
  for (std::size_t c = 0; c < a.scheme().cells(); ++c) rims = rims && a.is_rim_cell(c) == b.is_rim_cell(c);
  return rims && std::ranges::equal(a.radii(), b.radii(), same);
}

}  // namespace

std::vector<NeedsCase> cases_of(const NeedsScene& scene, const NeedsOptions& options) {
  std::vector<NeedsCase> cases;
  const SceneAnswer everything = answer_of(scene, options, Omissions::none());
  const std::vector<PoseGaps> truth = scene.needs.accuracy_mm ? truth_of(scene) : std::vector<PoseGaps>();
  const auto add = [&](std::string name, Omissions omissions) {
    NeedsCase made = case_of(scene, options, std::move(name), omissions);
    const SceneAnswer answer = answer_of(scene, options, omissions);
    made.bytes = static_cast<double>(answer.cost.bytes);
    if (scene.needs.accuracy_mm && omissions.has(Omission::fine_table)) {
      made.difference_mm = difference_from(truth, answer);
      made.identical = made.difference_mm <= *scene.needs.accuracy_mm;
    } else {
      made.difference_mm = answer_difference(answer, everything);
      made.identical = same_answer(answer, everything);
    }
    cases.push_back(std::move(made));
  };
  add("nothing", Omissions::none());
  for (const Omission omission : omissions_of(scene.needs))
    add(name_of(omission), Omissions::none().with(omission));
  add("all", Omissions::all());
  return cases;
}

std::vector<NeedsCase> outputs_of(const NeedsScene& scene, const NeedsOptions& options) {
  const Pose pose = scene.needs.poses.front();
  const auto joint = scene.joint;
  const Rsid scheme = Rsid::with_precision(options.precision_deg);
  struct Tables {
    RadialTable<Rsid> ball;
    RadialTable<Rsid> socket;
  };
  const auto tables = std::make_shared<const Tables>(Tables{
      fill_exact(joint->ball, scheme, Layer::farthest), fill_exact(joint->socket, scheme, Layer::nearest)});
  std::vector<NeedsCase> cases;
  const auto bounds = [=] {
    return std::array{bounds_against(tables->socket, joint->socket, joint->ball, pose, Surface::ball),
                      bounds_against(tables->ball, joint->ball, joint->socket, pose, Surface::socket)};
  };
  cases.push_back(output_case(scene, Omission::error_bounds, bounds));
  const auto distances = [=] {
    auto ball = std::make_unique<EuclideanDistance>(joint->ball);
    auto socket = std::make_unique<EuclideanDistance>(joint->socket);
    std::vector<DistanceBracket> found;
    for (const Vec3& v : joint->ball.vertices) found.push_back(socket->at(to_socket(pose, v)));
    for (const Vec3& v : joint->socket.vertices) found.push_back(ball->at(to_ball(pose, v)));
    return std::tuple(std::move(ball), std::move(socket), std::move(found));
  };
  cases.push_back(output_case(scene, Omission::distances, distances));
  std::vector<double> ball_gap(joint->ball.vertices.size());
  std::vector<double> socket_gap(joint->socket.vertices.size());
  scan_gaps(tables->socket, joint->ball.vertices, pose, Surface::ball, ball_gap);
  scan_gaps(tables->ball, joint->socket.vertices, pose, Surface::socket, socket_gap);
  auto found = bounds();
  const auto verdicts = [=, ball_bound = std::move(found[0].of_vertices),
                         socket_bound = std::move(found[1].of_vertices)] {
    auto overlay = std::make_unique<SurfaceOverlay>(joint->ball, joint->socket);
    const Certificate certificate =
        certify(*overlay, pose, {ball_gap, ball_bound}, {socket_gap, socket_bound});
    return std::pair(std::move(overlay), certificate);
  };
  cases.push_back(output_case(scene, Omission::exact_verdicts, verdicts));
  return cases;
}

std::vector<NeedsCase> local_change_of(const std::string& name, const BallSocketPair& joint,
                                       const NeedsOptions& options) {
  const Rsid scheme = Rsid::with_precision(options.precision_deg);
  struct State {
    TriangleMesh now;
    TriangleMesh next;
    RadialTable<Rsid> table;
  };
  const TriangleMesh after = pushed(joint.ball, joint.ball.vertices.front().normalized());
  const auto state =
      std::make_shared<State>(State{joint.ball, after, fill_exact(joint.ball, scheme, Layer::farthest)});
  NeedsCase anew;
  anew.scene = name + " local change";
  anew.left_out = "nothing";
  anew.bytes = static_cast<double>(RadialTable<Rsid>::bytes(scheme));
  anew.run = [after, scheme] {
    const RadialTable<Rsid> table = fill_exact(after, scheme, Layer::farthest);
    benchmark::DoNotOptimize(table.radii().data());
  };
  NeedsCase local = anew;
  local.left_out = "all";
  refill(state->now, state->next, Layer::farthest, state->table);
  std::swap(state->now, state->next);
  local.identical = same_table(state->table, fill_exact(after, scheme, Layer::farthest));
  local.run = [state] {
    refill(state->now, state->next, Layer::farthest, state->table);
    std::swap(state->now, state->next);
  };
  return {anew, local};
}

}  // namespace impinge::lab
