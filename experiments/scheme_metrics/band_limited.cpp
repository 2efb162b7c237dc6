// SPDX-License-Identifier: GPL-3.0-or-later
#include "scheme_metrics/band_limited.hpp"

#include <cmath>
#include <random>
#include <span>
#include <stdexcept>

#include "sphere/uniform_directions.hpp"

namespace impinge {

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
