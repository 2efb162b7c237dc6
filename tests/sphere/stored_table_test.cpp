// SPDX-License-Identifier: GPL-3.0-or-later
// Contract:
//   |stored - double| <= storage_bound() in every direction that has an answer, and the same directions have
//   radii, uint16: storage_bound() <= half a step + rounding; a bound half as large is exceeded
#include "sphere/stored_table.hpp"

#include <cmath>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/entry_set.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/schemes/icosahedral_sine.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/table_size.hpp"
#include "support/directions.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

constexpr double kSmallest = 18.0;  // mm
constexpr double kLargest = 30.0;   // mm

// A bumpy body without surface round one direction, and a rim cell elsewhere.
template <SamplingScheme S>
RadialTable<S> bumpy_table(const S& scheme) {
  RadialTable<S> table(scheme);
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    const Vec3 u = scheme.direction(i);
    const double wave = std::sin(9.0 * u.x()) * std::cos(7.0 * u.y() + 1.0) * std::cos(5.0 * u.z());
    if (u.dot(Vec3(0.6, 0.0, 0.8)) < 0.97)
      table.radii()[i] = 0.5 * (kSmallest + kLargest) + 0.5 * (kLargest - kSmallest) * wave;
  }
  table.mark_rim_cell(scheme.stencil(Vec3(-0.3, 0.5, -0.7)).cell);
  return table;
}

template <SamplingScheme S>
std::vector<Vec3> probes(const S& scheme) {
  std::vector<Vec3> directions = test::random_directions(20000, 31);
  for (const Vec3& u : test::special_directions()) directions.push_back(u);
  for (std::size_t i = 0; i < scheme.size(); ++i) directions.push_back(scheme.direction(i));
  return directions;
}

// Largest |stored - exact| over the probes, mm; both have to be without surface in the same directions.
template <class Stored, class Exact>
double largest_difference(const Stored& stored, const Exact& exact) {
  double largest = 0.0;
  std::size_t answers = 0;
  std::size_t none = 0;
  for (const Vec3& u : probes(exact.scheme())) {
    const double radius = exact.radius_at(u);
    EXPECT_EQ(std::isnan(stored.radius_at(u)), std::isnan(radius));
    ++(std::isnan(radius) ? none : answers);
    if (!std::isnan(radius)) largest = std::max(largest, std::abs(stored.radius_at(u) - radius));
  }
  EXPECT_GT(none, 100U);
  EXPECT_GT(answers, 10000U);
  return largest;
}

template <class Stored, class Exact, class S>
void expect_a_sharp_bound(const RadialTable<S>& filled) {
  const Stored stored(filled);
  const double largest = largest_difference(stored, Exact(filled));
  EXPECT_LE(largest, stored.storage_bound());
  EXPECT_GT(largest, 0.5 * stored.storage_bound()) << "a bound half as large would hold as well";
}

template <class S>
class StoredTables : public testing::Test {};
using StoredSchemes = testing::Types<Rsid, CubeGnomonic, IcosahedralSine>;
TYPED_TEST_SUITE(StoredTables, StoredSchemes);

TYPED_TEST(StoredTables, RadiiKeepTheirBound) {
  const auto table = bumpy_table(TypeParam::with_precision(2.0));
  expect_a_sharp_bound<FloatTable<TypeParam>, RadialTable<TypeParam>>(table);
  expect_a_sharp_bound<Uint16Table<TypeParam>, RadialTable<TypeParam>>(table);
}

TYPED_TEST(StoredTables, InverseDepthsKeepTheirBound) {
  if constexpr (PlaneExactScheme<TypeParam>) {
    using Exact = InverseDepthTable<TypeParam>;
    const auto table = bumpy_table(TypeParam::with_precision(2.0));
    expect_a_sharp_bound<FloatInverseDepthTable<TypeParam>, Exact>(table);
    expect_a_sharp_bound<Uint16InverseDepthTable<TypeParam>, Exact>(table);
  }
}

TYPED_TEST(StoredTables, TheBoundIsThatOfTheStorage) {
  const auto table = bumpy_table(TypeParam::with_precision(2.0));
  const double step = (kLargest - kSmallest) / 65534.0;
  EXPECT_LE(Uint16Table<TypeParam>(table).storage_bound(), 0.5 * step + 1e-13);
  EXPECT_LE(FloatTable<TypeParam>(table).storage_bound(), kLargest * 0x1p-24 + 1e-13);
}

TYPED_TEST(StoredTables, TakesItsBytesAndThoseOfTheRim) {
  const auto table = bumpy_table(TypeParam::with_precision(2.0));
  const std::size_t rim = table.rim_cells().bytes();
  EXPECT_GT(rim, table.scheme().cells() / 8 - 1);
  EXPECT_EQ(FloatTable<TypeParam>(table).bytes(), 4 * table.scheme().size() + rim);
  EXPECT_EQ(Uint16Table<TypeParam>(table).bytes(), 2 * table.scheme().size() + rim);
}

TEST(QuantisedValues, ASphereTakesOneCode) {
  RadialTable<Rsid> sphere(Rsid::with_precision(10.0));
  std::ranges::fill(sphere.radii(), 24.1);
  const Uint16Table<Rsid> stored(sphere);
  EXPECT_NEAR(stored.radius_at(Vec3(0.1, 0.2, -0.3)), 24.1, 1e-14);
  EXPECT_LT(stored.storage_bound(), 1e-13);
}

TEST(QuantisedValues, NoSurfaceAtAllStaysNone) {
  const RadialTable<Rsid> empty(Rsid::with_precision(10.0));
  EXPECT_TRUE(std::isnan(Uint16Table<Rsid>(empty).radius_at(Vec3::UnitX())));
  EXPECT_TRUE(std::isnan(FloatTable<Rsid>(empty).radius_at(Vec3::UnitX())));
}

// Else a radius would become infinite or lose its digits without a word.
TEST(QuantisedValues, WhatAFloatCannotHoldIsRefused) {
  for (const double bad : {1e39, 1e300, -1e60, 1e-39, 1e-300})
    EXPECT_THROW(FloatValues(std::vector<double>{20.0, bad}), std::invalid_argument) << bad;
  const FloatValues held(std::vector<double>{3e38, 1.2e-38, 0.0, kNoSurface});
  EXPECT_EQ(held.size(), 4U);
  EXPECT_TRUE(std::isnan(held[3]));
}

TEST(QuantisedValues, TheWholeRangeOfCodesIsUsed) {
  const std::vector<double> values{3.0, kNoSurface, 5.0, 4.0};
  const Uint16Values stored(values);
  EXPECT_EQ(stored[0], 3.0);
  EXPECT_NEAR(stored[2], 5.0, 1e-15);
  EXPECT_NEAR(stored[3], 4.0, 0.5 * stored.step() * (1.0 + 1e-9));
  EXPECT_TRUE(std::isnan(stored[1]));
  EXPECT_DOUBLE_EQ(stored.step(), 2.0 / 65534.0);
}

// Tables of more than 2^37 entries are refused with their bytes, before memory is asked for.

TEST(TableSize, UpToTheMostIsTaken) {
  EXPECT_EQ(require_table_size("rsid", 0), 0U);
  EXPECT_EQ(require_table_size("rsid", kMostTableEntries), kMostTableEntries);
  EXPECT_THROW(require_table_size("rsid", kMostTableEntries + 1), std::invalid_argument);
}

TEST(TableSize, TheRefusalSaysWhatTheTableWouldTake) {
  const Rsid scheme = Rsid::with_precision(1e-6);  // 1.8e8 + 1 rows of 3.6e8: 6.5e16 entries
  const std::string text = test::thrown<std::invalid_argument>([&] { RadialTable<Rsid>{scheme}; });
  EXPECT_NE(text.find("64800000360000000 entries"), std::string::npos) << text;
  EXPECT_NE(text.find("5.18e+17 bytes"), std::string::npos) << text;
  EXPECT_NE(text.find("rsid"), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

// The scheme itself has directions and stencils all the same, and its numbers pass 2^31 and 2^32.
TEST(TableSize, AWindowOfSuchATableCanBeRead) {
  const Rsid scheme = Rsid::with_precision(1e-6);
  const std::size_t entry = (std::size_t{3} << 40U) + 12345;
  const Stencil stencil = scheme.stencil(scheme.direction(entry));
  Vec3 seen = Vec3::Zero();
  for (std::size_t k = 0; k < stencil.taps; ++k)
    seen += stencil.weight[k] * scheme.direction(stencil.entry[k]);
  EXPECT_LT((seen - scheme.direction(entry)).norm(), 48.0 * 0x1p-53);
}

// A set of entries, against std::set: same entries, slots in ascending order.

TEST(EntrySet, HoldsWhatWasInsertedAndNumbersIt) {
  constexpr std::size_t kSize = 100'000;
  std::mt19937 random(3);
  std::set<std::size_t> oracle{0, 63, 64, 4095, 4096, kSize - 1};
  for (int k = 0; k < 500; ++k) oracle.insert(20'000 + random() % 9000);  // whole chunks stay empty
  EntrySet set(kSize);
  for (const std::size_t entry : oracle) set.insert(entry);
  set.insert(64);  // again
  set.number();
  EXPECT_EQ(set.count(), oracle.size());
  std::size_t slot = 0;
  for (const std::size_t entry : oracle) EXPECT_EQ(set.slot(entry), slot++);
  for (std::size_t entry = 0; entry < kSize; ++entry) {
    EXPECT_EQ(set.contains(entry), oracle.contains(entry)) << entry;
    EXPECT_EQ(set.slot(entry).has_value(), oracle.contains(entry)) << entry;
  }
  std::vector<std::size_t> visited;
  set.for_each([&](std::size_t entry) { visited.push_back(entry); });
  EXPECT_EQ(visited, std::vector<std::size_t>(oracle.begin(), oracle.end()));
}

TEST(EntrySet, TakesLittleMemoryForWhatItDoesNotHold) {
  EntrySet set(6'480'000);  // RSID at 0.1 degrees
  set.number();
  EXPECT_EQ(set.count(), 0U);
  EXPECT_LT(set.bytes(), 7000U);
  EntrySet one(6'480'000);
  one.insert(6'479'999);
  one.number();
  EXPECT_EQ(one.slot(6'479'999), 0U);
  EXPECT_LT(one.bytes(), set.bytes() + 1000U);
}

}  // namespace
}  // namespace impinge
