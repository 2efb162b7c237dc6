// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and triangles for random joints.
#pragma once

#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include "mesh/triangle_mesh.hpp"

namespace impinge::test {

class RandomJoint {
 public:
  explicit RandomJoint(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double power(double low, double high) { return std::pow(10.0, between(low, high)); }
  Eigen::Matrix3d rotation() {
    std::normal_distribution<double> normal;
    return Eigen::Quaterniond(normal(random_), normal(random_), normal(random_), normal(random_))
        .normalized()
        .toRotationMatrix();
  }

 private:
  std::mt19937_64 random_;
};

inline void add(TriangleMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
  mesh.faces.push_back({first, first + 1, first + 2});
}

}  // namespace impinge::test
