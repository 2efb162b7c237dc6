// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of a level hold every rotation once; no rotation of a cell is farther than its radius; shares are
// Haar's measure; sides meet sides.
#include "rotations/rotation_cells.hpp"

#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/random_cases.hpp"

namespace impinge {
namespace {

Quaternion4 random_quaternion(std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  Quaternion4 q;
  for (double& x : q) x = normal(engine);
  return q.normalized();
}

RotationCell random_cell(std::mt19937_64& engine, std::uint32_t finest) {
  const auto level = std::uniform_int_distribution<std::uint32_t>(0, finest)(engine);
  return {level,
          std::uniform_int_distribution<std::uint64_t>(0, (std::uint64_t{4} << (3 * level)) - 1)(engine)};
}

TEST(RotationCells, SharesSumToOne) {
  for (const std::uint32_t level : {0U, 1U, 4U, 5U}) {
    double sum = 0.0;
    for (std::uint64_t number = 0; number < (std::uint64_t{4} << (3 * level)); ++number)
      sum += share({level, number});
    EXPECT_NEAR(sum, 1.0, kShareError) << level;
  }
}

// 1 - sin(a) / a of a turn by up to 2 a is what Haar's measure gives to angles up to 2 a: rotations drawn at
// random fall into a cell as often as its share says.
TEST(RotationCells, SharesAreThoseOfRandomRotations) {
  std::mt19937_64 engine(7);
  constexpr std::size_t kDraws = 200000;
  std::vector<std::size_t> found(4 * 64);
  for (std::size_t k = 0; k < kDraws; ++k) ++found[cell_of(random_quaternion(engine), 2).number];
  for (std::uint64_t number = 0; number < found.size(); ++number) {
    const double expected = share({2, number}) * kDraws;
    EXPECT_NEAR(static_cast<double>(found[number]), expected, 6.0 * std::sqrt(expected));
  }
}

TEST(RotationCells, HoldWhatTheyAreFoundFor) {
  std::mt19937_64 engine(8);
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Quaternion4 q = random_quaternion(engine);
    const auto level = static_cast<std::uint32_t>(k % (kFinestCells + 1));
    const RotationCell cell = cell_of(q, level);
    const Quaternion4 middle = centre(cell);
    Eigen::Index cube = 0;
    middle.cwiseAbs().maxCoeff(&cube);
    const double side = std::ldexp(1.0, -static_cast<int>(level));
    EXPECT_LE((q / q[cube] - middle).cwiseAbs().maxCoeff(), side * (1.0 + 1e-9));
    const Eigen::AngleAxisd turn(rotation_of(middle).transpose() * rotation_of(q));
    EXPECT_LE(turn.angle(), angular_radius(cell));
    if (level > 0) {
      EXPECT_EQ(parent(cell), cell_of(q, level - 1));
    }
  }
}

// The farthest of a fine grid of points of a cell, by the angle of the matrices.
TEST(RotationCells, RadiusIsTheLeast) {
  std::mt19937_64 engine(9);
  for (int round = 0; round < 30; ++round) {
    const RotationCell cell = random_cell(engine, 8);
    const Eigen::Quaterniond middle(rotation_of(centre(cell)));
    double farthest = 0.0;
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        for (int k = -4; k <= 4; ++k) {
          const Quaternion4 q = point_of(cell, {0.25 * i, 0.25 * j, 0.25 * k});
          farthest = std::max(
              farthest, middle.angularDistance(Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized()));
        }
      }
    }
    EXPECT_LE(farthest, angular_radius(cell));
    EXPECT_NEAR(farthest, angular_radius(cell), 1e-7);
  }
}

TEST(RotationCells, SidesMeetSides) {
  std::mt19937_64 engine(10);
  for (std::size_t round = 0; round < random_cases(); ++round) {
    const RotationCell cell = random_cell(engine, 9);
    for (std::size_t side = 0; side < 6; ++side) {
      const RotationCell other = beside(cell, side);
      std::array<double, 3> along{0.2, 0.4, -0.3};  // not along a diagonal
      along[side / 2] = (side % 2 == 1 ? 1.0 : -1.0) * (1.0 + 1e-6);
      EXPECT_EQ(cell_of(point_of(cell, along), cell.level), other) << side;
      std::size_t back = 0;
      for (std::size_t of = 0; of < 6; ++of) back += beside(other, of) == cell ? 1U : 0U;
      EXPECT_EQ(back, cell.level == 0 ? back : 1U);
    }
  }
}

}  // namespace
}  // namespace impinge
