// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/gsl.hpp"
#include "sphere/direction.hpp"
#include "sphere/elliptic.hpp"

namespace impinge {
namespace {

// The elliptic integrals of sphere/, which has the standard library alone, against those of GSL.

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

// Those of GSL are held against quadrature below.
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

// Carlson's integrals against published values, the arcs made of them against quadrature.

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

// GSL's roots and integrals behind exceptions: nothing here ends the program.

TEST(Root, IsFoundToTheLastDigits) {
  EXPECT_NEAR(find_root([](double x) { return x * x - 2.0; }, 0.0, 2.0), std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(find_root([](double x) { return std::cos(x) - x; }, 0.0, 1.0), 0.7390851332151607, 1e-15);
  EXPECT_NEAR(find_root([](double x) { return x - 1e-15; }, 0.0, 1.0), 1e-15, 1e-29);
}

TEST(Root, AtAnEndIsThatEnd) {
  EXPECT_EQ(find_root([](double x) { return x; }, 0.0, 1.0), 0.0);
  EXPECT_EQ(find_root([](double x) { return x - 1.0; }, 0.0, 1.0), 1.0);
}

TEST(Root, RefusesEqualSignsAndNoNumbers) {
  EXPECT_THROW(find_root([](double x) { return x * x + 1.0; }, 0.0, 1.0), std::invalid_argument);
  EXPECT_THROW(find_root([](double) { return std::nan(""); }, 0.0, 1.0), std::invalid_argument);
  EXPECT_THROW(find_root([](double x) { return x < 0.3   ? -1.0
                                               : x < 0.6 ? std::nan("")
                                                         : 1.0; }, 0.0, 1.0),
               std::runtime_error);
}

TEST(Root, AnExceptionOfTheFunctionComesThrough) {
  const auto throws = [](double x) {
    if (x > 0.4 && x < 0.6) throw std::domain_error("here");
    return x - 0.5;
  };
  EXPECT_THROW(find_root(throws, 0.0, 1.0), std::domain_error);
  EXPECT_THROW(integrate(throws, 0.0, 1.0), std::domain_error);
}

TEST(Quadrature, MeetsClosedForms) {
  EXPECT_NEAR(integrate([](double x) { return std::exp(x); }, 0.0, 1.0), std::exp(1.0) - 1.0, 1e-13);
  EXPECT_THROW(integrate([](double x) { return 1.0 / x; }, 0.0, 1.0), std::runtime_error);
}

}  // namespace
}  // namespace impinge
