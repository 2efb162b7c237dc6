// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a rotation from a matrix that is given with few digits.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace impinge {

/// A matrix counts as a rotation if no entry differs from the nearest rotation by more than this.
inline constexpr double kLargestSkew = 1e-4;

/// The length of a quaternion counts as 1 if it differs from 1 by no more than this.
inline constexpr double kLargestLengthError = 0.01;

/// The rotation nearest to a matrix in the least squares sense (Kabsch 1976). std::nullopt if an entry
/// differs from it by more than kLargestSkew or is not finite, or if the matrix mirrors.
inline std::optional<Eigen::Matrix3d> nearest_rotation(const Eigen::Matrix3d& given) {
  if (!given.allFinite()) return std::nullopt;
  const Eigen::JacobiSVD<Eigen::Matrix3d> parts(given, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d nearest = parts.matrixU() * parts.matrixV().transpose();
  if (!((given - nearest).cwiseAbs().maxCoeff() <= kLargestSkew) || nearest.determinant() < 0.0)
    return std::nullopt;
  return nearest;
}

}  // namespace impinge
