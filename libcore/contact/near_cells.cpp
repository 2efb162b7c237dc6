// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/near_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "contact/triangle_halves.hpp"
#include "mesh/triangle_distance.hpp"
#include "sphere/vector_clones.hpp"

namespace impinge {
namespace {

constexpr double kCellsOfFace = 32.0;  // most cells for each face; more do not pay
constexpr double kPiecesOfCell = 1.0;  // most pieces of faces to mark, for each cell
constexpr double kMostAlong = 1000.0;  // most cells along an axis
constexpr double kLeastSize = 1e-30;   // mm; down to it floats lose no digits
constexpr double kCellSlack = 1e-3;    // share of a cell, more than the rounding of corners and halves
constexpr int kFarthest = NearCells::kReach * NearCells::kReach;

// The least size that keeps the numbers of cells and pieces within bounds.
double cell_size(const FaceRuns& surface, const Vec3& extent) {
  double area = 0.0;
  double edges = 0.0;
  for (const Face& f : surface.faces) {
    const Vec3 ab = surface.vertices[f[1]] - surface.vertices[f[0]];
    const Vec3 ac = surface.vertices[f[2]] - surface.vertices[f[0]];
    area += 0.5 * ab.cross(ac).norm();
    edges += ab.norm() + ac.norm();
  }
  double size = std::max(kLeastSize, extent.maxCoeff() / kMostAlong);
  const double most =
      std::min(NearCells::kMostCells, kCellsOfFace * static_cast<double>(128 + surface.faces.size()));
  const auto too_small = [&] {
    return (extent / size + Vec3::Constant(2.0)).prod() > most ||
           4.0 * area / (size * size) + edges / size > kPiecesOfCell * most;
  };
  while (too_small()) size *= 1.02;
  return size;
}

// Marks the cells of a triangle, given in units of the grid, in pieces at most two cells wide.
void mark(NearCells& grid, const Triangle& piece) {
  std::array<int, 3> from{};
  std::array<int, 3> to{};
  bool wide = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const auto [low, high] = std::minmax({piece[0][axis], piece[1][axis], piece[2][axis]});
    from[k] = std::max(0, static_cast<int>(std::floor(low - kCellSlack)));
    to[k] = std::min(grid.cells[k] - 1, static_cast<int>(std::floor(high + kCellSlack)));
    wide = wide || to[k] - from[k] > 1;
  }
  if (wide) {
    for (const Triangle& half : halves(piece)) mark(grid, half);
    return;
  }
  for (int z = from[2]; z <= to[2]; ++z) {
    for (int y = from[1]; y <= to[1]; ++y) {
      for (int x = from[0]; x <= to[0]; ++x) {
        const int place = (z * grid.cells[1] + y) * grid.cells[0] + x;
        grid.square[static_cast<std::size_t>(place)] = 0;
      }
    }
  }
}

// Replaces each row of squares by the least over i of row(at + i) + max(0, |i| - 1)^2; rows have `width`
// cells and are `stride` apart.
IMPINGE_VECTOR_CLONES void pass(std::uint8_t* rows, int count, std::size_t stride, std::size_t width,
                                std::vector<std::uint8_t>& scratch) {
  scratch.assign(width * static_cast<std::size_t>(count), kFarthest);
  for (int at = 0; at < count; ++at) {
    std::uint8_t* __restrict least = scratch.data() + static_cast<std::size_t>(at) * width;
    const int last = std::min(count - 1, at + NearCells::kReach);
    for (int other = std::max(0, at - NearCells::kReach); other <= last; ++other) {
      const int apart = std::max(0, std::abs(other - at) - 1);
      const auto more = static_cast<std::uint8_t>(apart * apart);
      const auto most = static_cast<std::uint8_t>(kFarthest - more);
      const std::uint8_t* __restrict row = rows + static_cast<std::size_t>(other) * stride;
      for (std::size_t x = 0; x < width; ++x) {
        const auto square = static_cast<std::uint8_t>(std::min(row[x], most) + more);
        least[x] = std::min(least[x], square);
      }
    }
  }
  for (std::size_t at = 0; at < static_cast<std::size_t>(count); ++at)
    std::copy_n(scratch.data() + at * width, width, rows + at * stride);
}

// The pass along a row of cells, which are 0 where marked.
void pass_along(std::uint8_t* row, int count, std::vector<int>& apart) {
  apart.assign(static_cast<std::size_t>(count), kFarthest);
  const auto sweep = [&](int from, int to, int step) {
    for (int x = from, last = kFarthest; x != to; x += step, ++last) {
      if (row[x] == 0) last = 0;
      int& least = apart[static_cast<std::size_t>(x)];
      least = std::min(least, last);
    }
  };
  sweep(0, count, 1);
  sweep(count - 1, -1, -1);
  for (int x = 0; x < count; ++x) {
    const int between = std::max(0, apart[static_cast<std::size_t>(x)] - 1);
    row[x] = static_cast<std::uint8_t>(std::min(kFarthest, between * between));
  }
}

}  // namespace

NearCells::NearCells(const FaceRuns& surface) {
  Vec3 low = surface.vertices.front();
  Vec3 high = low;
  for (const Vec3& x : surface.vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  size = cell_size(surface, high - low);
  origin = low - Vec3::Constant(0.01 * size);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    cells[k] = 1 + static_cast<int>((high[axis] - origin[axis]) / size + 0.01);
  }
  const auto [nx, ny, nz] = cells;
  const auto row = static_cast<std::size_t>(nx);
  const std::size_t layer = row * static_cast<std::size_t>(ny);
  square.assign(layer * static_cast<std::size_t>(nz), kFarthest);
  for (const Face& f : surface.faces) {
    const auto in_grid = [&](VertexIndex v) -> Vec3 { return (surface.vertices[v] - origin) / size; };
    mark(*this, {in_grid(f[0]), in_grid(f[1]), in_grid(f[2])});
  }
  const std::vector<std::uint8_t> marked = square;
  std::vector<int> apart;
  std::vector<std::uint8_t> scratch;
  for (std::size_t at = 0; at < square.size(); at += row) pass_along(square.data() + at, nx, apart);
  for (std::size_t at = 0; at < square.size(); at += layer) pass(square.data() + at, ny, row, row, scratch);
  pass(square.data(), nz, layer, layer, scratch);
  for (std::size_t at = 0; at < square.size(); ++at)
    square[at] = marked[at] == 0 ? 0 : static_cast<std::uint8_t>(square[at] + 1);
}

}  // namespace impinge
