// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every scheme on a spiral: places are whole at entries, fine tables lose no entry to
// rounding, areas are those between half places, and runs hold the numbers of direction().
#include "sphere/spiral.hpp"

#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/entries_inside.hpp"
#include "sphere/schemes/conchoid.hpp"
#include "sphere/schemes/helix_isotropic.hpp"
#include "sphere/schemes/usid.hpp"
#include "sphere/schemes/usid_arc.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

template <class S>
class Spirals : public testing::Test {};
using All = testing::Types<Usid, UsidArc, HelixIsotropic, Conchoid>;
TYPED_TEST_SUITE(Spirals, All);

// Places of entries in all parts of a table, both ends among them.
template <class S>
std::vector<std::size_t> some_entries(const S& scheme) {
  std::vector<std::size_t> entries;
  for (std::size_t k = 0; k <= 60; ++k) {
    entries.push_back(std::min(k, scheme.size() - 1));
    entries.push_back(scheme.size() - 1 - std::min(k, scheme.size() - 1));
    entries.push_back(scheme.size() / 61 * k);
  }
  return entries;
}

// A triangle with a corner at an entry holds it, whatever the rounding of places, turns and directions.
TYPED_TEST(Spirals, FindEntriesAtCornersOfTriangles) {
  const auto u = test::random_directions(200, 80);
  for (const double precision : {5.0, 0.05, 0.001}) {
    const TypeParam scheme = TypeParam::with_precision(precision);
    std::size_t next = 0;
    for (const std::size_t entry : some_entries(scheme)) {
      const Vec3 corner = scheme.direction(entry);
      const TriangleCone cone(corner, (corner + precision * kDegree * u[next]).normalized(),
                              (corner + precision * kDegree * u[next + 1]).normalized());
      next = (next + 1) % 198;
      std::multiset<std::size_t> found;
      for_each_entry_inside(scheme.walker(), cone, [&](std::size_t i, const Vec3& x) {
        found.insert(i);
        ASSERT_EQ(x, scheme.direction(i));
      });
      if (cone.edge_on()) continue;
      ASSERT_EQ(found.count(entry), 1U) << precision << " entry " << entry;
    }
  }
}

// (w - 1) (1 - cos phi_i) / 2 = i of the thesis' helix: the lookup of Section 4.3 without an error.
TYPED_TEST(Spirals, PlacesAreWholeAtEntriesAndBothPolesAreEntries) {
  for (const double precision : {10.0, 1.0, 0.05}) {
    const TypeParam scheme = TypeParam::with_precision(precision);
    EXPECT_EQ(scheme.direction(0), Vec3(0, 0, 1));
    EXPECT_EQ(scheme.direction(scheme.size() - 1), Vec3(0, 0, -1));
    for (std::size_t i = 0; i < scheme.size(); i += 1 + scheme.size() / 5000) {
      ASSERT_NEAR(scheme.place(to_angles(scheme.direction(i)).phi), static_cast<double>(i),
                  1e-14 * static_cast<double>(scheme.size()));
    }
  }
}

TEST(HelixIsotropic, PrecisionIsTheSpacingBothWays) {
  const HelixIsotropic helix = HelixIsotropic::with_precision(1.0);
  EXPECT_EQ(helix.size(), 41253U);  // square degrees on the sphere
  EXPECT_EQ(helix.equator_points(), 360U);
  EXPECT_NEAR(helix.precision_deg(), 1.0, 1e-4);
  const std::size_t equator = helix.size() / 2;
  EXPECT_NEAR(angle_between(helix.direction(equator), helix.direction(equator + 1)), kDegree, 1e-3 * kDegree);
}

TYPED_TEST(Spirals, AFineTableIsLookedUpAtItsEntries) {
  const TypeParam scheme = TypeParam::with_precision(0.05);
  for (const std::size_t entry : some_entries(scheme)) {
    const Stencil stencil = scheme.stencil(scheme.direction(entry));
    double weight = 0.0;
    for (std::size_t k = 0; k < stencil.taps; ++k)
      weight += stencil.entry[k] == entry ? stencil.weight[k] : 0.0;
    EXPECT_NEAR(weight, 1.0, 1e-6) << entry;
  }
}

// Of a band: 2 pi (cos phi(t - 1/2) - cos phi(t + 1/2)), with the place t an entry's number.
TYPED_TEST(Spirals, AreasAreThoseBetweenHalfPlaces) {
  const TypeParam scheme = TypeParam::with_precision(3.0);
  for (const std::size_t entry : some_entries(scheme)) {
    const auto cosine = [&](double t) {
      double low = 0.0;
      double high = kPi;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (scheme.place(middle) < t ? low : high) = middle;
      }
      return std::cos(high);
    };
    const auto i = static_cast<double>(entry);
    const double expected = 2.0 * kPi * (cosine(i - 0.5) - cosine(i + 0.5));
    EXPECT_NEAR(scheme.area(entry), expected, 1e-13) << entry;
  }
}

TYPED_TEST(Spirals, EqualOnesAreEqual) {
  const TypeParam scheme = TypeParam::with_precision(3.0);
  EXPECT_EQ(scheme, TypeParam::with_precision(3.0));
  EXPECT_NE(scheme, TypeParam::with_precision(2.0));
}

}  // namespace
}  // namespace impinge
