// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers, directions and rotations, from a seed.
#pragma once

#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include "sphere/direction.hpp"
#include "support/random_vector.hpp"

namespace impinge::test {

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}

  double between(double from, double to) { return std::uniform_real_distribution(from, to)(engine_); }
  double power(double from, double to) { return std::pow(10.0, between(from, to)); }
  int whole(int from, int to) { return std::uniform_int_distribution(from, to)(engine_); }
  double sign() { return between(0.0, 1.0) < 0.5 ? -1.0 : 1.0; }

  // Three normal numbers: no direction is more likely than any other.
  Vec3 vector() {
    std::normal_distribution<double> normal;
    return random_vector(normal, engine_);
  }
  Vec3 direction() { return vector().normalized(); }
  // Four of them: nor is a rotation.
  Eigen::Vector4d quaternion() {
    std::normal_distribution<double> normal;
    Eigen::Vector4d q;
    for (double& x : q) x = normal(engine_);
    return q;
  }
  Eigen::Matrix3d rotation() {
    const Eigen::Vector4d q = quaternion();
    return Eigen::Quaterniond(q[3], q[2], q[1], q[0]).normalized().toRotationMatrix();
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace impinge::test
