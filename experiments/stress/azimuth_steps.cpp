// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/azimuth_steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sphere/direction.hpp"
#include "stress/family.hpp"

namespace impinge::lab {
namespace {

StabilityCase start(double step, const char* method, Scalar scalar, double threshold) {
  StabilityCase result;
  result.magnitude = step;
  result.method = method;
  result.kind = "brute";
  result.scalar = scalar;
  result.threshold = threshold;
  return result;
}

std::uint64_t columns_of(double step) { return static_cast<std::uint64_t>(std::llround(360.0 / step)); }

}  // namespace

StabilityCase float_azimuths(double step, double threshold) {
  StabilityCase result = start(step, "azimuths_in_float", Scalar::float32, threshold);
  const std::uint64_t columns = columns_of(step);
  float before = -1.0F;
  for (std::uint64_t j = columns - std::min<std::uint64_t>(columns, 100); j < columns; ++j) {
    const double truth = static_cast<double>(j) * step;
    const auto azimuth = static_cast<float>(truth);
    include_error(result, std::abs(static_cast<double>(azimuth) - truth) * kDegree, 1.0);
    if (azimuth == before) ++result.wrong;
    before = azimuth;
  }
  return result;
}

StabilityCase summed_azimuths(double step, double threshold) {
  constexpr std::uint64_t kMost = 1'000'000;
  StabilityCase result = start(step, "azimuths_summed", Scalar::float64, threshold);
  const std::uint64_t columns = std::min(columns_of(step), kMost);
  double sum = 0.0;
  for (std::uint64_t j = 0; j < columns; ++j) {
    const double truth = static_cast<double>(j) * step;
    if (j % 1000 == 0) include_error(result, std::abs(sum - truth) * kDegree, 1.0);
    sum += step;
  }
  return result;
}

}  // namespace impinge::lab
