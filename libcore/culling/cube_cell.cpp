// SPDX-License-Identifier: GPL-3.0-or-later
#include "culling/cube_cell.hpp"

#include <algorithm>

#include "culling/cube_place.hpp"

namespace impinge {
namespace {

std::size_t cell_line(double coordinate, std::size_t lines) {
  const double place = std::max(0.5 * (coordinate + 1.0) * static_cast<double>(lines), 0.0);
  return std::min(static_cast<std::size_t>(place), lines - 1);
}

}  // namespace

std::size_t cell_of(const Vec3& axis, std::size_t level) {
  const CubePlace at = cube_place(axis);
  const std::size_t lines = std::size_t{1} << level;
  const std::size_t i = cell_line(at.a, lines);
  const std::size_t j = cell_line(at.b, lines);
  std::size_t cell = at.face;
  for (std::size_t bit = level; bit-- > 0;) cell = 4 * cell + 2 * ((j >> bit) & 1U) + ((i >> bit) & 1U);
  return cell;
}

std::array<Vec3, 4> cell_corners(const CubeCell& cell) {
  std::size_t i = 0;
  std::size_t j = 0;
  for (std::size_t bit = 0; bit < cell.level; ++bit) {
    i |= ((cell.prefix >> (2 * bit)) & 1U) << bit;
    j |= ((cell.prefix >> (2 * bit + 1)) & 1U) << bit;
  }
  const std::size_t face = cell.prefix >> (2 * cell.level);
  const double width = 2.0 / static_cast<double>(std::size_t{1} << cell.level);
  const auto at = [&](std::size_t k, std::size_t l) {
    return cube_point(face, -1.0 + width * static_cast<double>(k), -1.0 + width * static_cast<double>(l));
  };
  return {at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)};
}

}  // namespace impinge
