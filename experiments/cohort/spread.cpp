// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/spread.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Cholesky>
#include <gsl/gsl_cdf.h>

namespace impinge::lab {
namespace {

constexpr std::array kShapes{std::pair{"normal", Shape::normal},
                             std::pair{"censored_normal", Shape::censored_normal},
                             std::pair{"lognormal", Shape::lognormal}, std::pair{"uniform", Shape::uniform}};

// The z at the same share of the part of a standard normal distribution between two of its points. Works from
// the nearer end, so that no digits are lost in a tail.
double cut(double z, double from, double to) {
  if (from + to > 0.0) return -cut(-z, -to, -from);
  const double below = gsl_cdf_ugaussian_P(from);
  const double share = below + gsl_cdf_ugaussian_P(z) * (gsl_cdf_ugaussian_P(to) - below);
  return std::clamp(gsl_cdf_ugaussian_Pinv(share), from, to);
}

constexpr double kLeastPivot = 1e-6;  // below, one parameter is determined by others

Eigen::Index place_of(std::span<const Spread> spreads, const std::string& name) {
  for (std::size_t k = 0; k < spreads.size(); ++k) {
    if (spreads[k].parameter->name == name) return static_cast<Eigen::Index>(k);
  }
  throw std::invalid_argument("correlations: '" + name +
                              "' is no parameter with a distribution; give it one");
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

Eigen::MatrixXd mixing_of(std::span<const Spread> spreads, std::span<const Correlation> correlations) {
  const auto size = static_cast<Eigen::Index>(spreads.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
  for (const Correlation& pair : correlations) {
    const Eigen::Index i = place_of(spreads, pair.one);
    const Eigen::Index k = place_of(spreads, pair.other);
    if (i == k || matrix(i, k) != 0.0)
      throw std::invalid_argument("correlations: " + pair.one + " and " + pair.other +
                                  " are one parameter or given twice; name each pair once");
    matrix(i, k) = matrix(k, i) = pair.r;
  }
  const Eigen::LLT<Eigen::MatrixXd> root(matrix);
  Eigen::MatrixXd lower = root.matrixL();
  if (root.info() != Eigen::Success || (size > 0 && lower.diagonal().minCoeff() < kLeastPivot))
    throw std::invalid_argument(
        "correlations: the matrix is not positive definite, no population has these; make some of them "
        "smaller");
  return lower;
}

}  // namespace impinge::lab
