// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/collinear.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace impinge {
namespace {

// Six products, each the exact sum of two doubles, are at most twelve terms.
struct ExactSum {
  std::array<double, 12> terms{};  // non-overlapping, growing in magnitude
  std::size_t size = 0;

  // Grow-expansion: carries `x` through the terms; each addition leaves its exact rounding error behind.
  void add(double x) {
    for (std::size_t i = 0; i < size; ++i) {
      const double sum = x + terms[i];
      const double part = sum - x;
      terms[i] = (x - (sum - part)) + (terms[i] - part);
      x = sum;
    }
    terms[size++] = x;
  }

  void add_product(double x, double y) {
    const double product = x * y;
    add(std::fma(x, y, -product));
    add(product);
  }

  bool is_zero() const {
    return std::all_of(terms.begin(), terms.begin() + static_cast<std::ptrdiff_t>(size),
                       [](double term) { return term == 0.0; });
  }
};

using Point = std::array<double, 2>;

// Is the signed area of the plane triangle zero? |coordinates| <= 1.
bool zero_area(Point a, Point b, Point c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]);
  const double right = (a[1] - c[1]) * (b[0] - c[0]);
  // Each factor and product has a relative error of at most u = epsilon / 2, so the difference is within
  // (3 u + O(u^2)) (|left| + |right|) of the area, underflow aside.
  const double bound = 4.0 * std::numeric_limits<double>::epsilon() * (std::abs(left) + std::abs(right));
  if (std::abs(left - right) > bound + std::numeric_limits<double>::min()) return false;
  ExactSum area;
  area.add_product(a[0], b[1]);
  area.add_product(-a[0], c[1]);
  area.add_product(-c[0], b[1]);
  area.add_product(-a[1], b[0]);
  area.add_product(a[1], c[0]);
  area.add_product(c[1], b[0]);
  return area.is_zero();
}

}  // namespace

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double largest =
      std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
  if (largest == 0.0) return true;
  const int shift = -std::ilogb(largest) - 1;
  const auto plane = [shift](const Vec3& p, int i, int j) {
    return Point{std::scalbn(p[i], shift), std::scalbn(p[j], shift)};
  };
  for (const auto& [i, j] : {std::array{0, 1}, std::array{1, 2}, std::array{2, 0}}) {
    if (!zero_area(plane(a, i, j), plane(b, i, j), plane(c, i, j))) return false;
  }
  return true;
}

}  // namespace impinge
