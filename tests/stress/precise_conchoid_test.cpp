// SPDX-License-Identifier: GPL-3.0-or-later
// The truth of the family `conchoid` against closed forms and against itself:
//   s(phi) = 4 a sin(phi / 2),  A(pi) = 32 pi a^2 / 5  at the cusp a = b;  ds / dphi = speed,  dA / dphi =
//   area rate.
#include "stress/precise_conchoid.hpp"

#include <gtest/gtest.h>

#include "sphere/direction.hpp"
#include "stress/family.hpp"

namespace impinge::lab {

StabilityFamily conchoid_family();

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

// Ours hold up to the cusp and refuse the loop; the textbook's formulas, in the same harness, are found
// wanting.
TEST(ConchoidFamily, TellsGoodFormulasFromBadOnes) {
  const StabilityFamily family = conchoid_family();
  const std::vector<StabilityCase> cases = family.run({true, 1});
  EXPECT_TRUE(broken(family, cases).empty());
  std::size_t refused = 0;
  std::size_t plain_wrong = 0;
  for (const StabilityCase& c : cases) {
    EXPECT_EQ(c.refused.empty(), c.magnitude >= 0.0) << c.method << " at " << c.magnitude;
    refused += c.refused.empty() ? 0U : 1U;
    if (c.method == "radius_as_eq_11" && c.magnitude > 0.0 && c.magnitude < 1e-6) plain_wrong += c.wrong;
  }
  EXPECT_EQ(refused, 8U);
  EXPECT_GT(plain_wrong, 10U);
}

}  // namespace
}  // namespace impinge::lab
