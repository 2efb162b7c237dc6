// SPDX-License-Identifier: GPL-3.0-or-later
// Rounds points to single precision.
#pragma once

#include "sphere/direction.hpp"

namespace impinge {

/// x with each coordinate rounded to float. The variable is volatile because GCC 12, from -O2 on, leaves the
/// rounding out where it turns two doubles at a time to floats and back, as in
/// x.cast<float>().cast<double>().
inline Vec3 as_floats(const Vec3& x) {
  const auto rounded = [](double value) {
    const volatile float near = static_cast<float>(value);
    return static_cast<double>(near);
  };
  return {rounded(x.x()), rounded(x.y()), rounded(x.z())};
}

}  // namespace impinge
