// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/cube_cell.hpp"

#include <algorithm>

#include "sphere/cube_faces.hpp"

namespace impinge {
namespace {

std::size_t cell_line(double coordinate, std::size_t lines) {
  const double place = std::max(0.5 * (coordinate + 1.0) * static_cast<double>(lines), 0.0);
  return std::min(static_cast<std::size_t>(place), lines - 1);
}

// How many bits of the two coordinates a level has; b is halved first.
struct CellBits {
  explicit CellBits(std::size_t level) : a(3 * level / 2), b(3 * level - a) {}
  std::size_t a;
  std::size_t b;
};

}  // namespace

std::size_t cell_of(const Vec3& axis, std::size_t level) {
  const CubePlace at = cube_place(axis);
  const CellBits bits(level);
  const std::size_t i = cell_line(at.a, std::size_t{1} << bits.a);
  const std::size_t j = cell_line(at.b, std::size_t{1} << bits.b);
  std::size_t cell = at.face;
  for (std::size_t k = 0; k < bits.b; ++k) {
    cell = 2 * cell + ((j >> (bits.b - 1 - k)) & 1U);
    if (k < bits.a) cell = 2 * cell + ((i >> (bits.a - 1 - k)) & 1U);
  }
  return cell;
}

std::array<Vec3, 4> cell_corners(const CubeCell& cell) {
  const CellBits bits(cell.level);
  std::size_t i = 0;
  std::size_t j = 0;
  for (std::size_t k = 0, bit = 3 * cell.level; k < bits.b; ++k) {
    j = 2 * j + ((cell.prefix >> --bit) & 1U);
    if (k < bits.a) i = 2 * i + ((cell.prefix >> --bit) & 1U);
  }
  const std::size_t face = cell.prefix >> (3 * cell.level);
  const double a = 2.0 / static_cast<double>(std::size_t{1} << bits.a);
  const double b = 2.0 / static_cast<double>(std::size_t{1} << bits.b);
  const auto at = [&](std::size_t k, std::size_t l) {
    return cube_point(face, -1.0 + a * static_cast<double>(k), -1.0 + b * static_cast<double>(l));
  };
  return {at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)};
}

}  // namespace impinge
