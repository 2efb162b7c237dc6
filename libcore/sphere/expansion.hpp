// SPDX-License-Identifier: GPL-3.0-or-later
// Adds doubles and their products without rounding, for exact signs and for sums that are rounded once.
// Theorem 1 (signs).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "sphere/direction.hpp"

namespace impinge {

/// A product of three lengths between these two has neither lost digits to underflow nor overflowed.
inline constexpr double kSmallestProduct = 1e-280;
inline constexpr double kLargestProduct = 1e300;  // see kSmallestProduct

/// Exact sum of doubles as a nonoverlapping expansion, smallest component first (Shewchuk 1997, "Adaptive
/// precision floating-point arithmetic"). `Most` is at least the number of values added.
template <std::size_t Most>
class Expansion {
 public:
  /// Adds a value, exactly.
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

  /// Sign of the sum, exactly: +1, 0 or -1.
  int sign() const {
    if (size_ == 0) return 0;
    return component_[size_ - 1] > 0.0 ? 1 : -1;
  }

  /// The sum as a double. Its relative error is at most 2^-53, but for 2^-53 of that: the components below
  /// the last two hardly count.
  double value() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < size_; ++i) sum += component_[i];
    return sum;
  }

 private:
  std::array<double, Most> component_{};
  std::size_t size_ = 0;
};

/// Adds x * y: two values.
template <std::size_t Most>
void add_product(Expansion<Most>& sum, double x, double y) {
  const double product = x * y;
  sum.add(product);
  sum.add(std::fma(x, y, -product));
}

/// Adds x * y * z: four values.
template <std::size_t Most>
void add_product(Expansion<Most>& sum, double x, double y, double z) {
  const double high = x * y;
  const double low = std::fma(x, y, -high);
  for (const double part : {high, low}) add_product(sum, part, z);
}

/// Adds sign * det(a, b, c), det(a, b, c) = a . (b x c), sign 1 or -1: 24 values, from 6 products.
template <std::size_t Most>
void add_determinant(Expansion<Most>& sum, double sign, const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    add_product(sum, sign * a[i], b[j], c[k]);
    add_product(sum, -sign * a[i], b[k], c[j]);
  }
}

}  // namespace impinge
