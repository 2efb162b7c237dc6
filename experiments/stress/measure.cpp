// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/measure.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <map>
#include <memory>

#include <Eigen/Geometry>

#include "mesh/jump_edges.hpp"
#include "reference/exact_radius.hpp"
#include "stress/methods.hpp"
#include "stress/working_tables.hpp"

namespace impinge::lab {
namespace {

constexpr double kMicrometres = 1000.0;  // in a millimetre

void raise(double& largest, double value) {
  if (!(value <= largest)) largest = value;  // also replaces a NaN
}

// Least angle between a direction and the arc of a great circle between two directions.
double angle_to_arc(const Vec3& u, const Vec3& from, const Vec3& to) {
  const Vec3 across = from.cross(to).stableNormalized();
  const bool beside = across.cross(from).dot(u) >= 0.0 && across.cross(to).dot(u) <= 0.0;
  const double to_ends = std::min(angle_between(u, from), angle_between(u, to));
  return beside ? std::min(to_ends, std::abs(std::asin(std::clamp(across.dot(u), -1.0, 1.0)))) : to_ends;
}

// May a table have no answer here? Yes if the surface ends or jumps within its reach of an entry that it
// reads; the direction is within its reach, too.
bool is_near_rim(const TriangleMesh& mesh, const std::vector<JumpEdge>& rim, const Vec3& x, double reach) {
  const Vec3 u = x.stableNormalized();
  return std::ranges::any_of(rim, [&](const JumpEdge& edge) {
    return angle_to_arc(u, mesh.vertices[edge.from], mesh.vertices[edge.to]) <= 2.0 * reach * (1.0 + 1e-9);
  });
}

bool is_length(double radius) { return radius > 0.0 && std::isfinite(radius); }

// What the methods of one scene share.
struct Shared {
  const StabilityScene& scene;
  RadiusQuestions along;
  std::vector<JumpEdge> rim;
  std::map<std::string, std::pair<std::vector<Vec3>, RadiusQuestions>> entries;  // by scheme

  const RadiusQuestions& at_entries(const std::string& scheme, std::vector<Vec3> directions) {
    auto& [kept, questions] = entries[scheme];
    if (kept.empty()) {
      kept = std::move(directions);
      questions = ask(scene.mesh, kept);
    }
    return questions;
  }
};

// Keeps the look-up that is nearest to its bound.
void judge_bound(StabilityCase& result, double error_mm, double bound_mm) {
  if (std::isinf(bound_mm)) ++result.unbounded;
  const double share = bound_mm > 0.0 ? error_mm / bound_mm : error_mm > 0.0 ? HUGE_VAL : 0.0;
  const bool first = std::isnan(result.error_um);
  if (!first && std::isinf(bound_mm)) return;
  if (!first && !std::isinf(result.bound_um) && share <= result.error_um / result.bound_um) return;
  result.error_um = kMicrometres * error_mm;
  result.bound_um = kMicrometres * bound_mm;
}

// Look-ups between entries, with the bound of each; `reach` is the table's, radians.
void judge_look_ups(StabilityCase& result, const Shared& shared, double reach,
                    std::span<const double> answers, std::span<const double> bounds) {
  const auto& [directions, truth, condition] = shared.along;
  result.questions += answers.size();
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const bool there = !std::isnan(truth[i]);
    if (std::isnan(answers[i])) {
      if (!there) continue;
      const bool documented = is_near_rim(shared.scene.mesh, shared.rim, directions[i], reach);
      ++(documented ? result.withheld : result.missed_hits);
    } else if (!is_length(answers[i])) {
      ++result.nan;
    } else if (!there) {
      ++result.false_hits;
    } else {
      judge_bound(result, std::abs(answers[i] - truth[i]), bounds[i]);
      raise(result.condition, condition[i].condition());
    }
  }
}

void judge_twins(StabilityCase& result, const StabilityScene& scene, std::span<const double> answers) {
  for (const auto& [i, j] : scene.twins) {
    if (std::isnan(answers[i]) && std::isnan(answers[j])) continue;
    if (std::bit_cast<std::uint64_t>(answers[i]) != std::bit_cast<std::uint64_t>(answers[j])) ++result.wrong;
  }
}

StabilityCase blank(const StabilityMethod& method, double magnitude, double threshold) {
  StabilityCase result;
  result.magnitude = magnitude;
  result.method = method.maker.name;
  result.kind = method.maker.kind;
  result.scalar = method.scalar;
  if (method.maker.precision_deg > 0.0) result.precision_deg = method.maker.precision_deg;
  const bool stored_in_float = method.maker.kind == "ours" && method.scalar == Scalar::float32;
  result.threshold = stored_in_float ? kStoredThreshold : threshold;
  result.refused = method.refused;
  return result;
}

StabilityCase measure_one(Shared& shared, const StabilityMethod& method, StabilityCase result) {
  if (!result.refused.empty()) return result;
  const PointQuery answering = method.maker.make();
  std::vector<double> answers(shared.along.directions.size());
  answering.answer(shared.along.directions, answers);
  if (!answering.stored) {
    judge(result, shared.along, answers);
  } else {
    const StoredRadii table = answering.stored();
    judge(result, shared.at_entries(method.maker.scheme, table.directions), table.radii);
    const double bound = method.maker.bound(answering).bound_mm;
    judge_look_ups(result, shared, table.reach, answers, std::vector(answers.size(), bound));
    if (std::isnan(result.error_um)) result.bound_um = kMicrometres * bound;
  }
  judge_twins(result, shared.scene, answers);
  return result;
}

// Adds tables at working precisions.
void add_working(std::vector<StabilityCase>& cases, const Shared& shared, double magnitude) {
  for (const WorkingTable& table : working_tables(shared.scene.mesh, shared.along.directions)) {
    StabilityCase result;
    result.magnitude = magnitude;
    result.method = table.name;
    result.kind = "ours";
    result.precision_deg = table.precision_deg;
    result.threshold = kRadiusThreshold;
    judge_look_ups(result, shared, table.reach, table.answers, table.bounds);
    judge_twins(result, shared.scene, table.answers);
    cases.push_back(result);
  }
}

using Long = long double;
using LongVec = Eigen::Matrix<Long, 3, 1>;

constexpr Long kSamePlace = 1e-4L;  // share of the radius up to which faces meet at an edge or vertex

double finite(Long value) {
  const auto rounded = static_cast<double>(value);
  return std::isfinite(rounded) ? rounded : std::numeric_limits<double>::max();
}

struct LongPlane {
  explicit LongPlane(const TriangleCone& cone) {
    const LongVec a = cone.corners()[0].cast<Long>();
    const LongVec b = cone.corners()[1].cast<Long>();
    const LongVec c = cone.corners()[2].cast<Long>();
    normal = (b - a).cross(c - a);
    offset = std::abs(normal.dot(a));
  }
  Long radius(const LongVec& u) const { return offset / std::abs(normal.dot(u)); }
  double slope(const LongVec& u) const { return finite(normal.cross(u).norm() / std::abs(normal.dot(u))); }

  LongVec normal;
  Long offset = 0.0L;
};

}  // namespace

MeasureOptions measure_options(const StabilityRun& run) {
  MeasureOptions options;
  options.search.budget = run.quick ? 0 : 2000;
  return options;
}

RadiusQuestions ask(const TriangleMesh& mesh, std::span<const Vec3> directions) {
  return {directions, exact_radii(mesh, {directions, BenchmarkScene::kLayer, {}}),
          conditions_along(mesh, directions)};
}

void judge(StabilityCase& result, const RadiusQuestions& questions, std::span<const double> answers) {
  const double u = unit_roundoff(result.scalar);
  result.questions += answers.size();
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const double truth = questions.truth[i];
    if (std::isnan(answers[i])) {
      result.missed_hits += std::isnan(truth) ? 0U : 1U;
      continue;
    }
    if (!is_length(answers[i])) {
      ++result.nan;
      continue;
    }
    if (std::isnan(truth)) {
      ++result.false_hits;
      continue;
    }
    const double condition = questions.condition[i].condition();
    const double slope = questions.condition[i].slope;
    const double error = std::abs(answers[i] - truth) / truth;
    const double share = error / condition / u;
    raise(result.condition, condition);
    raise(result.relative_error, error);
    raise(result.error_over_condition_u, share);
    if (slope >= 1.0) raise(result.backward_error_over_u, error / slope / u);
    if (share > result.threshold) ++result.wrong;
  }
}

namespace {

std::vector<StabilityCase> measured(const StabilityScene& scene, double magnitude,
                                    const MeasureOptions& options, std::span<const StabilityMethod> methods,
                                    bool working) {
  Shared shared{scene, ask(scene.mesh, scene.directions), jump_edges(scene.mesh), {}};
  const double stiff = stiffness(scene.mesh);
  std::vector<StabilityCase> cases;
  for (const StabilityMethod& method : methods) {
    cases.push_back(measure_one(shared, method, blank(method, magnitude, options.threshold)));
  }
  if (working) add_working(cases, shared, magnitude);
  for (StabilityCase& one : cases) one.stiffness = stiff;
  return cases;
}

}  // namespace

std::vector<StabilityCase> measure(const StabilityScene& scene, double magnitude,
                                   const MeasureOptions& options, std::span<const StabilityMethod> methods) {
  return measured(scene, magnitude, options, methods, false);
}

std::vector<StabilityCase> measure(const StabilityScene& scene, double magnitude,
                                   const MeasureOptions& options) {
  std::vector<StabilityMethod> methods = stability_methods(scene, options.search);
  if (options.flaw) {
    if (auto wrong = wrong_on_purpose(scene.mesh, *options.flaw, methods)) methods.push_back(*wrong);
  }
  return measured(scene, magnitude, options, methods, true);
}

std::vector<StabilityCase> sweep(std::span<const double> magnitudes, const ScenesAt& scenes_at,
                                 const StabilityRun& run, std::optional<Flaw> flaw) {
  MeasureOptions options = measure_options(run);
  options.flaw = flaw;
  std::vector<StabilityCase> all;
  for (const double magnitude : magnitudes) {
    std::vector<StabilityCase> cases;
    for (const StabilityScene& scene : scenes_at(magnitude)) {
      auto more = measure(scene, magnitude, options);
      cases = cases.empty() ? std::move(more) : worse_of(std::move(cases), more);
    }
    all.insert(all.end(), cases.begin(), cases.end());
  }
  return all;
}

std::vector<RayCondition> conditions_along(const TriangleMesh& mesh, std::span<const Vec3> directions) {
  std::vector<TriangleCone> cones;
  std::vector<LongPlane> planes;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    cones.push_back(cone);
    planes.emplace_back(cone);
  }
  std::vector<RayCondition> found;
  std::vector<std::size_t> met;
  for (const Vec3& direction : directions) {
    const Vec3 unit = direction.stableNormalized();
    const LongVec u = direction.cast<Long>().normalized();
    met.clear();
    Long nearest = std::numeric_limits<Long>::infinity();
    for (std::size_t f = 0; f < cones.size(); ++f) {
      if (!is_met(cones[f], direction, unit)) continue;
      met.push_back(f);
      nearest = std::min(nearest, planes[f].radius(u));
    }
    RayCondition here;
    for (const std::size_t f : met) {
      if (planes[f].radius(u) > nearest * (1.0L + kSamePlace)) continue;
      here.slope = std::max(here.slope, planes[f].slope(u));
    }
    found.push_back(here);
  }
  return found;
}

double stiffness(const TriangleMesh& mesh) {
  std::vector<double> slopes;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    const auto& [a, b, c] = cone.corners();
    slopes.push_back(LongPlane(cone).slope((a + b + c).cast<Long>().normalized()));
  }
  if (slopes.empty()) return 0.0;
  const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::ranges::nth_element(slopes, middle);
  const double median = *middle;
  return *std::ranges::max_element(slopes) / std::max(median, 1e-16);
}

}  // namespace impinge::lab
