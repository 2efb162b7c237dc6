// SPDX-License-Identifier: GPL-3.0-or-later
// How wrong a method is on a scene, and whether what is proven of it holds.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

#include "10_error_against_time/probes.hpp"
#include "methods/points.hpp"

namespace impinge::lab {

// Millimetres. Errors are answer minus truth wherever both are there; the rest is counted.
struct BenchmarkErrors {
  double max_over = 0.0;   // answer above the truth, at most
  double max_under = 0.0;  // below it
  // Over the uniform probes, so that every part of the surface counts by its solid angle.
  double rms = 0.0;
  double p99 = 0.0;              // 99th percentile of the errors' size
  double uniform_max = 0.0;      // largest of the uniform probes
  double feature_max = 0.0;      // over the other probes
  double adversarial_max = 0.0;  // over those of the ascent
  std::size_t misses = 0;        // no answer where there is a surface
  std::size_t false_hits = 0;    // an answer where there is none
  std::size_t directions = 0;    // examined in all
  Vec3 worst = Vec3::Zero();     // the point of the largest error

  double max() const { return std::max(max_over, max_under); }  // largest in size
};

// Local ascent on |error| from the worst probes: steps along the sphere in four directions, each halved until
// the error no longer grows.
struct AscentOptions {
  std::size_t starts = 8;             // probes that it begins at
  std::size_t steps = 40;             // questions for each start, at most
  double first_step = 0.3 * kDegree;  // radians
};

BenchmarkErrors measure_errors(const PointQuery& query, const BenchmarkProbes& probes,
                               const AscentOptions& ascent);

// An error above its bound. Truth and look-ups are worked out in double: that much is let pass.
inline constexpr double kBenchmarkRounding = 1e-10;  // mm
// The point at which a bound does not hold, to look into.
struct Violation {
  std::string scene;          // its name
  std::string method;         // its name
  std::string setting;        // such as "1deg float"
  double error_mm = 0.0;      // measured
  double bound_mm = 0.0;      // proven
  Vec3 point = Vec3::Zero();  // mm, in the socket's frame

  // One line of JSON; the point in hexadecimal, digit for digit.
  std::string text() const;
};
// Without the names, which the caller knows. None where no bound is given.
std::optional<Violation> find_violation(const BenchmarkErrors& errors, const MethodBound& bound);

// A bound that does not hold: nothing that was measured can be trusted until that is resolved.
class BoundViolated : public std::runtime_error {
 public:
  explicit BoundViolated(const Violation& violation);        // what() gives its text()
  const Violation& violation() const { return violation_; }  // the one that ended the benchmark

 private:
  Violation violation_;
};

// What a result calls a setting of a method.
struct CaseName {
  std::string scene;
  std::string method;
  std::string setting;
};
// Throws BoundViolated where the errors are above the bound.
void require_bound(const BenchmarkErrors& errors, const MethodBound& bound, const CaseName& name);

}  // namespace impinge::lab
