// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "harness/statistics.hpp"

namespace impinge::lab {
namespace {

double error_at(const PointQuery& query, const BenchmarkProbes& probes, const Vec3& x) {
  double answer = 0.0;
  query.answer(std::span(&x, 1), std::span(&answer, 1));
  return answer - probes.truth_at(x);
}

void take(BenchmarkErrors& errors, double error, const Vec3& x) {
  if (std::isnan(error)) return;
  if (std::abs(error) > errors.max()) errors.worst = x;
  errors.max_over = std::max(errors.max_over, error);
  errors.max_under = std::max(errors.max_under, -error);
}

// Largest |error| that a start leads to, as far from the centre as the start.
double climb(const PointQuery& query, const BenchmarkProbes& probes, const AscentOptions& ascent, Vec3 x,
             BenchmarkErrors& errors) {
  double best = std::abs(error_at(query, probes, x));
  double step = ascent.first_step;
  std::size_t asked = 0;
  while (asked < ascent.steps) {
    const Vec3 across = x.unitOrthogonal();
    const Vec3 along = x.normalized().cross(across);
    bool better = false;
    for (const auto& [a, b] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}}) {
      const Vec3 next =
          probes.place(x.norm() * (x.normalized() + step * (a * across + b * along)).normalized());
      const double error = error_at(query, probes, next);
      ++asked;
      take(errors, error, next);
      if (!(std::abs(error) > best)) continue;
      best = std::abs(error);
      x = next;
      better = true;
      break;
    }
    if (!better) step *= 0.5;
  }
  errors.directions += asked;
  return best;
}

// Places of the probes with the largest errors, the worst first.
std::vector<std::size_t> worst_places(const std::vector<double>& error, std::size_t count) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < error.size(); ++k) {
    if (!std::isnan(error[k])) places.push_back(k);
  }
  count = std::min(count, places.size());
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(count);
  std::ranges::partial_sort(places, middle, [&](std::size_t i, std::size_t j) {
    return std::pair(-std::abs(error[i]), i) < std::pair(-std::abs(error[j]), j);
  });
  places.resize(count);
  return places;
}

void summarise_uniform(BenchmarkErrors& errors, std::span<const double> error) {
  std::vector<double> sizes;
  double squares = 0.0;
  for (const double e : error) {
    if (std::isnan(e)) continue;
    sizes.push_back(std::abs(e));
    squares += e * e;
  }
  if (sizes.empty()) return;
  errors.rms = std::sqrt(squares / static_cast<double>(sizes.size()));
  errors.p99 = quantile(sizes, 0.99);
  errors.uniform_max = std::ranges::max(sizes);
}

}  // namespace

BenchmarkErrors measure_errors(const PointQuery& query, const BenchmarkProbes& probes,
                               const AscentOptions& ascent) {
  BenchmarkErrors errors;
  errors.directions = probes.points.size();
  std::vector<double> error(probes.points.size());
  query.answer(probes.points, error);
  for (std::size_t k = 0; k < error.size(); ++k) {
    const bool answered = !std::isnan(error[k]);
    const bool there = !std::isnan(probes.truth[k]);
    errors.misses += there && !answered ? 1 : 0;
    errors.false_hits += answered && !there ? 1 : 0;
    error[k] -= probes.truth[k];
    take(errors, error[k], probes.points[k]);
    if (k >= probes.uniform && !std::isnan(error[k]))
      errors.feature_max = std::max(errors.feature_max, std::abs(error[k]));
  }
  summarise_uniform(errors, std::span(error).first(probes.uniform));
  for (const std::size_t place : worst_places(error, ascent.starts)) {
    const double found = climb(query, probes, ascent, probes.points[place], errors);
    errors.adversarial_max = std::max(errors.adversarial_max, found);
  }
  return errors;
}

std::string Violation::text() const {
  const auto hex = [](double x) {
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%a", x);
    return std::string(buffer.data());
  };
  const nlohmann::json line{{"scene", scene},
                            {"method", method},
                            {"setting", setting},
                            {"error_um", 1000.0 * error_mm},
                            {"bound_um", 1000.0 * bound_mm},
                            {"point_mm", {hex(point.x()), hex(point.y()), hex(point.z())}}};
  return line.dump();
}

std::optional<Violation> find_violation(const BenchmarkErrors& errors, const MethodBound& bound) {
  const double largest = errors.max();
  if (!(largest > bound.bound_mm + kBenchmarkRounding)) return std::nullopt;  // a NaN promises nothing
  Violation violation;
  violation.error_mm = largest;
  violation.bound_mm = bound.bound_mm;
  violation.point = errors.worst;
  return violation;
}

BoundViolated::BoundViolated(const Violation& violation)
    : std::runtime_error("a proven bound does not hold, so the proof or the program is wrong: " +
                         violation.text()),
      violation_(violation) {}

void require_bound(const BenchmarkErrors& errors, const MethodBound& bound, const CaseName& name) {
  auto violation = find_violation(errors, bound);
  if (!violation) return;
  violation->scene = name.scene;
  violation->method = name.method;
  violation->setting = name.setting;
  throw BoundViolated(*violation);
}

}  // namespace impinge::lab
