// SPDX-License-Identifier: GPL-3.0-or-later
// Carlson's integrals against published values, the arcs made of them against quadrature.
#include "curves/carlson.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/quadrature.hpp"

namespace impinge {
namespace {

// R_F(x, x, x) = x^(-1/2), R_D(x, x, x) = x^(-3/2); Carlson 1995 gives R_F(1, 2, 0) and R_D(0, 2, 1).
TEST(Carlson, MeetsPublishedValuesAndRefusesBadArguments) {
  EXPECT_NEAR(gsl_carlson_rf(3.0, 3.0, 3.0), 1.0 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(gsl_carlson_rd(3.0, 3.0, 3.0), std::pow(3.0, -1.5), 1e-15);
  EXPECT_NEAR(gsl_carlson_rf(1.0, 2.0, 0.0), 1.3110287771461, 1e-13);
  EXPECT_NEAR(gsl_carlson_rd(0.0, 2.0, 1.0), 1.7972103521034, 1e-13);
  EXPECT_THROW(gsl_carlson_rf(-1.0, 2.0, 3.0), std::runtime_error);
  EXPECT_THROW(gsl_carlson_rf(0.0, 0.0, 1.0), std::runtime_error);
  EXPECT_THROW(gsl_carlson_rd(1.0, 1.0, 0.0), std::runtime_error);
}

// E(phi | m) of both forms against its integral, for small and large parameters.
TEST(Carlson, ArcsAreTheirIntegrals) {
  for (const double phi : {1e-9, 0.1, 1.0, 1.5, 1.5707963267948966}) {
    for (const double n : {0.0, 1.0, 1e4}) {
      const auto speed = [n](double t) { return std::sqrt(1.0 + n * std::pow(std::sin(t), 2)); };
      const double expected = integrate(speed, 0.0, phi);
      EXPECT_NEAR(arc_of_growing_speed(phi, n), expected, 1e-13 * expected);
    }
    for (const double rest : {1.0, 0.5, 1e-3, 1e-9}) {
      const auto speed = [rest](double t) { return std::hypot(std::cos(t), std::sqrt(rest) * std::sin(t)); };
      const double expected = integrate(speed, 0.0, phi);
      EXPECT_NEAR(arc_of_falling_speed(phi, rest), expected, 1e-13 * expected);
    }
  }
}

}  // namespace
}  // namespace impinge
