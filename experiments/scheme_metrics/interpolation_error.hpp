// SPDX-License-Identifier: GPL-3.0-or-later
// How far a table is from smooth functions, looked up with the scheme's own stencil.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "sphere/direction.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

// Smooth random functions on the sphere with a known finest detail, to measure interpolation with.

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

/// Directions, each with the function that is looked up there and its value: made once, used for every
/// scheme.
struct ErrorProbe {
  ErrorProbe(BandLimited functions, std::vector<Vec3> directions);  // works out the true values

  /// The function that direction i looks up: each in its turn.
  std::size_t function_at(std::size_t i) const { return i % functions.functions(); }

  BandLimited functions;         // that tables are filled with
  std::vector<Vec3> directions;  // unit vectors
  std::vector<double> truth;     // of each direction's function there
};

/// In units of the standard deviation of the functions. p9999 is exceeded in 1 of 10,000 directions: the
/// largest value of a random sample varies too much to compare schemes by.
struct InterpolationError {
  double max = 0.0;    // largest in size
  double p9999 = 0.0;  // see above
  double rms = 0.0;    // root mean square
};

/// Of errors of either sign; p9999 is the nearest rank, a value of the sample. Throws std::invalid_argument
/// for no error and std::runtime_error for one that is not finite.
InterpolationError summarise_errors(std::vector<double> errors);

/// Errors, in the directions of the probe, of tables of the scheme, one of each function. Only entries that a
/// stencil reads are worked out.
template <SamplingScheme S>
InterpolationError interpolation_error(const S& scheme, const ErrorProbe& probe) {
  std::vector<double> errors;
  errors.reserve(probe.directions.size());
  for (std::size_t i = 0; i < probe.directions.size(); ++i) {
    const Stencil stencil = scheme.stencil(probe.directions[i]);
    double answer = 0.0;
    for (std::size_t k = 0; k < stencil.taps; ++k) {
      const Vec3 entry = scheme.direction(stencil.entry[k]);
      answer += stencil.weight[k] * probe.functions.value(probe.function_at(i), entry);
    }
    errors.push_back(answer - probe.truth[i]);
  }
  return summarise_errors(std::move(errors));
}

}  // namespace impinge
