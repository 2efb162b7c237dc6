// SPDX-License-Identifier: GPL-3.0-or-later
// The tables made of elliptic integrals against the integrals, which tests/curves holds against GSL.
#include "sphere/elliptic.hpp"

#include <array>

#include <gtest/gtest.h>

#include "sphere/direction.hpp"
#include "sphere/elliptic_arc.hpp"

namespace impinge {
namespace {

constexpr std::array kComplements{1e-16, 1e-6, 0.0048, 0.3, 1.0, 2.0, 209.0, 209765.0, 8.4e7, 4e16};

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
