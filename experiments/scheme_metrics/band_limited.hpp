// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth random functions on the sphere with a known finest detail, to measure interpolation with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sphere/direction.hpp"

namespace impinge {

/// Which functions are drawn.
struct BandLimitedChoice {
  double wavenumber = 30.0;  // phase a unit of length, radians: the finest detail is 2 pi / 30 = 12 degrees
  std::size_t waves = 16;    // of each function
  std::size_t functions = 512;  // in all
  std::uint64_t seed = 0;       // of directions and phases
};

/// Independent functions, each a sum of plane waves in random directions n_m with random phases p_m, as they
/// are met on the unit sphere:
///   f(u) = sqrt(2 / M) sum cos(k n_m . u + p_m),
/// of mean 0 and variance 1 over all choices of the waves, and without preferred direction. Harmonics of
/// degree l weigh as spherical Bessel functions j_l(k), which vanish fast beyond l = k. There are many
/// functions because the sharpest peak of a single one would settle the largest errors.
class BandLimited {
 public:
  /// Throws std::invalid_argument for no wave, no function or an infinite wavenumber.
  explicit BandLimited(const BandLimitedChoice& choice);

  std::size_t functions() const { return waves_.size() / count_; }  // how many there are

  /// Value of a function at a unit vector.
  double value(std::size_t function, const Vec3& u) const;

 private:
  struct Wave {
    Vec3 vector;
    double phase;
  };

  std::size_t count_;        // waves of one function
  std::vector<Wave> waves_;  // those of the first function, then those of the second ...
  double amplitude_;
};

}  // namespace impinge
