// SPDX-License-Identifier: GPL-3.0-or-later
// Random directions and sizes, from a seed.
#pragma once

#include <cmath>
#include <random>

#include "sphere/direction.hpp"

namespace impinge::test {

class Dice {
 public:
  Vec3 direction() {
    std::normal_distribution<double> normal;
    return Vec3(normal(engine_), normal(engine_), normal(engine_)).normalized();
  }
  double power(double from, double to) {
    return std::pow(10.0, std::uniform_real_distribution<double>(from, to)(engine_));
  }

 private:
  std::mt19937_64 engine_{19};
};

}  // namespace impinge::test
