// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/orientation.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "sphere/expansion.hpp"

namespace impinge {
namespace {

// The vector scaled by a power of two, so that its largest component is in [1/2, 1).
Vec3 scaled(const Vec3& v) {
  int exponent = 0;
  std::frexp(v.cwiseAbs().maxCoeff(), &exponent);
  return {std::ldexp(v.x(), -exponent), std::ldexp(v.y(), -exponent), std::ldexp(v.z(), -exponent)};
}

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c) {
  Expansion<24> det;
  add_determinant(det, 1.0, a, b, c);
  return det.sign();
}

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c) {
  // 1-norms are cheaper than lengths and no smaller. Numbers out of range go on to the exact sign.
  const double det = a.dot(b.cross(c));
  const double product = b.lpNorm<1>() * c.lpNorm<1>();
  const double doubt = kPlaneTestError * a.lpNorm<1>() * product;
  if (product > kSmallestProduct && doubt > kSmallestProduct && std::abs(det) > doubt &&
      std::abs(det) < kLargestProduct)
    return det > 0.0 ? 1 : -1;
  if (a == b || b == c || c == a) return 0;  // a shared corner, the commonest zero
  return exact_orientation(scaled(a), scaled(b), scaled(c));
}

}  // namespace impinge
