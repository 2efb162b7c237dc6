// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: every corner of a cell with an answer is within step / 2 + u smallest of the number it was made
// from; the cells without an answer are the same; the kernel has
// no answer where the scalar look-up has none, but within rounding of a grid line; and
//   |gap of the kernel - gap of the scalar look-up in what is stored|
//     <= u (20 (r + |x|) + 5 Q r + 13 m D) + 2^-15 D
#include "gap/simd/corner_table.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "gap/corner_fixture.hpp"
#include "mesh/generated_pair.hpp"
#include "table/exact_raster.hpp"
#include "table/packed_fixture.hpp"

namespace impinge {
namespace {

using Cube = InverseDepthTable<CubeGnomonic>;
using Rows = PackedTable<CubeGnomonic, float>;
using test::lower;
using test::stored_radii;
using test::upper;

constexpr double kFloatUnit = 0x1p-24;

bool answers(const Rows& rows, std::size_t entry) {
  return rows.none.empty() || (rows.none[entry / 32] >> (entry % 32) & 1U) == 0U;
}

// Visits the entry that each cell begins at.
template <class Visit>
void for_each_cell(std::size_t n, const Visit& visit) {
  for (std::size_t row = 0; row < 6 * (n + 1); ++row)
    for (std::size_t column = 0; column < n && row % (n + 1) != n; ++column) visit(row * (n + 1) + column);
}

void expect_stored(const Rows& rows) {
  const CornerTable table = corner_table(rows);
  ASSERT_EQ(table.words.size(), rows.values.size());
  EXPECT_EQ(table.bytes(), 4 * rows.values.size());
  const double most = 0.5 * static_cast<double>(table.step) * (1.0 + 1e-6) +
                      4.0 * kFloatUnit * static_cast<double>(table.smallest);
  for_each_cell(rows.divisions, [&](std::size_t entry) {
    EXPECT_EQ((table.words[entry] & CornerTable::kNone) == 0U, answers(rows, entry));
    if (!answers(rows, entry)) return;
    for (const std::size_t e : {entry, entry + 1}) {
      EXPECT_NEAR(upper(table, e), static_cast<double>(rows.values[e]), most);
      EXPECT_NEAR(lower(table, e), static_cast<double>(rows.values[e + rows.stride]), most);
      EXPECT_EQ(lower(table, e), upper(table, e + rows.stride));
    }
  });
}

TEST(CornerTableTest, KeepsNumbersToHalfAStepAndTheCellsThatAnswer) {
  for (const double precision : {30.0, 3.0}) {
    expect_stored(packed_table<float>(test::bumpy_table<CubeGnomonic>(precision)));
    const BallSocketPair pair = make_ball_socket_pair(1000);
    const auto scheme = CubeGnomonic::with_precision(precision);
    expect_stored(packed_table<float>(fill_exact(pair.socket, scheme, Layer::nearest)));
    expect_stored(packed_table<float>(fill_exact(pair.ball, scheme, Layer::farthest)));
  }
}

// One number everywhere, and no surface at all.
TEST(CornerTableTest, HoldsANumberThatIsTheSameEverywhereAndNothing) {
  Rows rows = packed_table<float>(test::bumpy_table<CubeGnomonic>(30.0));
  for (float& value : rows.values) value = 0.05F;
  expect_stored(rows);
  rows.none.assign(rows.values.size() / 32 + 1, ~0U);
  const CornerTable nothing = corner_table(rows);
  std::vector<float> gap(3);
  scan_gaps(nothing, packed_vertices<float>(test::random_directions(3, 1)), {}, Surface::ball, gap);
  for (const float value : gap) EXPECT_TRUE(std::isnan(value));
}

// Within rounding of x, is there an answer (or none) as the kernel says?
bool said_close_by(const Cube& table, const Vec3& x, bool none) {
  return std::ranges::any_of(test::close_to(x, 64.0 * kFloatUnit),
                             [&](const Vec3& near) { return std::isnan(table.radius_at(near)) == none; });
}

TEST(CornerTableTest, AnswersAsTheScalarTable) {
  for (const double precision : {10.0, 1.5}) {
    const auto from = test::bumpy_table<CubeGnomonic>(precision);
    const CornerTable table = corner_table(packed_table<float>(from));
    const auto radii = stored_radii(table, from);
    const Cube scalar(radii);
    const auto points = test::float_points(radii.scheme());
    std::vector<float> gap(points.size());
    scan_gaps(table, packed_vertices<float>(points), {}, Surface::ball, gap);
    const double m = static_cast<double>(table.divisions);
    std::size_t none = 0;
    std::size_t otherwise = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double radius = scalar.radius_at(points[i]);
      const double length = points[i].norm();
      none += std::isnan(gap[i]) ? 1U : 0U;
      if (std::isnan(gap[i]) != std::isnan(radius)) {
        ++otherwise;
        EXPECT_TRUE(said_close_by(scalar, points[i], std::isnan(gap[i]))) << points[i].transpose();
      }
      if (std::isnan(gap[i]) || std::isnan(radius)) continue;
      const double steps = test::steps_at(radii, points[i], 16.0 * kFloatUnit, radius);
      const double bound =
          kFloatUnit * (20.0 * (radius + length) + 5.0 * 3.0 * radius + 13.0 * steps) + 0x1p-15 * steps / m;
      ASSERT_NEAR(gap[i], radius - length, bound) << points[i].transpose();
    }
    EXPECT_GT(none, 100U);
    EXPECT_LT(otherwise, points.size() / 100);
  }
}

}  // namespace
}  // namespace impinge
