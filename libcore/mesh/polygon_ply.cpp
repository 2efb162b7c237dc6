// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/polygon_ply.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "mesh/ply_bytes.hpp"

namespace impinge {

void PolygonPly::add_points(std::span<const double> xyz) {
  for (const double x : xyz) append_value(points_, x);
  first_ = point_count_;
  point_count_ += xyz.size() / 3;
}

bool PolygonPly::add_cells(std::span<const double> corners, std::span<const double> ends, bool strips) {
  std::size_t begin = 0;
  for (const double end : ends) {
    if (!(end >= static_cast<double>(begin) && end <= static_cast<double>(corners.size()))) return false;
    const auto cell = corners.subspan(begin, static_cast<std::size_t>(end) - begin);
    if (strips)
      add_strip(cell);
    else if (cell.size() >= 3)
      add_polygon(cell);
    begin += cell.size();
  }
  return begin == corners.size();
}

std::string PolygonPly::bytes() const {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(point_count_) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(polygon_count_) + "\nproperty list uint uint vertex_indices\nend_header\n" + points_ +
         polygons_;
}

void PolygonPly::add_polygon(std::span<const double> corners) {
  constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
  const auto points = static_cast<double>(point_count_ - first_);
  append_bits(polygons_, static_cast<std::uint32_t>(corners.size()));
  for (const double v : corners) {
    const bool there = v >= 0.0 && v < points && v == std::floor(v);
    append_bits(polygons_, there ? static_cast<std::uint32_t>(first_ + static_cast<std::size_t>(v)) : kNone);
  }
  ++polygon_count_;
}

// Every second triangle is turned round, so that all look to one side.
void PolygonPly::add_strip(std::span<const double> corners) {
  for (std::size_t k = 0; k + 2 < corners.size(); ++k) {
    const std::size_t odd = k % 2;
    add_polygon(std::array{corners[k + odd], corners[k + 1 - odd], corners[k + 2]});
  }
}

}  // namespace impinge
