// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/hit_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "sphere/cube_faces.hpp"

namespace impinge {
namespace {

constexpr double kWiden = 1e-6;  // share of a face of the cube, for places that rounding moves over its edge

// A point of a face of the cube, in cells from its corner.
struct GridPoint {
  double a;
  double b;
};

// The part of a cone that one face of the cube sees.
struct Outline {
  std::array<GridPoint, ConePolygon::kMostCorners> corner{};
  std::size_t count = 0;
  bool everything = false;
};

Outline outline_on(std::size_t face, const ConePolygon& polygon, double divisions) {
  const CubeOutline seen(polygon, face, 1.0 + kWiden);
  Outline outline;
  outline.everything = seen.everything();
  for (const auto& [a, b] : seen.corners())
    outline.corner[outline.count++] = {0.5 * divisions * (a + 1.0), 0.5 * divisions * (b + 1.0)};
  return outline;
}

struct Span {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// The range of a over the points of the outline with b in [low, high].
Span along_row(const Outline& outline, double low, double high) {
  Span span;
  for (std::size_t k = 0; k < outline.count; ++k) {
    const GridPoint& from = outline.corner[k];
    const GridPoint& to = outline.corner[k + 1 == outline.count ? 0 : k + 1];
    if (from.b >= low && from.b <= high) span.take(from.a);
    for (const double line : {low, high}) {
      if ((from.b < line) == (to.b < line)) continue;
      const double share = std::clamp((line - from.b) / (to.b - from.b), 0.0, 1.0);
      span.take(from.a + share * (to.a - from.a));
    }
  }
  return span;
}

// The cells of a span, first to last; none if first > last.
struct Cells {
  std::ptrdiff_t first;
  std::ptrdiff_t last;
};
Cells cells_of(const Span& span, const CellGrid& grid) {
  const auto end = static_cast<double>(grid.divisions) - 1.0;
  if (!(span.low <= span.high)) return {0, -1};
  return {static_cast<std::ptrdiff_t>(std::clamp(std::floor(span.low - grid.margin), 0.0, end)),
          static_cast<std::ptrdiff_t>(std::clamp(std::floor(span.high + grid.margin), 0.0, end))};
}

}  // namespace

void add_hit_cells(const CellGrid& grid, const TriangleCone& cone, std::vector<std::uint32_t>& cells) {
  const auto n = static_cast<double>(grid.divisions);
  const ConePolygon triangle(cone);
  for (std::size_t face = 0; face < 6; ++face) {
    const Outline outline = outline_on(face, triangle, n);
    Span rows;
    for (std::size_t k = 0; k < outline.count; ++k) rows.take(outline.corner[k].b);
    if (outline.everything) rows = {0.0, n};
    const auto [first_row, last_row] = cells_of(rows, grid);
    for (std::ptrdiff_t row = first_row; row <= last_row; ++row) {
      const auto b = static_cast<double>(row);
      const Span span =
          outline.everything ? Span{0.0, n} : along_row(outline, b - grid.margin, b + 1.0 + grid.margin);
      const auto [first, last] = cells_of(span, grid);
      const std::size_t start =
          (face * (grid.divisions + 1) + static_cast<std::size_t>(row)) * (grid.divisions + 1);
      for (std::ptrdiff_t column = first; column <= last; ++column)
        cells.push_back(static_cast<std::uint32_t>(start + static_cast<std::size_t>(column)));
    }
  }
}

Lists faces_of_cells(const TriangleMesh& mesh, std::span<const std::uint32_t> faces, const CellGrid& grid) {
  std::vector<std::uint32_t> cells;
  std::vector<Lists::Pair> pairs;
  for (const std::uint32_t f : faces) {
    cells.clear();
    add_hit_cells(grid, cone_of(mesh, mesh.faces[f]), cells);
    for (const std::uint32_t cell : cells) pairs.push_back({cell, f});
  }
  const std::size_t lines = grid.divisions + 1;
  return Lists(6 * lines * lines, pairs);
}

}  // namespace impinge
