// SPDX-License-Identifier: GPL-3.0-or-later
// Correlated draws: a Gaussian copula. Each parameter keeps its distribution; the normal scores of two of
// them have the given correlation.
#pragma once

#include <span>
#include <string>

#include <Eigen/Core>

#include "cohort/spread.hpp"

namespace impinge::lab {

// Of two parameters, by their names.
struct Correlation {
  std::string one;
  std::string other;
  double r = 0.0;  // -1 to 1
};

// L, lower triangular with L L^T the matrix of correlations: scores are L times independent ones.
// std::invalid_argument, one line, for a pair that does not spread or is given twice, and for numbers that no
// population has: a matrix that is not positive definite.
Eigen::MatrixXd mixing_of(std::span<const Spread> spreads, std::span<const Correlation> correlations);

}  // namespace impinge::lab
