// SPDX-License-Identifier: GPL-3.0-or-later
// The error of tables that sample smooth functions, looked up with the scheme's own stencil.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "sphere/direction.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

// Smooth random functions on the sphere with a known finest detail, on which interpolation is measured.

/// The choice of functions.
struct BandLimitedChoice {
  double wavenumber =
      30.0;                // radians of phase per unit of length: the finest detail is 2 pi / 30 = 12 degrees
  std::size_t waves = 16;  // of each function
  std::size_t functions = 512;  // in all
  std::uint64_t seed = 0;       // of directions and phases
};

/// Independent functions on the unit sphere, each a sum of plane waves of random directions n_m, phases p_m:
///   f(u) = sqrt(2 / M) sum cos(k n_m . u + p_m).
/// Over all choices of the waves they have mean 0, variance 1 and no preferred direction. Harmonics of degree
/// l have spherical Bessel functions j_l(k) as weights, which vanish fast beyond l = k. Many functions are
/// used, because the sharpest peak of a single one would determine the largest errors.
class BandLimited {
 public:
  /// Throws std::invalid_argument for no wave, no function, or an infinite wavenumber.
  explicit BandLimited(const BandLimitedChoice& choice);

  std::size_t functions() const { return waves_.size() / count_; }  // their number

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

/// Directions, each with a function that is looked up there and its value. Made once for all schemes.
struct ErrorProbe {
  ErrorProbe(BandLimited functions, std::vector<Vec3> directions);  // works out the true values

  /// The function that direction i looks up; they take turns.
  std::size_t function_at(std::size_t i) const { return i % functions.functions(); }

  BandLimited functions;         // that tables are filled with
  std::vector<Vec3> directions;  // unit vectors
  std::vector<double> truth;     // of each direction's function there
};

/// In units of the functions' standard deviation. p9999 is exceeded in 1 of 10,000 directions; the largest
/// value of a random sample varies too much for a comparison of schemes.
struct InterpolationError {
  double max = 0.0;    // largest absolute error
  double p9999 = 0.0;  // see above
  double rms = 0.0;    // root mean square
};

/// The summary of errors of either sign; p9999 is the nearest rank, a value of the sample. Throws
/// std::invalid_argument without errors, std::runtime_error for one that is not finite.
InterpolationError summarise_errors(std::vector<double> errors);

/// The errors, in the directions of the probe, of tables of the scheme, one for each function. Only entries
/// that a stencil reads are worked out.
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
