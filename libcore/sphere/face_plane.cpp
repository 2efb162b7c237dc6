// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/face_plane.hpp"

#include <utility>

#include "sphere/expansion.hpp"

namespace impinge {
namespace {

// Component i of a x b + b x c + c x a = (b - a) x (c - a).
double normal_component(const Vec3& a, const Vec3& b, const Vec3& c, int i) {
  const int j = (i + 1) % 3;
  const int k = (i + 2) % 3;
  Expansion<12> sum;  // 6 products of 2 values each
  for (const auto& [from, to] : {std::pair{&a, &b}, {&b, &c}, {&c, &a}}) {
    add_product(sum, (*from)[j], (*to)[k]);
    add_product(sum, -(*from)[k], (*to)[j]);
  }
  return sum.value();
}

}  // namespace

FacePlane exact_face_plane(const Vec3& a, const Vec3& b, const Vec3& c, int side) {
  FacePlane plane{};
  for (int i = 0; i < 3; ++i) plane.normal[i] = side * normal_component(a, b, c, i);
  Expansion<24> det;
  add_determinant(det, side, a, b, c);
  plane.offset = det.value();
  plane.size = plane.normal.norm();
  plane.exact = true;
  return plane;
}

}  // namespace impinge
