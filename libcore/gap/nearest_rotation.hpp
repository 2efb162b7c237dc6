// SPDX-License-Identifier: GPL-3.0-or-later
// A rotation from a matrix of few digits.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace impinge {

/// Largest difference of an entry by which a matrix of few digits still counts as a rotation.
inline constexpr double kLargestSkew = 1e-4;

/// Largest difference from 1 by which the length of a quaternion of few digits still counts as 1.
inline constexpr double kLargestLengthError = 0.01;

/// The rotation nearest to a matrix in the least squares sense (Kabsch 1976); none where an entry is off from
/// it by more than kLargestSkew or is not finite, or the matrix mirrors.
inline std::optional<Eigen::Matrix3d> nearest_rotation(const Eigen::Matrix3d& given) {
  if (!given.allFinite()) return std::nullopt;
  const Eigen::JacobiSVD<Eigen::Matrix3d> parts(given, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d nearest = parts.matrixU() * parts.matrixV().transpose();
  if (!((given - nearest).cwiseAbs().maxCoeff() <= kLargestSkew) || nearest.determinant() < 0.0)
    return std::nullopt;
  return nearest;
}

}  // namespace impinge
