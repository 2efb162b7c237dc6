// SPDX-License-Identifier: GPL-3.0-or-later
// How wrong a method is on a scene, and whether what is proven of it holds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "methods/benchmark_scene.hpp"
#include "methods/points.hpp"
#include "sphere/as_floats.hpp"

namespace impinge::lab {

// Where the errors of the methods are measured, with the truth there.

// Points in the socket's frame, mm; the first `uniform` of them lie in directions uniform on the sphere.
struct BenchmarkProbes {
  std::vector<Vec3> points;   // those in uniform directions first
  std::size_t uniform = 0;    // number of them
  std::vector<double> truth;  // mm, NaN where there is no surface; by the exact reference
  // The truth at any other point, among all triangles in double.
  std::function<double(const Vec3&)> truth_at;
  double truth_apart = 0.0;  // largest difference of the two, mm, at about a thousand of the points
  bool in_float = false;     // are all coordinates numbers in float?

  // The point, or the one in float that it is rounded to.
  Vec3 place(const Vec3& x) const { return in_float ? as_floats(x) : x; }
};

// How many probes of each kind.
struct ProbeOptions {
  std::size_t uniform = 0;       // directions
  std::size_t each_feature = 0;  // directions of each kind of feature, at most
  std::uint64_t seed = 0;        // of the uniform directions
  // mm from the centre, rounded to float, which a kernel takes as they are: where a surface jumps, a point
  // that float moves over the jump has another radius, by no fault of a method. 0: unit vectors in double.
  double float_at = 0.0;
};

// Directions where a table or a ray may fail: through vertices, points of edges, close to the poles, on and
// beside the seam theta = 0, on either side of the rim, and in the middle of the faces seen most obliquely.
// Of each kind as many as asked for, spread evenly over those there are. mesh in the centre frame.
std::vector<Vec3> stratified_directions(const TriangleMesh& mesh, std::size_t each);

// The truth is the crossing of the ray that counts, see reference/exact_radius.hpp; points are unit vectors,
// or as options.float_at has them. The mesh outlives the probes.
BenchmarkProbes radial_probes(const TriangleMesh& mesh, Layer layer, const ProbeOptions& options);
BenchmarkProbes radial_probes(const BenchmarkScene& scene, const ProbeOptions& options);

// The truth is the least distance from any triangle, see reference/closest_point.hpp. Points are as far from
// the centre as the ball is in the mean, or as far as is said (mm), along the same directions.
BenchmarkProbes euclidean_probes(const TriangleMesh& mesh, double radius, const ProbeOptions& options);
BenchmarkProbes euclidean_probes(const BenchmarkScene& scene, const ProbeOptions& options);

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
