// SPDX-License-Identifier: GPL-3.0-or-later
// Where the errors of the methods are measured, with the truth there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "methods/benchmark_scene.hpp"
#include "sphere/as_floats.hpp"

namespace impinge::lab {

// Points in the socket's frame, mm; the first `uniform` of them lie in directions uniform on the sphere.
struct BenchmarkProbes {
  std::vector<Vec3> points;   // those in uniform directions first
  std::size_t uniform = 0;    // number of them
  std::vector<double> truth;  // mm, NaN where there is no surface; by the exact reference
  // The truth at any other point, among all triangles in double.
  std::function<double(const Vec3&)> truth_at;
  bool in_float = false;  // are all coordinates numbers in float?

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

}  // namespace impinge::lab
