// SPDX-License-Identifier: GPL-3.0-or-later
// Directions to test with: random ones from a seed, and those through the features of a mesh.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "support/random_vector.hpp"

namespace impinge::test {

// Uniform on the sphere.
inline std::vector<Vec3> random_directions(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Vec3> directions;
  while (directions.size() < count) {
    const Vec3 x = random_vector(normal, random);
    if (x.norm() > 1e-3) directions.push_back(x.normalized());
  }
  return directions;
}

// The poles, the axes, and points on and one ulp beside the seam theta = 0.
inline std::vector<Vec3> special_directions() {
  const double tiny = std::numeric_limits<double>::denorm_min();
  return {{0, 0, 1},     {0, 0, -1},      {1, 0, 0},        {-1, 0, 0},
          {0, 1, 0},     {0, -1, 0},      {1, -0.0, 0},     {1, tiny, 0},
          {1, -tiny, 0}, {1e-16, 0, 1},   {0, 1e-300, 1},   {-1e-16, 1e-16, -1},
          {1, 0, 1e-16}, {1, 1e-16, 0.5}, {1, -1e-16, 0.5}, {-1e-16, -1, 0.3}};
}

// Unit vectors through every vertex and through points of every edge of a mesh in the centre frame.
inline std::vector<Vec3> feature_directions(const TriangleMesh& mesh) {
  std::vector<Vec3> directions;
  for (const Vec3& v : mesh.vertices) directions.push_back(v.normalized());
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = corner(mesh, face, k);
      const Vec3& b = corner(mesh, face, (k + 1) % 3);
      for (const double t : {0.5, 1.0 / 3.0, 1e-12}) directions.push_back((a + t * (b - a)).normalized());
    }
  }
  return directions;
}

}  // namespace impinge::test
