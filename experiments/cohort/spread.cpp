// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/spread.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <gsl/gsl_cdf.h>

namespace impinge::lab {
namespace {

constexpr std::array kShapes{std::pair{"normal", Shape::normal},
                             std::pair{"censored_normal", Shape::censored_normal},
                             std::pair{"lognormal", Shape::lognormal}, std::pair{"uniform", Shape::uniform}};

// z of the same share of the part of a standard normal distribution between two of its points. From the end
// that is nearer, so that no digits are lost in a tail.
double cut(double z, double from, double to) {
  if (from + to > 0.0) return -cut(-z, -to, -from);
  const double below = gsl_cdf_ugaussian_P(from);
  const double share = below + gsl_cdf_ugaussian_P(z) * (gsl_cdf_ugaussian_P(to) - below);
  return std::clamp(gsl_cdf_ugaussian_Pinv(share), from, to);
}

}  // namespace

Shape shape_of(const std::string& name) {
  std::string known;
  for (const auto& [text, shape] : kShapes) {
    if (name == text) return shape;
    known += (known.empty() ? "" : ", ") + std::string(text);
  }
  throw std::invalid_argument("no distribution is called '" + name + "'; there are " + known);
}

double value_at(const Spread& s, double z) {
  double value = 0.0;
  switch (s.shape) {
    case Shape::normal:
      value = s.centre + s.width * cut(z, (s.least - s.centre) / s.width, (s.most - s.centre) / s.width);
      break;
    case Shape::censored_normal:
      value = s.centre + s.width * z;
      break;
    case Shape::lognormal:
      value = s.centre * std::exp(s.width * cut(z, std::log(s.least / s.centre) / s.width,
                                                std::log(s.most / s.centre) / s.width));
      break;
    case Shape::uniform:
      value = s.least + (s.most - s.least) * gsl_cdf_ugaussian_P(z);
      break;
  }
  return std::clamp(value, s.least, s.most);
}

}  // namespace impinge::lab
