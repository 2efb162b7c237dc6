// SPDX-License-Identifier: GPL-3.0-or-later
// f = sum a_lm Y_lm: known functions, a round trip, and Parseval's sum |a_lm|^2 = integral of f^2.
#include "spectrum/harmonic_transform.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "spectrum/power_spectrum.hpp"

namespace impinge {
namespace {

HarmonicCoefficients random_coefficients(std::size_t limit) {
  HarmonicCoefficients a = zero_coefficients(limit);
  std::mt19937_64 random(61);
  const auto next = [&random] { return std::ldexp(static_cast<double>(random() >> 11U), -52) - 1.0; };
  for (std::size_t l = 0; l < limit; ++l) {
    a.at(l, 0) = next();
    for (std::size_t m = 1; m <= l; ++m) {
      const double re = next();
      a.at(l, m) = {re, next()};
    }
  }
  return a;
}

// Real harmonics written out: sqrt(3 / 4 pi) z, sqrt(3 / 8 pi) sin e^(i theta), sqrt(5 / 16 pi) (3 z^2 - 1),
// sqrt(15 / 32 pi) sin^2 e^(2 i theta).
TEST(HarmonicTransform, FindsKnownFunctions) {
  const GaussGrid grid(8);
  const auto values = sample(grid, [](const Vec3& u) {
    return 5.0 + 2.0 * u.z() - 3.0 * u.y() + 0.5 * (3.0 * u.z() * u.z() - 1.0) + u.x() * u.x() -
           u.y() * u.y();
  });
  const HarmonicCoefficients a = analyse(grid, values);
  EXPECT_NEAR(a.at(0, 0).real(), 5.0 * std::sqrt(4.0 * kPi), 1e-13);
  EXPECT_NEAR(a.at(1, 0).real(), 2.0 * std::sqrt(4.0 * kPi / 3.0), 1e-13);
  EXPECT_NEAR(a.at(1, 1).imag(), 1.5 * std::sqrt(8.0 * kPi / 3.0), 1e-13);
  EXPECT_NEAR(a.at(2, 0).real(), 0.5 * std::sqrt(16.0 * kPi / 5.0), 1e-13);
  EXPECT_NEAR(a.at(2, 2).real(), 0.5 * std::sqrt(32.0 * kPi / 15.0), 1e-13);
  const double known = std::norm(a.at(0, 0)) + std::norm(a.at(1, 0)) + 2.0 * std::norm(a.at(1, 1)) +
                       std::norm(a.at(2, 0)) + 2.0 * std::norm(a.at(2, 2));
  double all = 0.0;
  for (const double power : power_by_degree(a)) all += power;
  EXPECT_NEAR(all, known, 1e-11);
}

TEST(HarmonicTransform, RecoversASpectrum) {
  for (const std::size_t limit : {1U, 2U, 17U, 64U}) {
    const GaussGrid grid(limit);
    const HarmonicCoefficients expected = random_coefficients(limit);
    const std::vector<double> values = synthesise(grid, expected);
    const HarmonicCoefficients found = analyse(grid, values);
    ASSERT_EQ(found.values.size(), expected.values.size());
    for (std::size_t k = 0; k < found.values.size(); ++k)
      ASSERT_LT(std::abs(found.values[k] - expected.values[k]), 1e-12) << limit << ' ' << k;
    double integral = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
      integral += grid.weight(i / grid.columns()) * values[i] * values[i];
    double sum = 0.0;
    for (const double power : power_by_degree(found)) sum += power;
    EXPECT_NEAR(sum / integral, 1.0, 1e-12);
  }
}

// A high degree on its own: no other degree gets any of it.
TEST(HarmonicTransform, KeepsHighDegreesApart) {
  const GaussGrid grid(200);
  HarmonicCoefficients a = zero_coefficients(200);
  a.at(199, 3) = {1.0, -2.0};
  const auto power = power_by_degree(analyse(grid, synthesise(grid, a)));
  for (std::size_t l = 0; l < 199; ++l) EXPECT_LT(power[l], 1e-24);
  EXPECT_NEAR(power[199], 10.0, 1e-11);
}

TEST(HarmonicTransform, RefusesHolesAndOtherSizes) {
  const GaussGrid grid(4);
  std::vector<double> values(grid.size(), 1.0);
  values[3] = std::nan("");
  EXPECT_THROW(analyse(grid, values), std::invalid_argument);
  EXPECT_THROW(analyse(grid, std::vector<double>(7, 1.0)), std::invalid_argument);
  EXPECT_THROW(synthesise(grid, zero_coefficients(5)), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
