// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Cells of rotations: four octrees that hold every rotation. Theorem 14 (volume), (iv) and its use.
///
/// A rotation is a pair of unit quaternions q and -q. Divided by its largest coordinate q lies on one of four
/// cubes: that coordinate is 1, the others are in [-1, 1]. A cell is a cube of side 2 / 2^level in one of
/// them, and its eighths are its children. (Cells of a Hopf fibration have equal volumes, Yershova et al.
/// 2010, doi:10.1177/0278364909352700. Cubes are chosen because the quaternions of their corners and centres
/// are whole numbers over a power of two, so that their rotations are rational, and because cells meet side
/// to side, across cubes too.)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

namespace impinge {

/// A cell of rotations.
struct RotationCell {
  std::uint32_t level = 0;   // 0 for a whole cube, at most kFinestCells
  std::uint64_t number = 0;  // cube 8^level + index of the cell in the cube, in Morton order
  bool operator==(const RotationCell&) const = default;
};
inline constexpr std::uint32_t kFinestCells = 19;  // levels

/// Coordinates w, x, y, z of a quaternion of any length.
using Quaternion4 = Eigen::Vector4d;

/// Eighth k (0 to 7) of a cell of a level below kFinestCells.
inline RotationCell child(const RotationCell& cell, std::uint64_t k) {
  return {cell.level + 1, 8 * cell.number + k};
}
/// The cell whose eighth a cell of a level above 0 is.
inline RotationCell parent(const RotationCell& cell) { return {cell.level - 1, cell.number / 8}; }

/// The quaternion in the middle of a cell: the cube's coordinate is 1, the others are whole numbers over
/// 2^level. Exact.
Quaternion4 centre(const RotationCell& cell);

/// The quaternion at -1 to 1 along each of the cell's three sides. Exact for -1, 0 and 1.
Quaternion4 point_of(const RotationCell& cell, const std::array<double, 3>& along);

/// The rotation of a quaternion of any length above 0; each entry is right to 1e-15.
Eigen::Matrix3d rotation_of(const Quaternion4& q);

/// The largest angle, radians, of a rotation of the cell from the one in its middle, rounded up.
double angular_radius(const RotationCell& cell);

/// The share of all rotations that a cell holds, by Gauss's rule, with a relative error below kShareError.
/// The shares of all cells of a level sum to 1.
double share(const RotationCell& cell);
/// Above the error of Gauss's rule with four points along each side. From level 4 on the integrand is
/// analytic in the ellipse about a side whose half axes sum to 28.8 times half the side, and nowhere there
/// larger than 28 times its mean over the side. So one side adds a relative error of at most
/// 28 (32/15) 28.8^-8 / (1 - 28.8^-2) (Trefethen 2008, doi:10.1137/060659831), three less than 5e-10.
inline constexpr double kShareError = 1e-9;

/// The cell of a level, at most kFinestCells, that holds a rotation; one of them if it is on a border.
RotationCell cell_of(const Quaternion4& q, std::uint32_t level);

/// The cell of the same level beyond a side: side 2 k is at the lower end of the k-th coordinate, side 2 k +
/// 1 at the upper end. Across the border of a cube it belongs to another cube.
RotationCell beside(const RotationCell& cell, std::size_t side);

}  // namespace impinge
