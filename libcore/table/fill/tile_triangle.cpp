// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/fill/tile_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace impinge {
namespace {

// Twice that of a face on the grid, above zero where the corners go round from x to y.
struct SeenArea {
  double value;
  bool certain;  // are its sign, and what is divided by it?
};

SeenArea area_of(const SeenCorner& a, const SeenCorner& b, const SeenCorner& c, std::size_t divisions) {
  const double part = (b.x - a.x) * (c.y - a.y);
  const double other = (c.x - a.x) * (b.y - a.y);
  const double area = part - other;
  const double extent = std::max(std::max(a.x, b.x), c.x) - std::min(std::min(a.x, b.x), c.x) +
                        std::max(std::max(a.y, b.y), c.y) - std::min(std::min(a.y, b.y), c.y);
  const double error = place_error(divisions);
  return {area, std::abs(area) * kMostThin > std::abs(part) + std::abs(other) &&
                    std::abs(area) > 16.0 * error * (extent + error)};
}

double least_q(const SeenFace& seen) {
  return std::min({seen.corners[0].q, seen.corners[1].q, seen.corners[2].q});
}

double most_q(const SeenFace& seen) {
  return std::max({seen.corners[0].q, seen.corners[1].q, seen.corners[2].q});
}

double q_at(const SeenFace& seen, const SeenPlane& plane, double x, double y) {
  const SeenCorner& from = seen.corners[0];
  return from.q + plane.q_x * (x - from.x) + plane.q_y * (y - from.y);
}

}  // namespace

SeenPlane plane_of(const SeenFace& seen, std::size_t divisions) {
  const auto& [a, b, c] = seen.corners;
  const SeenArea area = area_of(a, b, c, divisions);
  if (!seen.projected || !area.certain) return {};
  const double x1 = b.x - a.x, y1 = b.y - a.y, q1 = b.q - a.q;
  const double x2 = c.x - a.x, y2 = c.y - a.y, q2 = c.q - a.q;
  return {(q1 * y2 - q2 * y1) / area.value, (x1 * q2 - x2 * q1) / area.value, area.value > 0.0 ? 1.0 : -1.0,
          true};
}

std::int8_t side_of(const std::array<const SeenCorner*, 3>& corners, std::size_t divisions) {
  constexpr std::array<std::int8_t, 6> kWayRound{1, -1, -1, 1, 1, -1};  // of x and y beside the depth
  const auto [a, b, c] = corners;
  const SeenArea area = area_of(*a, *b, *c, divisions);
  if (!area.certain) return 0;
  const std::int8_t way = kWayRound[a->face];
  return area.value > 0.0 ? way : static_cast<std::int8_t>(-way);
}

GridWindow window_in(const CubeTile& tile, const GridWindow& window) {
  const auto last = [](std::size_t first, std::size_t seen) { return static_cast<long>(first + seen) - 1; };
  return {std::max(window.first_column, static_cast<long>(tile.first_column)),
          std::min(window.last_column, last(tile.first_column, tile.seen_columns)),
          std::max(window.first_row, static_cast<long>(tile.first_row)),
          std::min(window.last_row, last(tile.first_row, tile.seen_rows))};
}

DepthRange range_of(const SeenFace& seen, const SeenPlane& plane) {
  DepthRange range{least_q(seen), most_q(seen)};
  if (plane.clear) {  // beyond the edges of the cube the plane goes on: see how far it gets in the window
    DepthRange box{std::numeric_limits<double>::infinity(), 0.0};
    for (const long i : {seen.window.first_column, seen.window.last_column}) {
      for (const long j : {seen.window.first_row, seen.window.last_row}) {
        const double q = q_at(seen, plane, static_cast<double>(i), static_cast<double>(j));
        box = {std::min(box.least, q), std::max(box.most, q)};
      }
    }
    range = {std::max(range.least, box.least), std::min(range.most, box.most)};
  }
  return range;
}

}  // namespace impinge
