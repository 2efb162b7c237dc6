// SPDX-License-Identifier: GPL-3.0-or-later
// Lower bounds on the distances of the cells of a grid from a surface: one look-up tells that a whole sphere
// is clear of the surface. Theorem 9 (near).
//
// The grid divides the box round the faces into cubes of `size`. The squared distance of two cells is a sum
// over the axes, so that one pass along each axis finds the least over all cells that may hold a point of the
// surface.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/face_runs.hpp"

namespace impinge {

struct NearCells {
  static constexpr int kReach = 15;  // cells; larger distances count as this
  static constexpr double kMostCells = 0x1p20;

  explicit NearCells(const FaceRuns& surface);  // the surface must have a face

  Vec3 origin = Vec3::Zero();  // mm, the lowest corner
  double size = 0.0;           // mm
  std::array<int, 3> cells{};  // along each axis
  /// For each cell, x running fastest: 0 if it may hold a point of the surface, else 1 + the square of its
  /// distance in cells.
  std::vector<std::uint8_t> square;
};

}  // namespace impinge
