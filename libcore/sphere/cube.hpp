// SPDX-License-Identifier: GPL-3.0-or-later
// Cube maps: the sphere seen through the six faces of the cube [-1, 1]^3, each a grid of (n + 1)^2 entries.
//
// Entry (i, j) of a face stands at its place (a_i, a_j) (sphere/cube_faces.hpp), where a_k = warp(-1 + 2 k /
// n). A look-up is bilinear in the unwarped coordinates. Whatever the warp, grid lines are great circles and
// cells are rectangles in (a, b), so that plane_stencil() is bilinear there. Entries on the edges of the cube
// are repeated on each face, bit for bit, so that no look-up crosses a seam: of 6 (n + 1)^2 entries 6 n^2 + 2
// differ.
//
// Precision is 90 / n degrees: 4 n entries stand round the equator.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "sphere/cube_faces.hpp"
#include "sphere/direction.hpp"
#include "sphere/equator_division.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

/// A warp says what makes one cube map differ from another:
///   name, label, citation   of the scheme (sphere/scheme.hpp)
///   node(t)          a for t in [-1, 1]; odd, with node(1) == 1 exactly
///   coordinate(a)    inverse of node()
///   kLongestWay      the longest way between two points of a cell along straight lines of t, over 2 / n; rad
/// Its widest cell must be the one at the middle of the face. With an overload of line_motion()
/// (table/patches/cube_patches.hpp) the bound on a table's error is tight; without one it is of first order.
template <class Warp>
class CubeMap {
 public:
  static constexpr std::string_view name = Warp::name;
  static constexpr std::string_view label = Warp::label;
  static constexpr std::string_view citation = Warp::citation;
  static constexpr bool kFlatCells = true;

  class Walker;

  CubeMap() = default;
  static CubeMap with_precision(double degrees) { return CubeMap(equator_division(degrees, 90.0, label)); }

  std::size_t divisions() const { return n_; }  // n
  std::size_t size() const { return 6 * (n_ + 1) * (n_ + 1); }
  std::size_t cells() const { return 6 * n_ * n_; }
  std::size_t equator_points() const { return 4 * n_; }
  double precision_deg() const { return 90.0 / static_cast<double>(n_); }

  Vec3 direction(std::size_t entry) const {
    const std::size_t row = entry / (n_ + 1);
    const double a = node(entry % (n_ + 1));
    const double b = node(row % (n_ + 1));
    return cube_point(row / (n_ + 1), a, b, shrink(a, b));
  }

  Stencil stencil(const Vec3& x) const {
    return bilinear(x, [this](double a) { return place(a); });
  }

  double depth(const Vec3& x) const { return x.cwiseAbs().maxCoeff(); }
  Stencil plane_stencil(const Vec3& x) const {
    return bilinear(x, [this](double a) { return flat_place(a); });
  }

  double covering_radius() const;

  double stencil_radius() const { return Warp::kLongestWay * 2.0 / static_cast<double>(n_); }

  Walker walker() const { return Walker(*this); }

  friend bool operator==(const CubeMap&, const CubeMap&) = default;

 private:
  /// The grid line below a coordinate, and how far into the cell the coordinate is, from 0 to 1.
  struct Place {
    std::size_t line;
    double share;
  };

  explicit CubeMap(std::size_t n) : n_(n) {}

  double grid_position(double a) const { return (Warp::coordinate(a) + 1.0) * 0.5 * static_cast<double>(n_); }

  Place place(double a) const {
    const double position = std::max(grid_position(a), 0.0);
    const std::size_t line = std::min(static_cast<std::size_t>(position), n_ - 1);
    return {line, std::min(position - static_cast<double>(line), 1.0)};
  }

  /// The same line, with the share on the flat face.
  Place flat_place(double a) const {
    const std::size_t line = place(a).line;
    const double from = node(line);
    return {line, std::clamp((a - from) / (node(line + 1) - from), 0.0, 1.0)};
  }

  template <class PlaceOf>
  Stencil bilinear(const Vec3& x, PlaceOf&& place_of) const {
    const CubePlace at = cube_place(x);
    const auto [i, a] = place_of(at.a);
    const auto [j, b] = place_of(at.b);
    const std::size_t low = (at.face * (n_ + 1) + j) * (n_ + 1) + i;
    const std::size_t high = low + n_ + 1;
    return {{low, low + 1, high, high + 1},
            {(1.0 - a) * (1.0 - b), a * (1.0 - b), (1.0 - a) * b, a * b},
            4,
            (at.face * n_ + j) * n_ + i};
  }

  /// Coordinate of grid line k. As the fraction is one of whole numbers, the grid is symmetric bit for bit.
  double node(std::size_t k) const {
    return Warp::node((2.0 * static_cast<double>(k) - static_cast<double>(n_)) / static_cast<double>(n_));
  }

  /// 1 / |(1, a, b)|, the same for (1, b, a) and, on an edge of the cube, for both of its faces.
  static double shrink(double a, double b) { return 1.0 / std::sqrt(1.0 + (a * a + b * b)); }

  std::size_t n_ = 90;
};

/// Circumradius of the widest cell. For odd n it has the corners (+-t, +-t) round the middle of a face. For
/// even n a corner is in the middle, and (t, t) lies within the circle through (0, 0), (t, 0), (0, t), so
/// that the Delaunay triangle is (0, 0), (t, 0), (t, t), with the centre at (t / (1 + s), t / (s + r)).
template <class Warp>
double CubeMap<Warp>::covering_radius() const {
  const double t = node(n_ / 2 + 1);
  if (n_ % 2 != 0) return std::atan(std::sqrt(2.0) * t);
  const double s = std::sqrt(1.0 + t * t);
  const double r = std::sqrt(1.0 + 2.0 * t * t);
  return std::atan(t * std::hypot(1.0 / (1.0 + s), 1.0 / (s + r)));
}

/// Computes the coordinate of each grid line once, for all triangles.
template <class Warp>
class CubeMap<Warp>::Walker {
 public:
  /// Computes the coordinates of all grid lines.
  explicit Walker(const CubeMap& scheme) : scheme_(scheme), node_(scheme.n_ + 1) {
    for (std::size_t k = 0; k < node_.size(); ++k) node_[k] = scheme.node(k);
  }

  template <class Visit>
  void visit_near(const TriangleCone& cone, double margin, Visit&& visit) const {
    const Spread spread(margin);
    const ConePolygon triangle(cone);
    for (std::size_t face = 0; face < 6; ++face) {
      const auto [columns, rows] = window(triangle, face, spread);
      for (std::size_t j = rows.first; j < rows.end; ++j) visit_row(face, j, columns, visit);
    }
  }

 private:
  static constexpr double kRounding = 1e-10;     // rad, far above the rounding of clipping
  static constexpr double kSlack = 1e-6;         // of a spacing
  static constexpr double kLargestMargin = 0.5;  // rad; beyond it every entry is near

  /// Grid lines first, first + 1, ... end - 1.
  struct Lines {
    std::size_t first;
    std::size_t end;
  };
  struct Window {
    Lines columns;
    Lines rows;
  };

  /// How far a margin reaches on a face. A point of the face is at least 45 degrees from the axes across, so
  /// that a cap of radius `margin` round it spans asin(sqrt(2) sin margin) about such an axis, either way.
  struct Spread {
    explicit Spread(double margin) : all(margin > kLargestMargin) {
      const double y = std::sqrt(2.0) * std::sin(margin + kRounding);
      tangent = all ? 0.0 : y / std::sqrt(1.0 - y * y);
    }
    double pyramid() const { return (1.0 + tangent) / (1.0 - tangent); }  // tan(45 degrees + spread)
    double above(double a) const {
      return 1.0 - a * tangent <= 0.0 ? 1.0 : (a + tangent) / (1.0 - a * tangent);
    }
    bool all;
    double tangent;
  };

  Lines lines(double from, double to) const {
    const double first = std::ceil(scheme_.grid_position(std::clamp(from, -1.0, 1.0)) - kSlack);
    const double last = std::floor(scheme_.grid_position(std::clamp(to, -1.0, 1.0)) + kSlack);
    return {static_cast<std::size_t>(std::max(first, 0.0)),
            std::min(static_cast<std::size_t>(std::max(last, -1.0) + 1.0), node_.size())};
  }

  /// The grid lines of a face on which entries within the margin of a triangle can be.
  Window window(const ConePolygon& triangle, std::size_t face, const Spread& spread) const {
    const Window everything{{0, node_.size()}, {0, node_.size()}};
    if (spread.all) return everything;
    const CubeOutline outline(triangle, face, spread.pyramid());
    if (outline.everything()) return everything;
    if (outline.corners().empty()) return {{0, 0}, {0, 0}};
    double a_low = HUGE_VAL, a_high = -HUGE_VAL, b_low = HUGE_VAL, b_high = -HUGE_VAL;
    for (const auto& [a, b] : outline.corners()) {
      a_low = std::min(a_low, a);
      a_high = std::max(a_high, a);
      b_low = std::min(b_low, b);
      b_high = std::max(b_high, b);
    }
    return {lines(-spread.above(-a_low), spread.above(a_high)),
            lines(-spread.above(-b_low), spread.above(b_high))};
  }

  template <class Visit>
  void visit_row(std::size_t face, std::size_t j, const Lines& columns, Visit&& visit) const {
    DirectionRun run;
    const CubeAxes& axes = cube_axes(face);
    const std::array<double*, 3> coordinate{run.x.data(), run.y.data(), run.z.data()};
    double* const along_depth = coordinate[static_cast<std::size_t>(axes.depth)];
    double* const along_a = coordinate[static_cast<std::size_t>(axes.a)];
    double* const along_b = coordinate[static_cast<std::size_t>(axes.b)];
    const double b = node_[j];
    for (std::size_t i = columns.first; i < columns.end; i += run.count) {
      run.first = (face * node_.size() + j) * node_.size() + i;
      run.count = std::min(columns.end - i, DirectionRun::kMost);
      for (std::size_t k = 0; k < run.count; ++k) {
        const double a = node_[i + k];
        const double s = shrink(a, b);
        along_depth[k] = cube_sign(face) * s;
        along_a[k] = s * a;
        along_b[k] = s * b;
      }
      visit(static_cast<const DirectionRun&>(run));
    }
  }

  CubeMap scheme_;
  std::vector<double> node_;
};

}  // namespace impinge
