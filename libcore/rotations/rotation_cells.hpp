// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Cells of rotations: four octrees that hold every rotation.
///
/// A rotation is a pair of unit quaternions q and -q. Divided by its largest coordinate q lies on one of four
/// cubes: that coordinate is 1, the others are in [-1, 1]. A cell is a cube of side 2 / 2^level in one of
/// them, its eighths are its children. (Cells of a Hopf fibration have equal volumes, Yershova et al. 2010,
/// doi:10.1177/0278364909352700; cubes are chosen since corners and centres are whole numbers over a power of
/// two, so that the rotations of their quaternions are rational, and since faces meet faces, across cubes
/// too.)
///
/// Radius. The angle between two rotations is twice that between their quaternions. Quaternions within an
/// angle below a quarter turn of the centre's are a cone that cuts the space of the cube in a convex set: the
/// farthest point of a cell is a corner.
/// Share. Central projection has the volume element dx dy dz / (1 + x^2 + y^2 + z^2)^2, and half of the
/// sphere of quaternions has the volume pi^2. Theorem 14 (volume).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

namespace impinge {

/// A cell of rotations.
struct RotationCell {
  std::uint32_t level = 0;   // 0 for a whole cube, at most kFinestCells
  std::uint64_t number = 0;  // cube 8^level + place along the curve of the cells of the cube, below 4 8^level
  bool operator==(const RotationCell&) const = default;
};
inline constexpr std::uint32_t kFinestCells = 19;  // levels

/// Coordinates w, x, y, z of a quaternion of any length.
using Quaternion4 = Eigen::Vector4d;

/// Eighth k (0 to 7) of a cell. level below kFinestCells.
inline RotationCell child(const RotationCell& cell, std::uint64_t k) {
  return {cell.level + 1, 8 * cell.number + k};
}
/// The cell that it is an eighth of. level above 0.
inline RotationCell parent(const RotationCell& cell) { return {cell.level - 1, cell.number / 8}; }

/// The quaternion in the middle of a cell: 1 at the place of the cube's number, the others whole numbers over
/// 2^level. Exact.
Quaternion4 centre(const RotationCell& cell);

/// A point of the cell, -1 to 1 along each of its three sides. Exact for -1, 0 and 1.
Quaternion4 point_of(const RotationCell& cell, const std::array<double, 3>& along);

/// The rotation of a quaternion of any length above 0: a rational matrix, off by 1e-15 an entry.
Eigen::Matrix3d rotation_of(const Quaternion4& q);

/// No rotation of the cell is farther than that from the one in its middle, radians.
double angular_radius(const RotationCell& cell);

/// Share of all rotations, by Gauss's rule; relative error below kShareError. Those of all cells of a level
/// sum to 1.
double share(const RotationCell& cell);
/// Four points a side hold x^2 with |Im| < 0.9 of what makes the integrand infinite: on the ellipse that
/// reaches as far, its sum of half axes 28.8 from level 4 on, the integrand is 28 times as large at most, and
/// the error 64/15 28 28.8^-8 / (1 - 28.8^-2) a side (Trefethen 2008, doi:10.1137/060659831), 5e-10 in three.
inline constexpr double kShareError = 1e-9;

/// The cell of a level that holds a rotation; level at most kFinestCells. On a border one of them.
RotationCell cell_of(const Quaternion4& q, std::uint32_t level);

/// The cell of the same level that shares a side: side 2 k + 1 is at the upper end of the k-th coordinate,
/// side 2 k at the lower; across the border of a cube it belongs to another cube.
RotationCell beside(const RotationCell& cell, std::size_t side);

}  // namespace impinge
