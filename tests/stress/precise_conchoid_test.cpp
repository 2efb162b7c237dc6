// SPDX-License-Identifier: GPL-3.0-or-later
// The truth of the family `conchoid` against closed forms and against itself:
//   s(phi) = 4 a sin(phi / 2),  A(pi) = 32 pi a^2 / 5  at the cusp a = b;  ds / dphi = speed,  dA / dphi =
//   area rate.
#include "stress/precise_conchoid.hpp"

#include <gtest/gtest.h>

#include "sphere/direction.hpp"

namespace impinge::lab {
namespace {

double relative(const Precise& value, const Precise& truth) {
  return Precise(abs(value - truth) / truth).convert_to<double>();
}

TEST(PreciseConchoid, IsTheCardioidAtTheCusp) {
  const PreciseConchoid curve({20.0, 20.0});
  for (const double phi : {0.1, 1.0, 2.5, 3.1}) {
    EXPECT_LT(relative(curve.length(phi), 80 * sin(Precise(phi) / 2)), 1e-50);
    EXPECT_LT(relative(curve.radius(phi), 40 * cos(Precise(phi) / 2) * cos(Precise(phi) / 2)), 1e-50);
  }
  // The double kPi is 1e-16 short of the number, where the area no longer grows.
  EXPECT_LT(relative(curve.area(kPi), 32 * acos(Precise(-1)) * 400 / 5), 1e-45);
}

TEST(PreciseConchoid, LengthAndAreaGrowAsTheirRates) {
  constexpr double kStep = 0x1p-30;
  for (const ConchoidShape& shape :
       {ConchoidShape{}, ConchoidShape{17.8431, 17.843}, ConchoidShape{20.0, 1.0}}) {
    const PreciseConchoid curve(shape);
    for (const double phi : {0.5, 1.5, 2.5}) {
      const Precise length = (curve.length(phi + kStep) - curve.length(phi - kStep)) / (2 * kStep);
      const Precise area = (curve.area(phi + kStep) - curve.area(phi - kStep)) / (2 * kStep);
      EXPECT_LT(relative(length, curve.speed(phi)), 1e-16);
      EXPECT_LT(relative(area, curve.area_rate(phi)), 1e-16);
    }
  }
}

}  // namespace
}  // namespace impinge::lab
