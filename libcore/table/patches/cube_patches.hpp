// SPDX-License-Identifier: GPL-3.0-or-later
// Patches of cube maps: s and t are the coordinates of a face in which the grid is regular; `part` is the
// face.
//
// For fixed b the direction of (1, a, b) runs along a great circle, with the angle atan(a / sqrt(B)), B = 1 +
// b^2:
//   gnomonic, s = a:        way' = sqrt(B) / (B + a^2),  way'' = -2 a sqrt(B) / (B + a^2)^2
//   equi-angular, a = tan(x): way' = sqrt(B) / (1 + b^2 cos^2 x),
//                           way'' = sqrt(B) b^2 sin(2 x) / (1 + b^2 cos^2 x)^2
// For fixed a, exchange a and b.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

#include "sphere/cube.hpp"
#include "sphere/schemes/cube_equiangular.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "table/patches/patch.hpp"

namespace impinge {

/// Least and largest absolute value of an interval.
struct Magnitude {
  /// `from` must not be above `to`.
  Magnitude(double from, double to)
      : least(from <= 0.0 && to >= 0.0 ? 0.0 : std::min(std::abs(from), std::abs(to))),
        most(std::max(std::abs(from), std::abs(to))) {}
  double least;  // of the absolute values
  double most;
};

/// Upper bounds on the first and second derivative of the way along a line by its coordinate.
struct LineMotion {
  double way;   // radians a unit of the coordinate
  double turn;  // radians a unit squared
};
/// Along s = a, where t = b.
inline LineMotion line_motion(GnomonicCubeWarp, const Magnitude& a, const Magnitude& b) {
  const double most = std::sqrt(1.0 + b.most * b.most);
  const double least = 1.0 + b.least * b.least + a.least * a.least;
  // sqrt(B) / (B + a^2) falls with b above its largest, at B = a^2 <= 1: everywhere.
  return {std::sqrt(1.0 + b.least * b.least) / least, 2.0 * a.most * most / (least * least)};
}
/// Along s, where a = tan(pi / 4 s) and b = tan(pi / 4 t).
inline LineMotion line_motion(EquiangularCubeWarp, const Magnitude& s, const Magnitude& t) {
  const double quarter = 0.25 * kPi;
  const double b_least = std::tan(quarter * t.least);
  const double b_most = std::tan(quarter * t.most);
  const double cosine = std::cos(quarter * s.most);
  const double root = std::sqrt(1.0 + b_most * b_most);
  const double least = 1.0 + b_least * b_least * cosine * cosine;
  return {quarter * root / least,
          quarter * quarter * root * b_most * b_most * std::sin(2.0 * quarter * s.most) / (least * least)};
}

/// A warp with a line_motion(). A cube map with another warp declares no patches.
template <class Warp>
concept HasLineMotion = requires(const Magnitude& size) {
  { line_motion(Warp{}, size, size) } -> std::same_as<LineMotion>;
};

template <HasLineMotion Warp>
class CubePatches {
 public:
  /// Coordinates of the grid lines, from -1 to 1.
  explicit CubePatches(std::vector<double> lines) : lines_(std::move(lines)) {}

  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t face = 0; face < 6; ++face) {
      for (std::size_t j = 0; j + 1 < lines_.size(); ++j) {
        for (std::size_t i = 0; i + 1 < lines_.size(); ++i)
          visit(Patch{face, {{lines_[i], lines_[j]}, {lines_[i + 1], lines_[j + 1]}}});
      }
    }
  }

  /// A point of the cube.
  Vec3 at(const Patch& patch, double s, double t) const {
    const std::size_t axis = patch.part / 2;
    Vec3 x;
    x[static_cast<Eigen::Index>(axis)] = patch.part % 2 == 0 ? 1.0 : -1.0;
    x[axis == 0 ? 1 : 0] = Warp::node(s);
    x[axis == 2 ? 1 : 2] = Warp::node(t);
    return x;
  }

  PatchMotion motion(const Patch&, const Rect& rect) const {
    const std::array<Magnitude, 2> size{Magnitude(rect.from[0], rect.to[0]),
                                        Magnitude(rect.from[1], rect.to[1])};
    PatchMotion motion;
    for (std::size_t k = 0; k < 2; ++k) {
      const LineMotion line = line_motion(Warp{}, size[k], size[1 - k]);
      motion.way[k] = rect.width(k) * line.way;
      motion.turn[k] = rect.width(k) * rect.width(k) * line.turn;
    }
    return motion;
  }

 private:
  std::vector<double> lines_;
};

template <HasLineMotion Warp>
CubePatches<Warp> patches_of(const CubeMap<Warp>& scheme) {
  std::vector<double> lines;
  const auto n = static_cast<double>(scheme.divisions());
  for (std::size_t k = 0; k <= scheme.divisions(); ++k)
    lines.push_back((2.0 * static_cast<double>(k) - n) / n);
  return CubePatches<Warp>(std::move(lines));
}

}  // namespace impinge
