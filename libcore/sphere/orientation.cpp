// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/orientation.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

namespace impinge {
namespace {

// Inside these a product of two or three lengths has neither lost digits to underflow nor overflowed.
constexpr double kSmallest = 1e-280;
constexpr double kLargest = 1e300;

// Exact sum of doubles as a nonoverlapping expansion, smallest component first.
class Expansion {
 public:
  void add(double value) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = component_[i] + value;
      const double rest = sum - component_[i];
      const double error = (component_[i] - (sum - rest)) + (value - rest);
      if (error != 0.0) component_[kept++] = error;
      value = sum;
    }
    if (value != 0.0) component_[kept++] = value;
    size_ = kept;
  }

  int sign() const {
    if (size_ == 0) return 0;
    return component_[size_ - 1] > 0.0 ? 1 : -1;
  }

 private:
  std::array<double, 32> component_{};  // 6 products of 4 components each need 24
  std::size_t size_ = 0;
};

// Adds x * y * z without rounding.
void add_product(Expansion& sum, double x, double y, double z) {
  const double high = x * y;
  const double low = std::fma(x, y, -high);
  for (const double part : {high, low}) {
    const double p = part * z;
    sum.add(p);
    sum.add(std::fma(part, z, -p));
  }
}

// The same direction with its largest component in [1/2, 1).
Vec3 scaled(const Vec3& v) {
  int exponent = 0;
  std::frexp(v.cwiseAbs().maxCoeff(), &exponent);
  return {std::ldexp(v.x(), -exponent), std::ldexp(v.y(), -exponent), std::ldexp(v.z(), -exponent)};
}

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c) {
  Expansion det;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    add_product(det, a[i], b[j], c[k]);
    add_product(det, -a[i], b[k], c[j]);
  }
  return det.sign();
}

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c) {
  // 1-norms are cheaper than lengths and no smaller. Out of range both sides of the comparison fail it.
  const double det = a.dot(b.cross(c));
  const double product = b.lpNorm<1>() * c.lpNorm<1>();
  const double doubt = kPlaneTestError * a.lpNorm<1>() * product;
  if (product > kSmallest && doubt > kSmallest && std::abs(det) > doubt && std::abs(det) < kLargest)
    return det > 0.0 ? 1 : -1;
  if (a == b || b == c || c == a) return 0;  // a shared corner, the commonest zero
  return exact_orientation(scaled(a), scaled(b), scaled(c));
}

}  // namespace impinge
