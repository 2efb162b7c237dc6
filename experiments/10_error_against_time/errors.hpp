// SPDX-License-Identifier: GPL-3.0-or-later
// How wrong a method is on a scene, and whether the proven bound holds.
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

// The points at which errors are measured, with the truth.

// Points in the socket's frame, mm; the directions of the first `uniform` are uniform on the sphere.
struct BenchmarkProbes {
  std::vector<Vec3> points;   // those in uniform directions first
  std::size_t uniform = 0;    // number of these
  std::vector<double> truth;  // mm, NaN where there is no surface; by the exact reference
  // The truth at any other point, from all triangles in double.
  std::function<double(const Vec3&)> truth_at;
  double truth_apart = 0.0;  // largest difference between the two truths, mm, at about a thousand points
  bool in_float = false;     // are all coordinates numbers in float?

  // The point, rounded to float if in_float.
  Vec3 place(const Vec3& x) const { return in_float ? as_floats(x) : x; }
};

// How many probes of each kind.
struct ProbeOptions {
  std::size_t uniform = 0;       // uniform directions
  std::size_t each_feature = 0;  // directions of each kind of feature, at most
  std::uint64_t seed = 0;        // of the uniform directions
  // Distance of the probes from the centre, mm; 0 means unit vectors in double. The points are rounded to
  // float, so a kernel takes them as they are. Otherwise rounding could move a point across a jump of the
  // surface, which is no fault of a method.
  double float_at = 0.0;
};

// Directions where a table or a ray may fail: through vertices, points of edges, close to the poles, on and
// beside the seam theta = 0, on either side of the rim, and in the middle of the faces seen most obliquely.
// Each kind has `each` directions, spread evenly over all there are. `mesh` is in the centre frame.
std::vector<Vec3> stratified_directions(const TriangleMesh& mesh, std::size_t each);

// Probes whose truth is the crossing of the ray on the layer that counts (reference/exact_radius.hpp). Points
// are unit vectors, or as options.float_at says. The mesh must outlive the probes.
BenchmarkProbes radial_probes(const TriangleMesh& mesh, Layer layer, const ProbeOptions& options);
BenchmarkProbes radial_probes(const BenchmarkScene& scene, const ProbeOptions& options);

// Probes whose truth is the least distance from any triangle (reference/closest_point.hpp). Points lie along
// the same directions, `radius` mm from the centre or as far as options.float_at says.
BenchmarkProbes euclidean_probes(const TriangleMesh& mesh, double radius, const ProbeOptions& options);
BenchmarkProbes euclidean_probes(const BenchmarkScene& scene, const ProbeOptions& options);

// In mm. An error is answer minus truth where both exist; other cases are counted.
struct BenchmarkErrors {
  double max_over = 0.0;   // largest error of an answer above the truth
  double max_under = 0.0;  // largest error of an answer below the truth
  // Over the uniform probes, so that every part of the surface counts by its solid angle.
  double rms = 0.0;
  double p99 = 0.0;              // 99th percentile of the absolute errors
  double uniform_max = 0.0;      // largest of the uniform probes
  double feature_max = 0.0;      // over the other probes
  double adversarial_max = 0.0;  // over the probes of the ascent
  std::size_t misses = 0;        // no answer where there is a surface
  std::size_t false_hits = 0;    // an answer where there is none
  std::size_t directions = 0;    // examined in all
  Vec3 worst = Vec3::Zero();     // the point of the largest error

  double max() const { return std::max(max_over, max_under); }  // largest absolute error
};

// Local ascent on |error| from the worst probes. It steps along the sphere in four directions, and halves
// each step until the error no longer grows.
struct AscentOptions {
  std::size_t starts = 8;             // probes that it begins at
  std::size_t steps = 40;             // questions per start, at most
  double first_step = 0.3 * kDegree;  // radians
};

BenchmarkErrors measure_errors(const PointQuery& query, const BenchmarkProbes& probes,
                               const AscentOptions& ascent);

// Slack of an error above its bound, since truth and look-ups are computed in double.
inline constexpr double kBenchmarkRounding = 1e-10;  // mm
// An error above its bound, with its point for a closer look.
struct Violation {
  std::string scene;          // its name
  std::string method;         // its name
  std::string setting;        // such as "1deg float"
  double error_mm = 0.0;      // measured
  double bound_mm = 0.0;      // proven
  Vec3 point = Vec3::Zero();  // mm, in the socket's frame

  // One line of JSON; the point is in hexadecimal, so no digit is lost.
  std::string text() const;
};
// The violation without the names, which the caller knows. None if the bound holds or there is none.
std::optional<Violation> find_violation(const BenchmarkErrors& errors, const MethodBound& bound);

// A bound does not hold. No measurement can be trusted until this is resolved.
class BoundViolated : public std::runtime_error {
 public:
  explicit BoundViolated(const Violation& violation);        // what() is its text()
  const Violation& violation() const { return violation_; }  // the one that ended the benchmark

 private:
  Violation violation_;
};

// The name of a method's setting in a result.
struct CaseName {
  std::string scene;
  std::string method;
  std::string setting;
};
// Throws BoundViolated if the errors are above the bound.
void require_bound(const BenchmarkErrors& errors, const MethodBound& bound, const CaseName& name);

}  // namespace impinge::lab
