// SPDX-License-Identifier: GPL-3.0-or-later
// Elliptic integrals against published values, closed forms and Gauss-Legendre quadrature; the tables made of
// them against the integrals. (tests/curves holds them against GSL.)
#include "sphere/elliptic.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sphere/direction.hpp"
#include "sphere/elliptic_arc.hpp"
#include "support/quadrature.hpp"

namespace impinge {
namespace {

constexpr std::array kComplements{1e-16, 1e-6, 0.0048, 0.3, 1.0, 2.0, 209.0, 209765.0, 8.4e7, 4e16};

// R_F(1, 2, 0) and R_D(0, 2, 1) of Carlson 1995, Section 4; R_F(x, x, x) = x^(-1/2), R_D = x^(-3/2).
TEST(Elliptic, CarlsonsIntegrals) {
  EXPECT_NEAR(carlson_integrals(1.0, 2.0, 0.0 + 1e-300).rf, 1.3110287771461, 1e-13);
  EXPECT_NEAR(carlson_integrals(0.0, 2.0, 1.0).rd, 1.7972103521034, 1e-13);
  EXPECT_NEAR(carlson_integrals(2.0, 3.0, 4.0).rd, 0.16510527294261, 1e-14);
  EXPECT_NEAR(carlson_integrals(3.0, 3.0, 3.0).rf, 1.0 / std::sqrt(3.0), 2e-16);
  EXPECT_NEAR(carlson_integrals(3.0, 3.0, 3.0).rd, std::pow(3.0, -1.5), 1e-16);
}

TEST(Elliptic, SecondKindIsItsIntegral) {
  for (const double complement : kComplements) {
    const auto speed = [&](double t) { return std::hypot(std::cos(t), std::sqrt(complement) * std::sin(t)); };
    // The speed changes where tan t is of the order of complement^(-1/2): pieces that grow from there.
    double from = 0.0;
    double expected = 0.0;
    for (double to = 1e-9; to < 0.5 * kPi; to *= 1.25) {
      expected += test::integral(speed, from, to);
      EXPECT_NEAR(elliptic_e(to, complement), expected, 1e-14 * expected) << complement << ' ' << to;
      from = to;
    }
  }
}

TEST(Elliptic, ClosedForms) {
  for (double phi = 0.0; phi <= 0.5 * kPi; phi += 0.01) {
    EXPECT_NEAR(elliptic_e(phi, 1.0), phi, 1e-15);              // a circle
    EXPECT_NEAR(elliptic_e(phi, 1e-40), std::sin(phi), 1e-15);  // a cusp
  }
  EXPECT_EQ(elliptic_e(0.0, 7.0), 0.0);
}

TEST(EllipticArc, LengthAndAngleAreThoseOfTheIntegral) {
  for (const double complement : kComplements) {
    for (const double end : {0.25 * kPi, 0.5 * kPi}) {
      if (complement < 1.0 && end > 0.25 * kPi) continue;
      const EllipticArc arc(complement, end);
      EXPECT_EQ(arc.length(0.0), 0.0);
      EXPECT_EQ(arc.angle(0.0), 0.0);
      for (double x = end; x > 1e-12; x *= 0.83) {
        const double length = elliptic_e(x, complement);
        EXPECT_NEAR(arc.length(x), length, 2e-15 * length) << complement << ' ' << x;
        EXPECT_NEAR(arc.angle(length), x, 2e-15 * x) << complement << ' ' << x;
      }
    }
  }
}

}  // namespace
}  // namespace impinge
