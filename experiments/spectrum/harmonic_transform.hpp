// SPDX-License-Identifier: GPL-3.0-or-later
// Spherical harmonics of a real function on the sphere.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "spectrum/gauss_grid.hpp"

namespace impinge {

/// f = sum over l < L, |m| <= l of a_lm Y_lm, Y_lm orthonormal over the sphere and without the
/// Condon-Shortley phase. f is real, so that a_l,-m is the conjugate of a_lm and only m >= 0 is kept.
struct HarmonicCoefficients {
  std::size_t band_limit = 0;                // L
  std::vector<std::complex<double>> values;  // of (l, m) at l (l + 1) / 2 + m; unit of f

  /// a_lm, 0 <= m <= l < L.
  std::complex<double>& at(std::size_t l, std::size_t m) { return values[l * (l + 1) / 2 + m]; }
  std::complex<double> at(std::size_t l, std::size_t m) const { return values[l * (l + 1) / 2 + m]; }
};

/// All coefficients for degrees below the band limit, zero.
HarmonicCoefficients zero_coefficients(std::size_t band_limit);

/// Coefficients below the band limit of the grid, by GSL's Legendre functions and a Fourier transform of each
/// row; exact but for rounding when f has that band limit. O(L^3). std::invalid_argument unless there is one
/// finite value for each direction, row by row.
HarmonicCoefficients analyse(const GaussGrid& grid, const std::vector<double>& values);

/// The function's values on the grid, row by row, by plain summation of the series: the inverse of analyse().
/// std::invalid_argument when the coefficients reach beyond the grid.
std::vector<double> synthesise(const GaussGrid& grid, const HarmonicCoefficients& coefficients);

}  // namespace impinge
