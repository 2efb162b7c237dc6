// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers and directions that are the same with every standard library; its distributions are not.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "sphere/direction.hpp"

namespace impinge {

/// Uniform in [0, 1).
inline double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1p-53; }

/// Uniform on the sphere: by the theorem of Archimedes heights are uniform.
inline Vec3 uniform_direction(std::mt19937_64& random) {
  const double z = 2.0 * uniform(random) - 1.0;
  const double theta = 2.0 * kPi * uniform(random);
  const double across = std::sqrt((1.0 - z) * (1.0 + z));
  return {across * std::cos(theta), across * std::sin(theta), z};
}

/// Uniform on the sphere; the same everywhere for a given seed.
inline std::vector<Vec3> uniform_directions(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> directions;
  directions.reserve(count);
  for (std::size_t i = 0; i < count; ++i) directions.push_back(uniform_direction(random));
  return directions;
}

/// Uniform on the caps within an angle (radians) of the two poles, which take turns.
inline std::vector<Vec3> polar_directions(std::size_t count, double within, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> directions;
  directions.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    // 1 - cos(phi) = 2 sin^2(phi / 2) is uniform.
    const double phi = 2.0 * std::asin(std::sin(0.5 * within) * std::sqrt(uniform(random)));
    const Vec3 u = to_direction({phi, 2.0 * kPi * uniform(random)});
    directions.emplace_back(u.x(), u.y(), i % 2 == 0 ? u.z() : -u.z());
  }
  return directions;
}

}  // namespace impinge
