// SPDX-License-Identifier: GPL-3.0-or-later
// Power by degree, the band limit that carries it, and the entries that sampling theorems require.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "spectrum/gauss_grid.hpp"

namespace impinge {

// Spherical harmonics of a real function on the sphere.

/// f = sum over l < L, |m| <= l of a_lm Y_lm, with Y_lm orthonormal over the sphere and without the
/// Condon-Shortley phase. As f is real, a_l,-m is the conjugate of a_lm, and only m >= 0 is kept.
struct HarmonicCoefficients {
  std::size_t band_limit = 0;                // L
  std::vector<std::complex<double>> values;  // a_lm at l (l + 1) / 2 + m; unit of f

  /// a_lm, 0 <= m <= l < L.
  std::complex<double>& at(std::size_t l, std::size_t m) { return values[l * (l + 1) / 2 + m]; }
  std::complex<double> at(std::size_t l, std::size_t m) const { return values[l * (l + 1) / 2 + m]; }
};

/// Coefficients for all degrees below the band limit, all zero.
HarmonicCoefficients zero_coefficients(std::size_t band_limit);

/// Coefficients below the band limit of the grid, by GSL's Legendre functions and a Fourier transform of each
/// row. They are exact but for rounding if f has that band limit. O(L^3). Throws std::invalid_argument unless
/// there is one finite value per direction, row by row.
HarmonicCoefficients analyse(const GaussGrid& grid, const std::vector<double>& values);

/// The function's values on the grid, row by row, by plain summation of the series: the inverse of analyse().
/// Throws std::invalid_argument if the coefficients reach beyond the grid.
std::vector<double> synthesise(const GaussGrid& grid, const HarmonicCoefficients& coefficients);

/// Sum of |a_lm|^2 over m = -l..l for each degree l; together they are the integral of f^2 over the sphere.
std::vector<double> power_by_degree(const HarmonicCoefficients& coefficients);

/// Share of the power of degrees 1 and up that degrees 1..l carry, for each l. Degree 0 is left out: it is
/// the mean radius, which has nearly all power of a head but needs a single number. 1 everywhere if degrees 1
/// and up have no power.
std::vector<double> cumulative_shares(const std::vector<double>& power);

/// Smallest band limit L (degrees below L) that carries `share` (0 to 1) of the power of degrees 1 and up; 1
/// if these have no power.
std::size_t band_limit(const std::vector<double>& power, double share);

/// Root mean square over the sphere of the part of degrees band_limit and up; unit of the function.
double rms_beyond(const std::vector<double>& power, std::size_t band_limit);

/// Smallest band limit, 1 or more, that leaves out no more than this root mean square (rms_beyond()).
std::size_t band_limit_leaving(const std::vector<double>& power, double rms);

/// Number of entries that determine a function of band limit L: its coefficients, l < L and |m| <= l. Khalid,
/// Kennedy and McEwen (2014), "An optimal-dimensionality sampling scheme on the sphere with fast spherical
/// harmonic transforms", have a scheme of that many entries (accurate, without a theorem that it is exact).
std::size_t optimal_entries(std::size_t band_limit);
/// Equal angles, 2 L rows of 2 L: Driscoll and Healy (1994), "Computing Fourier transforms and convolutions
/// on the 2-sphere".
std::size_t driscoll_healy_entries(std::size_t band_limit);
/// Equal angles, L rows of 2 L - 1 of which one shrinks to a pole: McEwen and Wiaux (2011), "A novel sampling
/// theorem on the sphere".
std::size_t mcewen_wiaux_entries(std::size_t band_limit);

/// Nyquist distance of entries for band limit L, pi / L, degrees: entries farther apart are too few.
double nyquist_angle_deg(std::size_t band_limit);

/// Largest band limit that entries `gap` radians apart all round a great circle determine. There a function
/// of band limit L is a trigonometric polynomial of degree L - 1 with 2 L - 1 coefficients, which must be at
/// most 2 pi / gap. Throws std::invalid_argument unless 0 < gap <= 2 pi.
std::size_t band_limit_of_gap(double gap);

}  // namespace impinge
