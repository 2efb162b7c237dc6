// SPDX-License-Identifier: GPL-3.0-or-later
// The probe function satisfies Helmholtz' equation, Laplacian f = -k^2 f, and its variance is 1; errors of
// a table fall with the square of the spacing: N error is a constant of the scheme.
#include "scheme_metrics/interpolation_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/radial_table.hpp"
#include "sphere/scheme_choice.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/uniform_directions.hpp"
#include "support/every_scheme.hpp"

namespace impinge {
namespace {

TEST(BandLimited, HasTheWavenumberItIsAskedFor) {
  const double k = 7.0;
  const BandLimited functions({k, 5, 3, 3});
  const double h = 1e-3;
  for (const Vec3& u : uniform_directions(50, 1)) {
    double laplacian = -6.0 * functions.value(2, u);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Vec3 step = h * Vec3::Unit(axis);
      laplacian += functions.value(2, u + step) + functions.value(2, u - step);
    }
    EXPECT_NEAR(laplacian / (h * h), -k * k * functions.value(2, u), 1e-3);
  }
}

TEST(BandLimited, HasUnitVarianceEverywhere) {
  const BandLimited functions({30.0, 32, 20000, 4});
  ASSERT_EQ(functions.functions(), 20000U);
  for (const Vec3& u : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0.6, 0, -0.8)}) {
    double mean = 0.0;
    double square = 0.0;
    for (std::size_t f = 0; f < functions.functions(); ++f) {
      const double value = functions.value(f, u);
      mean += value / 20000.0;
      square += value * value / 20000.0;
    }
    EXPECT_NEAR(mean, 0.0, 4.0 / std::sqrt(20000.0));
    EXPECT_NEAR(square, 1.0, 4.0 * std::sqrt(2.0 / 20000.0));
  }
}

TEST(BandLimited, IsTheSameForTheSameSeedOnly) {
  const Vec3 u = Vec3(0.2, -0.3, 0.8).normalized();
  const BandLimited functions({30.0, 32, 2, 5});
  EXPECT_EQ(functions.value(1, u), BandLimited({30.0, 32, 2, 5}).value(1, u));
  EXPECT_NE(functions.value(1, u), BandLimited({30.0, 32, 2, 6}).value(1, u));
  EXPECT_NE(functions.value(1, u), functions.value(0, u));
  EXPECT_THROW(BandLimited({30.0, 0, 1, 5}), std::invalid_argument);
  EXPECT_THROW(BandLimited({30.0, 4, 0, 5}), std::invalid_argument);
  EXPECT_THROW(BandLimited({std::nan(""), 4, 1, 5}), std::invalid_argument);
}

TEST(InterpolationError, IsSummarisedByRank) {
  std::vector<double> errors;
  for (int i = 1; i <= 20000; ++i) errors.push_back(i % 2 == 0 ? -i : i);
  const InterpolationError error = summarise_errors(errors);
  EXPECT_EQ(error.max, 20000.0);
  EXPECT_EQ(error.p9999, 19998.0);
  EXPECT_NEAR(error.rms, std::sqrt(20001.0 * 40001.0 / 6.0), 1e-8);
  EXPECT_EQ(summarise_errors({-3.0}).p9999, 3.0);
  EXPECT_THROW(summarise_errors({}), std::invalid_argument);
  EXPECT_THROW(summarise_errors({1.0, std::numeric_limits<double>::quiet_NaN()}), std::runtime_error);
}

// The errors are those of tables that are really filled.
TEST(InterpolationError, IsThatOfRadialTables) {
  const ErrorProbe probe(BandLimited({10.0, 8, 3, 2}), uniform_directions(3000, 3));
  test::every_scheme([&]<class S>() {
    const S scheme = S::with_precision(6.0);
    double largest = 0.0;
    for (std::size_t f = 0; f < 3; ++f) {
      RadialTable<S> table(scheme);
      for (std::size_t i = 0; i < scheme.size(); ++i) {
        table.radii()[i] = probe.functions.value(f, scheme.direction(i));
      }
      for (std::size_t i = f; i < probe.directions.size(); i += 3) {
        largest = std::max(largest, std::abs(table.radius_at(probe.directions[i]) - probe.truth[i]));
      }
    }
    EXPECT_NEAR(interpolation_error(scheme, probe).max, largest, 1e-14) << S::name;
  });
}

// Bilinear interpolation over cells of a by b is off by at most (a^2 |f_aa| + b^2 |f_bb|) / 8, and near the
// equator it comes close to that in the middle of a cell. In spherical angles no second derivative of a wave
// exp(i k n.u) is above k^2 + k.
TEST(InterpolationError, OfOneWaveIsWithinTheClosedForm) {
  const double k = 20.0;
  const ErrorProbe probe(BandLimited({k, 1, 50, 2}), uniform_directions(50000, 3));
  const double bound = std::sqrt(2.0) * 2.0 * (k * k + k) * kDegree * kDegree / 8.0;
  const InterpolationError error = interpolation_error(Rsid::with_precision(1.0), probe);
  EXPECT_LE(error.max, bound);
  EXPECT_GE(error.max, 0.4 * bound);
}

TEST(UniformDirections, FillTheSphereAndItsCapsEvenly) {
  const auto all = uniform_directions(40000, 6);
  const auto polar = polar_directions(40000, 0.5, 7);
  double squares = 0.0;
  double south = 0.0;
  double inner = 0.0;
  for (const Vec3& u : all) squares += u.z() * u.z() / 40000.0;
  for (const Vec3& u : polar) {
    ASSERT_NEAR(u.norm(), 1.0, 1e-15);
    ASSERT_GE(std::abs(u.z()), std::cos(0.5) - 1e-15);
    south += u.z() < 0.0 ? 1.0 / 40000.0 : 0.0;
    inner += 1.0 - std::abs(u.z()) < 0.5 * (1.0 - std::cos(0.5)) ? 1.0 / 40000.0 : 0.0;
  }
  EXPECT_NEAR(squares, 1.0 / 3.0, 0.006);
  EXPECT_EQ(std::round(south * 1000.0), 500.0);
  EXPECT_NEAR(inner, 0.5, 0.01);
}

// Errors fall with the square of the spacing, so with the number of entries. Next to a pole, where the mean
// of a few entries or one of them stands for a missing row, they fall with the spacing only: that shows in
// the largest, and in all where the entries there are few.
TEST(InterpolationError, FallsWithTheNumberOfEntriesForEveryScheme) {
  const ErrorProbe probe(BandLimited({10.0, 16, 64, 4}), uniform_directions(20000, 5));
  test::every_scheme([&]<class S>() {
    const S coarse = S::with_precision(3.0);
    const S fine = S::with_precision(1.5);
    const double ratio = static_cast<double>(fine.size()) / static_cast<double>(coarse.size());
    const InterpolationError before = interpolation_error(coarse, probe);
    const InterpolationError after = interpolation_error(fine, probe);
    EXPECT_GE(before.rms / after.rms, 0.7 * ratio) << S::name;
    EXPECT_LE(before.rms / after.rms, 1.1 * ratio) << S::name;
    EXPECT_GE(before.p9999 / after.p9999, 0.9 * std::sqrt(ratio)) << S::name;
    EXPECT_GE(before.max, before.p9999) << S::name;
    EXPECT_GE(before.p9999, before.rms) << S::name;
  });
}

TEST(InterpolationError, OfGridsWithoutSuchPolesFallsWithTheSquareOfTheSpacing) {
  const ErrorProbe probe(BandLimited({10.0, 16, 64, 4}), uniform_directions(20000, 5));
  for (const std::string_view name : {"rsid", "icosahedral_gnomonic", "icosahedral_sine", "cube_gnomonic"}) {
    with_scheme(name, [&]<class S>() {
      const InterpolationError before = interpolation_error(S::with_precision(3.0), probe);
      const InterpolationError after = interpolation_error(S::with_precision(1.5), probe);
      EXPECT_NEAR(before.rms / after.rms, 4.0, 0.1) << S::name;
      EXPECT_NEAR(before.p9999 / after.p9999, 4.0, 0.5) << S::name;
    });
  }
}

}  // namespace
}  // namespace impinge
