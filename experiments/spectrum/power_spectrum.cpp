// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectrum/power_spectrum.hpp"

#include <cmath>
#include <stdexcept>

namespace impinge {

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
  constexpr double rounding = 1e-9;  // 2 pi / (pi / 5.5) is meant to be 11
  return static_cast<std::size_t>((2.0 * kPi / gap * (1.0 + rounding) + 1.0) / 2.0);
}

}  // namespace impinge
