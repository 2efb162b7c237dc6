// SPDX-License-Identifier: GPL-3.0-or-later
#include "scheme_metrics/interpolation_error.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace impinge {

ErrorProbe::ErrorProbe(BandLimited several, std::vector<Vec3> where)
    : functions(std::move(several)), directions(std::move(where)) {
  truth.reserve(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    truth.push_back(functions.value(function_at(i), directions[i]));
  }
}

InterpolationError summarise_errors(std::vector<double> errors) {
  if (errors.empty()) throw std::invalid_argument("there is no error to summarise: probe a direction");
  double squares = 0.0;
  for (double& error : errors) {
    if (!std::isfinite(error)) throw std::runtime_error("a table answered with no number");
    squares += error * error;
    error = std::abs(error);
  }
  const auto count = static_cast<double>(errors.size());
  const auto rank = static_cast<std::size_t>(std::ceil(0.9999 * count)) - 1;
  InterpolationError result;
  result.rms = std::sqrt(squares / count);
  std::ranges::nth_element(errors, errors.begin() + static_cast<std::ptrdiff_t>(rank));
  result.p9999 = errors[rank];
  result.max = *std::max_element(errors.begin() + static_cast<std::ptrdiff_t>(rank), errors.end());
  return result;
}

}  // namespace impinge
