// SPDX-License-Identifier: GPL-3.0-or-later
// The elliptic integrals of sphere/, which has the standard library alone, against those of GSL.
#include "sphere/elliptic.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "curves/carlson.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

TEST(Elliptic, CarlsonsIntegralsAreThoseOfGsl) {
  for (const double x : {0.0, 1e-12, 0.3, 1.0}) {
    for (const double y : {1e-10, 0.5, 1.0, 8.4e7}) {
      for (const double z : {1e-8, 1.0, 30.0}) {
        const CarlsonIntegrals found = carlson_integrals(x, y, z);
        const double rf = gsl_carlson_rf(x, y, z);
        const double rd = gsl_carlson_rd(x, y, z);
        EXPECT_NEAR(found.rf, rf, 3e-15 * rf) << x << ' ' << y << ' ' << z;
        EXPECT_NEAR(found.rd, rd, 3e-15 * rd) << x << ' ' << y << ' ' << z;
      }
    }
  }
}

// Those of GSL are held against quadrature in carlson_test.
TEST(Elliptic, ArcsAreThoseOfGsl) {
  for (const double complement : {1e-40, 1e-16, 1.0, 4e16}) EXPECT_EQ(elliptic_e(0.0, complement), 0.0);
  for (double phi = 1e-6; phi < 0.5 * kPi; phi *= 1.1) {
    for (const double n : {0.0, 1.0, 16.0, 209764.0, 8.4e7, 4e16}) {
      const double expected = arc_of_growing_speed(phi, n);
      EXPECT_NEAR(elliptic_e(phi, 1.0 + n), expected, 1e-14 * expected) << phi << ' ' << n;
    }
    for (const double rest : {1e-40, 1e-16, 1e-12, 0.0048, 0.5, 1.0}) {
      const double expected = arc_of_falling_speed(phi, rest);
      EXPECT_NEAR(elliptic_e(phi, rest), expected, 1e-14 * expected) << phi << ' ' << rest;
    }
  }
}

}  // namespace
}  // namespace impinge
