// SPDX-License-Identifier: GPL-3.0-or-later
// The points and polygons of a file of VTK, written again as a plain PLY file.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace impinge {

class PolygonPly {
 public:
  /// x, y, z of each point in turn, mm. Cells that follow count from the first of these.
  void add_points(std::span<const double> xyz);

  /// Polygons, or strips of triangles: the corners of all, and where those of each end. What has less than
  /// three corners is left out. False unless the ends grow up to the number of corners. An index that is no
  /// place among the points becomes one that no PLY file may have.
  bool add_cells(std::span<const double> corners, std::span<const double> ends, bool strips);

  /// Binary, with doubles.
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
