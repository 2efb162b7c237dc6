// SPDX-License-Identifier: GPL-3.0-or-later
// The files behind Figures 47 and 48: every point is on the unit sphere, and on the helix where it should be.
#include "06_helix_placement/helix_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace impinge::lab {
namespace {

double number(const Cell& cell) { return std::stod(cell.text()); }

Vec3 last_three(const std::vector<Cell>& row) {
  const std::size_t n = row.size();
  return {number(row[n - 3]), number(row[n - 2]), number(row[n - 1])};
}

// theta = 2 k phi modulo a turn.
void expect_on_helix(const Vec3& u, double turns) {
  EXPECT_NEAR(u.norm(), 1.0, 1e-14);
  const auto [phi, theta] = to_angles(u);
  const double off = std::remainder(2.0 * turns * phi - theta, 2.0 * kPi);
  EXPECT_NEAR(off * std::sin(phi), 0.0, 1e-12);
}

TEST(HelixDrawing, CurveAndEntriesAreOnTheHelix) {
  constexpr std::array<std::size_t, 2> turns{10, 20};
  const Result result = helix_curve(turns);
  std::size_t entries = 0;
  for (const auto& row : result.table.rows) {
    expect_on_helix(last_three(row), number(row[0]));
    if (row[1].text() == "entry") ++entries;
  }
  EXPECT_EQ(entries, 100U + 400U);
}

TEST(HelixDrawing, NeighboursAreOnTheHelixAndThePathEndsInPb) {
  const Vec3 vertex = to_direction({0.9, 0.6});
  const Result result = helix_neighbours_of(10, vertex);
  Vec3 below = Vec3::Zero();
  for (const auto& row : result.table.rows) {
    if (row[0].text() == "P_b") below = last_three(row);
    if (row[0].text() != "vertex") expect_on_helix(last_three(row), 10.0);
  }
  EXPECT_LT((last_three(result.table.rows.back()) - below).norm(), 1e-12);
  EXPECT_EQ(result.table.rows.back()[0].text(), "path");
  EXPECT_LT((last_three(result.table.rows.front()) - vertex).norm(), 1e-15);
}

TEST(HelixDrawing, RefusesAVertexWithThreeNeighbours) {
  EXPECT_THROW(helix_neighbours_of(10, {0.001, 0.001, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge::lab
