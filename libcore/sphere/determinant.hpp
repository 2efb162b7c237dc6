// SPDX-License-Identifier: GPL-3.0-or-later
// det(a, b, c) = a . (b x c) of three vectors, without rounding.
#pragma once

#include <cstddef>

#include "sphere/direction.hpp"
#include "sphere/expansion.hpp"

namespace impinge {

/// Adds det(a, b, c), or less where sign is -1: 24 values, those of 6 products.
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
