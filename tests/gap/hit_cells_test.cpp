// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: every cell that a direction of the cone is in is found, each once, and few others
#include "gap/simd/hit_cells.hpp"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "gap/simd/seen_planes.hpp"
#include "mesh/bodies.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/uniform_directions.hpp"

namespace impinge {
namespace {

// The entry that the cell of x begins at.
std::uint32_t cell_of(const CubeGnomonic& scheme, const Vec3& x) {
  return static_cast<std::uint32_t>(scheme.stencil(x).entry[0]);
}

Vec3 some_direction(const std::array<Vec3, 3>& corners, std::mt19937_64& random) {
  const double a = uniform(random);
  const double b = uniform(random) * (1.0 - a);
  return a * corners[0] + b * corners[1] + (1.0 - a - b) * corners[2];
}

TEST(CellsMet, HoldEveryDirectionOfTheConeAndFewMore) {
  std::mt19937_64 random(9);
  std::size_t found = 0;
  std::size_t needed = 0;
  for (int round = 0; round < 200; ++round) {
    const double size = round % 4 == 0 ? 1.5 : round % 4 == 1 ? 0.3 : 0.03;
    const Vec3 u = uniform_direction(random);
    std::array<Vec3, 3> corners;
    for (Vec3& v : corners)
      v = (5.0 + 20.0 * uniform(random)) * (u + size * uniform_direction(random)).normalized();
    const auto scheme = CubeGnomonic::with_precision(90.0 / 20.0);
    std::vector<std::uint32_t> cells;
    add_hit_cells({20, 1e-6}, TriangleCone(corners[0], corners[1], corners[2]), cells);
    const std::set<std::uint32_t> once(cells.begin(), cells.end());
    EXPECT_EQ(once.size(), cells.size());
    std::set<std::uint32_t> seen;
    for (int k = 0; k < 2000; ++k) seen.insert(cell_of(scheme, some_direction(corners, random)));
    for (std::size_t k = 0; k < 3 * 500; ++k) {
      const double share = static_cast<double>(k / 3) / 500.0;
      seen.insert(cell_of(scheme, corners[k % 3] + share * (corners[(k + 1) % 3] - corners[k % 3])));
    }
    EXPECT_TRUE(std::ranges::includes(once, seen));
    if (size > 1.0) continue;  // too large for so few directions to be in every cell
    found += once.size();
    needed += seen.size();
  }
  EXPECT_LT(static_cast<double>(found), 1.1 * static_cast<double>(needed));
}

TEST(CellsMet, WiderByTheMargin) {
  std::vector<std::uint32_t> cells;
  const Vec3 x(1.0, 0.05, 0.05);  // in the cell behind the middle of a face, a quarter from its sides
  add_hit_cells({20, 0.4}, TriangleCone(x, x, x), cells);
  EXPECT_EQ(cells.size(), 1U);
  cells.clear();
  add_hit_cells({20, 0.6}, TriangleCone(x, x, x), cells);
  EXPECT_EQ(cells.size(), 9U);
}

// Two faces over one edge, the far corner of the second above or below the plane of the first.
TEST(SeenPlanes, BendOneWayOrTheOther) {
  const auto bend = [](double height) {
    const TriangleMesh mesh{{{0, 0, 20}, {1, 0, 20}, {0, 1, 20}, {1, 1, height}}, {{0, 1, 2}, {1, 3, 2}}};
    const std::vector<std::uint32_t> both{0, 1};
    return bend_of({mesh, seen_planes(mesh)}, both);
  };
  EXPECT_EQ(bend(19.0), 1);
  EXPECT_EQ(bend(21.0), -1);
  EXPECT_EQ(bend(20.0), 1);
  const TriangleMesh layers{{{0, 0, 20}, {1, 0, 20}, {0, 1, 20}, {0, 0, 21}, {1, 0, 19}, {0, 1, 21}},
                            {{0, 1, 2}, {3, 4, 5}}};
  const std::vector<std::uint32_t> both{0, 1};
  EXPECT_FALSE(bend_of({layers, seen_planes(layers)}, both));
  const TriangleMesh steep{{{20, 0, 0.1}, {0, 20, 0.1}, {-20, -20, 0.1}}, {{0, 1, 2}}};
  const std::vector<std::uint32_t> alone{0};
  EXPECT_FALSE(bend_of({steep, seen_planes(steep)}, alone));
}

}  // namespace
}  // namespace impinge
