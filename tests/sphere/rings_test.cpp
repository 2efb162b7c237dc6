// SPDX-License-Identifier: GPL-3.0-or-later
// Schemes on rings of latitude: rings hold the entries in their order, and cells across are those that share
// a gap.
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/schemes/healpix.hpp"
#include "sphere/schemes/latitude_rows.hpp"
#include "sphere/schemes/octahedral_equal_area.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

template <class S>
class Rings : public testing::Test {};
using OnRings = testing::Types<Healpix, LatitudeRows, OctahedralEqualArea>;
TYPED_TEST_SUITE(Rings, OnRings);

TYPED_TEST(Rings, FollowOneAnother) {
  for (const double precision : {90.0, 45.0, 30.0, 5.0}) {
    const auto scheme = TypeParam::with_precision(precision);
    std::size_t next = 0;
    for (std::size_t k = 0; k < scheme.rings(); ++k) {
      const Ring ring = scheme.ring(k);
      EXPECT_EQ(ring.first, next);
      EXPECT_NEAR(scheme.ring_position(std::atan2(ring.polar.sin, ring.polar.cos)), static_cast<double>(k),
                  1e-12);
      for (std::size_t t = 0; t < ring.count; ++t) EXPECT_EQ(scheme.direction(next + t), ring.direction(t));
      next += ring.count;
    }
    EXPECT_EQ(next, scheme.size());
  }
}

template <class S>
class RingCells : public testing::Test {};
using Interpolated = testing::Types<Healpix, LatitudeRows>;
TYPED_TEST_SUITE(RingCells, Interpolated);

// for_each_cell_across(): the cells that share a gap with this one, found by trying directions.
TYPED_TEST(RingCells, AcrossShareAGap) {
  for (const double precision : {90.0, 45.0, 18.0}) {
    const auto scheme = TypeParam::with_precision(precision);
    const auto upper = [](const Stencil& s) { return std::array{s.entry[0], s.entry[1]}; };
    const auto lower = [](const Stencil& s) { return std::array{s.entry[2], s.entry[3]}; };
    const auto is_cap = [&](const Stencil& s) {
      return s.taps == 0 || s.cell == 0 || s.cell == scheme.cells() - 1;
    };
    std::vector<Stencil> cell(scheme.cells());
    for (const Vec3& u : test::random_directions(100000, 70)) {
      const Stencil stencil = scheme.stencil(u);
      cell[stencil.cell] = stencil;
    }
    for (const Stencil& here : cell) {
      if (is_cap(here)) continue;
      std::set<std::size_t> expected;
      for (const Stencil& other : cell) {
        if (is_cap(other)) continue;
        const bool same_rings = scheme.direction(other.entry[0]).z() == scheme.direction(here.entry[0]).z();
        if (same_rings && (upper(other) == upper(here) || lower(other) == lower(here)))
          expected.insert(other.cell);
      }
      std::set<std::size_t> found;
      scheme.for_each_cell_across(here, [&](const Stencil& other) { found.insert(other.cell); });
      EXPECT_EQ(found, expected) << precision << " cell " << here.cell;
    }
  }
}

}  // namespace
}  // namespace impinge
