// SPDX-License-Identifier: GPL-3.0-or-later
#include "scheme_metrics/interpolation_error.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <stdexcept>
#include <utility>

#include "sphere/uniform_directions.hpp"

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

BandLimited::BandLimited(const BandLimitedChoice& choice)
    : count_(choice.waves), amplitude_(std::sqrt(2.0 / static_cast<double>(choice.waves))) {
  if (choice.waves == 0 || choice.functions == 0) {
    throw std::invalid_argument("band-limited functions are at least one, each of at least one wave");
  }
  if (!std::isfinite(choice.wavenumber)) throw std::invalid_argument("a wavenumber is a finite number");
  std::mt19937_64 random(choice.seed);
  waves_.reserve(choice.waves * choice.functions);
  for (std::size_t m = 0; m < choice.waves * choice.functions; ++m) {
    const Vec3 vector = choice.wavenumber * uniform_direction(random);
    waves_.push_back({vector, 2.0 * kPi * uniform(random)});
  }
}

double BandLimited::value(std::size_t function, const Vec3& u) const {
  double sum = 0.0;
  for (const Wave& wave : std::span(waves_).subspan(function * count_, count_)) {
    sum += std::cos(wave.vector.dot(u) + wave.phase);
  }
  return amplitude_ * sum;
}

}  // namespace impinge
