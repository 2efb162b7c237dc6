// SPDX-License-Identifier: GPL-3.0-or-later
// Where a direction is on the faces of a cube, as sphere/cube.hpp numbers them.
#pragma once

#include <cmath>
#include <cstddef>

#include "sphere/direction.hpp"

namespace impinge {

/// Face and gnomonic coordinates, -1 <= a, b <= 1 but for rounding. depth is 0 at the centre alone, where
/// there is no direction.
struct CubePlace {
  std::size_t face;  // 0 to 5, as the faces of CubeMap
  double a;          // the first of the other two coordinates, in the order x, y, z, over depth
  double b;          // the second of them over depth
  double depth;      // largest coordinate in size, in the unit of the point
};

/// Of the face that the direction of x passes through.
inline CubePlace cube_place(const Vec3& x) {
  const Vec3 size = x.cwiseAbs();
  if (size.x() >= size.y() && size.x() >= size.z())
    return {x.x() < 0.0 ? 1U : 0U, x.y() / size.x(), x.z() / size.x(), size.x()};
  if (size.y() >= size.z()) return {x.y() < 0.0 ? 3U : 2U, x.x() / size.y(), x.z() / size.y(), size.y()};
  return {x.z() < 0.0 ? 5U : 4U, x.x() / size.z(), x.y() / size.z(), size.z()};
}

/// A point in that direction; its largest coordinate is 1.
inline Vec3 cube_point(std::size_t face, double a, double b) {
  const double depth = face % 2 == 0 ? 1.0 : -1.0;
  return face < 2 ? Vec3(depth, a, b) : face < 4 ? Vec3(a, depth, b) : Vec3(a, b, depth);
}

}  // namespace impinge
