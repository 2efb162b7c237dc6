// SPDX-License-Identifier: GPL-3.0-or-later
// How far from a surface are the cells of a grid, at least? One look says that all of a ball is clear of it.
//
// The grid is the box round the faces, in cubes of `size`. With n = max(0, |i| - 1) for cells that are i
// apart along an axis, no points of the two are nearer to each other than sqrt(n_x^2 + n_y^2 + n_z^2) cells.
// The least of that over all cells that may hold a point of the surface comes of one pass along each axis,
// for it is a sum. Of a point c outside of the grid and the point p of the grid nearest to it, every point s
// of the surface has |c - s|^2 >= |c - p|^2 + |p - s|^2, as a box is convex. Theorem 9 (near).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/face_runs.hpp"

namespace impinge {

struct NearCells {
  static constexpr int kReach = 15;  // cells; what is farther counts as so far
  static constexpr double kMostCells = 0x1p20;

  explicit NearCells(const FaceRuns& surface);  // with a face

  Vec3 origin = Vec3::Zero();  // mm, the lowest corner
  double size = 0.0;           // mm
  std::array<int, 3> cells{};  // along each axis
  /// 0 of a cell that may hold a point of the surface; else 1 + the square of the distance in cells. x runs
  /// fastest.
  std::vector<std::uint8_t> square;
};

}  // namespace impinge
