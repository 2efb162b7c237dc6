// SPDX-License-Identifier: GPL-3.0-or-later
// Where a ray from the centre meets the plane of a face, for any kind of number: the kernel of every table.
// Tables use double. Tests run the same lines in float, long double and 200 bits, to show that the numbers
// alone limit the precision (tests/stress/precision_levels_test.cpp).
#pragma once

#include <Eigen/Geometry>

namespace impinge {

/// A vector of any kind of number, mm.
template <class Number>
using Vec3Of = Eigen::Matrix<Number, 3, 1>;

/// side * (b - a) x (c - a): its length is twice the area of the face. It points away from the centre if
/// `side` is the orientation of the corners, +1 or -1.
template <class Number>
Vec3Of<Number> face_normal(const Vec3Of<Number>& a, const Vec3Of<Number>& b, const Vec3Of<Number>& c,
                           int side) {
  return Number(side) * (b - a).cross(c - a);
}

/// r = n.v0 / (n.u) in lengths of u, for offset = n.v0 above zero. Never above `largest`, the distance of the
/// farthest corner: this matters only if u grazes the face and n.u is rounding noise.
template <class Number>
Number plane_radius(const Vec3Of<Number>& normal, const Number& offset, const Number& largest,
                    const Vec3Of<Number>& u) {
  const Number along = normal.dot(u);
  const Number least = offset / largest;
  return offset / (along < least ? least : along);
}

}  // namespace impinge
