// SPDX-License-Identifier: GPL-3.0-or-later
// How a parameter spreads over a population.
#pragma once

#include <span>
#include <string>

#include <Eigen/Core>

#include "hip/hip_parameters.hpp"

namespace impinge::lab {

// The kinds of distributions.
enum class Shape {
  normal,           // with mean `centre` and standard deviation `width`, cut off at the ends
  censored_normal,  // normal, but values beyond an end are put on it: hips without a cam have a height of 0
  lognormal,        // median `centre`; `width` is the standard deviation of the natural logarithm; cut off
  uniform,          // between the ends
};

// Reads "normal" ... as in a study file. Throws std::invalid_argument, one line, for other names.
Shape shape_of(const std::string& name);

// The distribution of one parameter, in its unit.
struct Spread {
  const HipParameter* parameter = nullptr;  // of hip_parameter_list()
  Shape shape = Shape::normal;
  double centre = 0.0;
  double width = 1.0;  // above 0
  double least = 0.0;  // ends, within the range of the parameter, least below most
  double most = 0.0;
  std::string source;  // the publication, or that it is our choice
};

// The value below which the same share lies as below z in a standard normal distribution, for any z.
double value_at(const Spread& spread, double z);

// Correlated draws by a Gaussian copula: each parameter keeps its distribution, and the normal scores of two
// parameters have the given correlation.

// A correlation of two parameters, by their names.
struct Correlation {
  std::string one;
  std::string other;
  double r = 0.0;  // -1 to 1
};

// L, lower triangular, with L L^T the matrix of correlations: scores are L times independent ones. Throws
// std::invalid_argument, one line, for a pair that does not spread or is given twice, and for numbers that no
// population can have, where the matrix is not positive definite.
Eigen::MatrixXd mixing_of(std::span<const Spread> spreads, std::span<const Correlation> correlations);

}  // namespace impinge::lab
