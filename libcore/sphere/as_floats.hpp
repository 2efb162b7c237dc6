// SPDX-License-Identifier: GPL-3.0-or-later
// Points that single precision holds.
#pragma once

#include "sphere/direction.hpp"

namespace impinge {

/// Rounded to floats. Volatile, because GCC 12 leaves the rounding out, from -O2 on, where it turns two
/// doubles at a time to floats and back, as it does of x.cast<float>().cast<double>().
inline Vec3 as_floats(const Vec3& x) {
  const auto rounded = [](double value) {
    const volatile float near = static_cast<float>(value);
    return static_cast<double>(near);
  };
  return {rounded(x.x()), rounded(x.y()), rounded(x.z())};
}

}  // namespace impinge
