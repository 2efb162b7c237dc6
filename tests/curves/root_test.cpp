// SPDX-License-Identifier: GPL-3.0-or-later
// GSL's roots and integrals behind exceptions: nothing here ends the program.
#include "curves/root.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/quadrature.hpp"

namespace impinge {
namespace {

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
