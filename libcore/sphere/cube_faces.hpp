// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers the faces of the cube [-1, 1]^3 round the centre, and gives the place of a direction on them.
//
// Face 2 k looks along the k-th axis, face 2 k + 1 against it. The depth of a point is the size of its
// largest coordinate. The place (a, b) of its direction is its other two coordinates, in the order x, y, z,
// divided by the depth.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "sphere/cone_polygon.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// Which coordinates give depth, a and b on a face.
struct CubeAxes {
  Eigen::Index depth, a, b;
};
inline constexpr std::array<CubeAxes, 3> kCubeAxes{{{0, 1, 2}, {1, 0, 2}, {2, 0, 1}}};

/// The axes of a face.
constexpr const CubeAxes& cube_axes(std::size_t face) { return kCubeAxes[face / 2]; }
/// +1 for a face that looks along its axis, -1 against it.
constexpr double cube_sign(std::size_t face) { return face % 2 == 0 ? 1.0 : -1.0; }

/// The face that the direction of x passes through; face 0 for the centre.
inline std::size_t cube_face(const Vec3& x) {
  const Vec3 size = x.cwiseAbs();
  const std::size_t axis = size.x() >= size.y() && size.x() >= size.z() ? 0 : size.y() >= size.z() ? 1 : 2;
  return 2 * axis + (x[kCubeAxes[axis].depth] < 0.0 ? 1U : 0U);
}

/// The place of a direction: -1 <= a, b <= 1 but for rounding. `depth` has the unit of the point, and is 0 at
/// the centre alone, which has no direction.
struct CubePlace {
  std::size_t face;
  double a;
  double b;
  double depth;
};
inline CubePlace cube_place(const Vec3& x) {  // the place of the direction of x
  const std::size_t face = cube_face(x);
  const CubeAxes& axes = cube_axes(face);
  const double depth = std::abs(x[axes.depth]);
  return {face, x[axes.a] / depth, x[axes.b] / depth, depth};
}

/// The number of the entry nearest to the direction of x, on a grid of `cells` cells and `cells` + 1 entries
/// along each edge of each face. Entries are numbered by face, row and column.
inline std::size_t cube_entry(const Vec3& x, std::size_t cells) {
  const CubePlace at = cube_place(x);
  const auto line = [&](double place) {  // rounded; lround would be a call, and a third of the time
    return static_cast<std::size_t>(0.5 * ((place + 1.0) * static_cast<double>(cells) + 1.0));
  };
  return (at.face * (cells + 1) + line(at.b)) * (cells + 1) + line(at.a);
}

/// The point at (a, b) of a face, times `size`.
inline Vec3 cube_point(std::size_t face, double a, double b, double size = 1.0) {
  const CubeAxes& axes = cube_axes(face);
  Vec3 x;
  x[axes.depth] = cube_sign(face) * size;
  x[axes.a] = size * a;
  x[axes.b] = size * b;
  return x;
}

/// The part of a cone that one face of the cube sees, a convex polygon.
class CubeOutline {
 public:
  /// For a face that is made wider by the factor `widened`.
  CubeOutline(ConePolygon cone, std::size_t face, double widened) {
    const CubeAxes& axes = cube_axes(face);
    const double sign = cube_sign(face);
    for (const Eigen::Index axis : {axes.a, axes.b}) {
      for (const double side : {1.0, -1.0}) {
        Vec3 plane = Vec3::Zero();
        plane[axes.depth] = sign * widened;
        plane[axis] = side;
        cone.clip(plane);
        if (cone.empty()) return;
      }
    }
    for (const Vec3& x : cone.corners()) {
      const double depth = sign * x[axes.depth];
      everything_ = everything_ || !(depth > kLeastDepth);
      corner_[count_++] = {x[axes.a] / depth, x[axes.b] / depth};
    }
  }

  /// True if an edge of the triangle passes so close to the centre that corners are inaccurate: the triangle
  /// may be seen anywhere on the face.
  bool everything() const { return everything_; }
  std::span<const std::array<double, 2>> corners() const { return {corner_.data(), count_}; }  // (a, b)

 private:
  static constexpr double kLeastDepth = 1e-3;  // of a clipped corner, for its place to be accurate

  std::array<std::array<double, 2>, ConePolygon::kMostCorners> corner_;
  std::size_t count_ = 0;
  bool everything_ = false;
};

}  // namespace impinge
