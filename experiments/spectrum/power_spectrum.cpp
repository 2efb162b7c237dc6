// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectrum/power_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <gsl/gsl_sf_legendre.h>

namespace impinge {
namespace {

// Fourier transforms of real rows of the same length.
class RowTransform {
 public:
  explicit RowTransform(std::size_t length)
      : length_(length),
        real_(gsl_fft_real_wavetable_alloc(length), &gsl_fft_real_wavetable_free),
        space_(gsl_fft_real_workspace_alloc(length), &gsl_fft_real_workspace_free) {
    if (!real_ || !space_) throw std::bad_alloc();
  }

  // f_m = sum over columns of f e^(-i m theta), for m < length / 2.
  std::vector<std::complex<double>> operator()(std::vector<double> row) const {
    gsl_fft_real_transform(row.data(), 1, length_, real_.get(), space_.get());
    std::vector<std::complex<double>> result(length_ / 2);
    result[0] = row[0];  // GSL's order: real 0, real 1, imaginary 1, real 2 ...
    for (std::size_t m = 1; m < result.size(); ++m) result[m] = {row[2 * m - 1], row[2 * m]};
    return result;
  }

 private:
  std::size_t length_;
  std::unique_ptr<gsl_fft_real_wavetable, decltype(&gsl_fft_real_wavetable_free)> real_;
  std::unique_ptr<gsl_fft_real_workspace, decltype(&gsl_fft_real_workspace_free)> space_;
};

// The factors of Y_lm that depend on z, in the order of HarmonicCoefficients, which is GSL's own.
class Legendre {
 public:
  explicit Legendre(std::size_t band_limit)
      : degree_(band_limit - 1), values_(gsl_sf_legendre_array_n(degree_)) {}

  const std::vector<double>& operator()(double z) {
    gsl_sf_legendre_array_e(GSL_SF_LEGENDRE_SPHARM, degree_, z, 1.0, values_.data());
    return values_;
  }

 private:
  std::size_t degree_;
  std::vector<double> values_;
};

}  // namespace

std::vector<double> power_by_degree(const HarmonicCoefficients& coefficients) {
  std::vector<double> power(coefficients.band_limit);
  for (std::size_t l = 0; l < power.size(); ++l) {
    power[l] = std::norm(coefficients.at(l, 0));
    for (std::size_t m = 1; m <= l; ++m) power[l] += 2.0 * std::norm(coefficients.at(l, m));
  }
  return power;
}

std::vector<double> cumulative_shares(const std::vector<double>& power) {
  std::vector<double> shares(power.size(), 0.0);
  double sum = 0.0;
  for (std::size_t l = 1; l < power.size(); ++l) {
    sum += power[l];
    shares[l] = sum;
  }
  for (double& share : shares) share = sum > 0.0 ? share / sum : 1.0;
  return shares;
}

std::size_t band_limit(const std::vector<double>& power, double share) {
  const std::vector<double> shares = cumulative_shares(power);
  std::size_t limit = 1;
  while (limit < shares.size() && shares[limit - 1] < share) ++limit;
  return limit;
}

double rms_beyond(const std::vector<double>& power, std::size_t band_limit) {
  double sum = 0.0;
  for (std::size_t l = power.size(); l > band_limit; --l) sum += power[l - 1];
  return std::sqrt(sum / (4.0 * kPi));
}

std::size_t band_limit_leaving(const std::vector<double>& power, double rms) {
  std::size_t limit = power.size();
  double sum = 0.0;
  while (limit > 1) {
    sum += power[limit - 1];
    if (std::sqrt(sum / (4.0 * kPi)) > rms) break;
    --limit;
  }
  return limit;
}

std::size_t optimal_entries(std::size_t band_limit) { return band_limit * band_limit; }

std::size_t driscoll_healy_entries(std::size_t band_limit) { return 4 * band_limit * band_limit; }

std::size_t mcewen_wiaux_entries(std::size_t band_limit) {
  return band_limit == 0 ? 0 : (band_limit - 1) * (2 * band_limit - 1) + 1;
}

double nyquist_angle_deg(std::size_t band_limit) { return 180.0 / static_cast<double>(band_limit); }

std::size_t band_limit_of_gap(double gap) {
  if (!(gap > 0.0 && gap <= 2.0 * kPi)) {
    throw std::invalid_argument("entries on a circle are more than 0 and at most 2 pi radians apart");
  }
  constexpr double rounding = 1e-9;  // 2 pi / (pi / 5.5) must give 11
  return static_cast<std::size_t>((2.0 * kPi / gap * (1.0 + rounding) + 1.0) / 2.0);
}

HarmonicCoefficients zero_coefficients(std::size_t band_limit) {
  return {band_limit, std::vector<std::complex<double>>(band_limit * (band_limit + 1) / 2)};
}

HarmonicCoefficients analyse(const GaussGrid& grid, const std::vector<double>& values) {
  const bool numbers = std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
  if (values.size() != grid.size() || !numbers) {
    throw std::invalid_argument(
        "a spectrum needs one number for each direction of the grid: fill holes first");
  }
  HarmonicCoefficients result = zero_coefficients(grid.band_limit());
  const RowTransform transform(grid.columns());
  Legendre legendre(grid.band_limit());
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(row * grid.columns());
    const auto fourier = transform({begin, begin + static_cast<std::ptrdiff_t>(grid.columns())});
    const std::vector<double>& factor = legendre(grid.z(row));
    for (std::size_t l = 0, k = 0; l < grid.band_limit(); ++l) {
      for (std::size_t m = 0; m <= l; ++m, ++k) result.values[k] += grid.weight(row) * factor[k] * fourier[m];
    }
  }
  return result;
}

std::vector<double> synthesise(const GaussGrid& grid, const HarmonicCoefficients& coefficients) {
  const std::size_t limit = coefficients.band_limit;
  if (limit < 1 || limit > grid.band_limit()) {
    throw std::invalid_argument("coefficients of band limit " + std::to_string(limit) +
                                " do not fit a grid for " + std::to_string(grid.band_limit()));
  }
  std::vector<double> values(grid.size(), 0.0);
  Legendre legendre(limit);
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    const std::vector<double>& factor = legendre(grid.z(row));
    std::vector<std::complex<double>> fourier(limit);
    for (std::size_t l = 0, k = 0; l < limit; ++l) {
      for (std::size_t m = 0; m <= l; ++m, ++k) fourier[m] += factor[k] * coefficients.values[k];
    }
    for (std::size_t column = 0; column < grid.columns(); ++column) {
      double& value = values[row * grid.columns() + column];
      value = fourier[0].real();
      for (std::size_t m = 1; m < limit; ++m) {
        const CosSin turn = half_turn_fraction(static_cast<long>(m * column), static_cast<long>(grid.rows()));
        value += 2.0 * (fourier[m].real() * turn.cos - fourier[m].imag() * turn.sin);
      }
    }
  }
  return values;
}

}  // namespace impinge
