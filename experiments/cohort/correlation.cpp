// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/correlation.hpp"

#include <stdexcept>

#include <Eigen/Cholesky>

namespace impinge::lab {
namespace {

constexpr double kLeastPivot = 1e-6;  // below, two parameters are one

Eigen::Index place_of(std::span<const Spread> spreads, const std::string& name) {
  for (std::size_t k = 0; k < spreads.size(); ++k) {
    if (spreads[k].parameter->name == name) return static_cast<Eigen::Index>(k);
  }
  throw std::invalid_argument("correlations: '" + name +
                              "' is no parameter with a distribution; give it one");
}

}  // namespace

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
