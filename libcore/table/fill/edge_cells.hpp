// SPDX-License-Identifier: GPL-3.0-or-later
// Which cells of a cube map an edge runs through, without trigonometry and without search.
//
// A face of the cube sees an edge as a straight line on its grid, along which 1 / depth is affine. With s
// from 0 to 1 the line is at column i where x_0 + s (x_1 - x_0) = i, and likewise for rows, so that the cells
// come one after the other. Between two ends in front of the same face all of the edge is in front of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "table/fill/cube_view.hpp"

namespace impinge {

/// The stretch of an edge in a cell. Places are in the frame of the face: depth, and the two others.
struct EdgeCell {
  std::size_t column = 0;  // of the cells of the face, below n
  std::size_t row = 0;
  Vec3 first;  // where the edge enters it, or begins, mm
  Vec3 last;   // where it leaves it, or ends, mm
};

/// Columns, or rows, that a line crosses from `from` to `to` cells.
class LineSteps {
 public:
  /// Both within the grid, up to rounding.
  LineSteps(double from, double to, std::size_t divisions)
      : from_(from), per_cell_(1.0 / (to - from)), at_(cell_of(from, divisions)) {
    const std::size_t last = cell_of(to, divisions);
    forward_ = last > at_;
    left_ = forward_ ? last - at_ : at_ - last;
  }

  std::size_t at() const { return at_; }  // the column or row where the line is
  /// s of the next step; infinite behind the last one.
  double next() const {
    if (left_ == 0) return std::numeric_limits<double>::infinity();
    return (static_cast<double>(forward_ ? at_ + 1 : at_) - from_) * per_cell_;
  }
  /// Takes that step.
  void take() {
    at_ = forward_ ? at_ + 1 : at_ - 1;
    --left_;
  }

 private:
  static std::size_t cell_of(double place, std::size_t divisions) {
    return std::min(static_cast<std::size_t>(std::max(place, 0.0)), divisions - 1);
  }

  double from_;
  double per_cell_;
  std::size_t at_;
  std::size_t left_ = 0;
  bool forward_ = true;
};

/// Calls visit(EdgeCell) once for each cell of the face that the line from `from` to `to` is in, in order;
/// both are seen through that face of a cube with so many divisions. Rounding may leave out or add a cell in
/// which the line is no longer than 2^-48 n cells.
template <class Visit>
void for_each_cell_of_line(const SeenCorner& from, const SeenCorner& to, std::size_t divisions,
                           Visit&& visit) {
  const double spacing = 2.0 / static_cast<double>(divisions);
  LineSteps columns(from.x, to.x, divisions);
  LineSteps rows(from.y, to.y, divisions);
  const auto at = [&](double s) -> Vec3 {
    const Vec3 on_cube(1.0, (from.x + s * (to.x - from.x)) * spacing - 1.0,
                       (from.y + s * (to.y - from.y)) * spacing - 1.0);
    return on_cube / (from.q + s * (to.q - from.q));
  };
  for (Vec3 first = at(0.0);;) {
    const double column = columns.next();
    const double row = rows.next();
    const double s = std::min({column, row, 1.0});
    const Vec3 last = at(s);
    visit(EdgeCell{columns.at(), rows.at(), first, last});
    if (std::min(column, row) == std::numeric_limits<double>::infinity()) return;
    (column <= row ? columns : rows).take();
    first = last;
  }
}

}  // namespace impinge
