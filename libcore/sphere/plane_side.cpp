// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/plane_side.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "sphere/expansion.hpp"
#include "sphere/orientation.hpp"

namespace impinge {
namespace {

// All four scaled by one power of two, so that the largest component is in [1/2, 1).
int exact_plane_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array points{a, b, c, d};
  double largest = 0.0;
  for (const Vec3& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  int exponent = 0;
  std::frexp(largest, &exponent);
  std::array<Vec3, 4> x;
  for (std::size_t i = 0; i < 4; ++i) {
    x[i] = points[i].unaryExpr([exponent](double value) { return std::ldexp(value, -exponent); });
  }
  Expansion<96> sum;
  add_determinant(sum, 1.0, x[1], x[2], x[3]);
  add_determinant(sum, -1.0, x[0], x[2], x[3]);
  add_determinant(sum, 1.0, x[0], x[1], x[3]);
  add_determinant(sum, -1.0, x[0], x[1], x[2]);
  return sum.sign();
}

}  // namespace

int plane_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  // The filter of orientation(). The differences add one rounding to each component, which makes 13, within
  // the 20 of kPlaneTestError. 1-norms of the rounded differences cover the sum of absolute products.
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ad = d - a;
  const double det = ab.dot(ac.cross(ad));
  const double product = ac.lpNorm<1>() * ad.lpNorm<1>();
  const double doubt = kPlaneTestError * ab.lpNorm<1>() * product;
  if (product > kSmallestProduct && doubt > kSmallestProduct && std::abs(det) > doubt &&
      std::abs(det) < kLargestProduct)
    return det > 0.0 ? 1 : -1;
  return exact_plane_side(a, b, c, d);
}

Crossing crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const int k1 = orientation(b, c, d);
  const int k2 = -orientation(a, c, d);
  if (k1 * k2 < 0) return {};
  const int k3 = orientation(a, b, d);
  const int k4 = -orientation(a, b, c);
  const int near = k1 != 0 ? k1 : k2;
  const int far = k3 != 0 ? k3 : k4;
  if (k3 * k4 < 0 || near * far >= 0) return {};
  return {true, -near * plane_side(a, b, c, d)};
}

}  // namespace impinge
