// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the points and polygons of a VTK file as a plain PLY file.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace impinge {

class PolygonPly {
 public:
  /// Adds points, as x, y, z of each in turn, mm. Cells that are added later count from the first of these.
  void add_points(std::span<const double> xyz);

  /// Adds polygons or strips of triangles: the corners of all, and where the corners of each end. Cells of
  /// less than three corners are left out. Returns false unless the ends grow up to the number of corners. An
  /// index that names no point becomes one that no PLY file may have.
  bool add_cells(std::span<const double> corners, std::span<const double> ends, bool strips);

  /// The PLY file, binary, with doubles.
  std::string bytes() const;

 private:
  void add_polygon(std::span<const double> corners);
  void add_strip(std::span<const double> corners);

  std::string points_;
  std::string polygons_;
  std::size_t point_count_ = 0;
  std::size_t first_ = 0;  // point from which cells count
  std::size_t polygon_count_ = 0;
};

}  // namespace impinge
