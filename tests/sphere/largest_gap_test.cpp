// SPDX-License-Identifier: GPL-3.0-or-later
// The largest gap against all circles through three entries, on points at random and where many lie on one
// circle, on one great circle with two others, or in one place.
#include "sphere/largest_gap.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/dice.hpp"

namespace impinge {
namespace {

using test::Dice;

double nearest(const std::vector<Vec3>& entries, const Vec3& x) {
  double least = kPi;
  for (const Vec3& entry : entries)
    least = std::min(least, 2.0 * std::asin(std::min(0.5 * (entry - x).norm(), 1.0)));
  return least;
}

// Of the middles of these circles, those that have no entry nearer by more than rounding.
double gap_of_all_circles(const std::vector<Vec3>& entries, double z_min) {
  double largest = 0.0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (std::size_t j = i + 1; j < entries.size(); ++j) {
      for (std::size_t k = j + 1; k < entries.size(); ++k) {
        const Vec3 normal = (entries[j] - entries[i]).cross(entries[k] - entries[i]);
        if (normal.norm() < 1e-9) continue;
        const Vec3 middle = (normal.dot(entries[i]) < 0.0 ? -1.0 : 1.0) * normal.normalized();
        const double radius = nearest({entries[i]}, middle);
        if (middle.z() >= z_min && radius > largest && nearest(entries, middle) > radius - 1e-9)
          largest = radius;
      }
    }
  }
  return largest;
}

std::vector<Vec3> at_random(Dice& random, std::size_t count) {
  std::vector<Vec3> entries;
  for (std::size_t k = 0; k < count; ++k) entries.push_back(random.direction());
  return entries;
}

// `poles`: both of them, as often as there are columns; otherwise a ring round each.
std::vector<Vec3> in_rows(int rows, int columns, bool poles) {
  std::vector<Vec3> entries;
  for (int row = 0; row < rows + (poles ? 1 : 0); ++row) {
    for (int k = 0; k < columns; ++k) {
      const double phi = kPi * (row + (poles ? 0.0 : 0.5)) / rows;
      const double theta = 2.0 * kPi * k / columns;
      entries.emplace_back(std::sin(phi) * std::cos(theta), std::sin(phi) * std::sin(theta), std::cos(phi));
    }
  }
  return entries;
}

// Those of a grid of 3 or 5 points a side on a cube.
std::vector<Vec3> on_cube(int half) {
  std::vector<Vec3> entries;
  for (int x = -half; x <= half; ++x) {
    for (int y = -half; y <= half; ++y) {
      for (int z = -half; z <= half; ++z) {
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == half)
          entries.push_back(Vec3(x, y, z).normalized());
      }
    }
  }
  return entries;
}

void expect_as_all_circles(const std::vector<Vec3>& entries, double z_min) {
  const double gap = gap_of_all_circles(entries, z_min);
  if (gap > 0.5 * kPi - 1e-6) return;  // no promise
  const double all = gap_of_all_circles(entries, -1.0);
  for (const double reach : {kPi, 1.2 * all, all * (1.0 + 1e-9)})
    EXPECT_NEAR(largest_gap(entries, z_min, reach), gap, 1e-12) << entries.size() << " reach " << reach;
}

TEST(LargestGap, IsThatOfAllCirclesThroughThree) {
  Dice random(1);
  for (std::size_t k = 0; k < 60; ++k) {
    std::vector<Vec3> entries = at_random(random, 4 + k % 20);
    if (k % 3 == 0) entries.insert(entries.end(), {entries[0], entries[1], entries[0]});
    expect_as_all_circles(entries, k % 2 == 0 ? -1.0 : random.between(-0.9, 0.9));
  }
}

TEST(LargestGap, HoldsWhereManyLieOnOneCircle) {
  Dice random(2);
  std::vector<std::vector<Vec3>> all{on_cube(1), on_cube(2)};
  for (const bool poles : {false, true}) {
    for (int rows = 2; rows < 6; ++rows) all.push_back(in_rows(rows, rows + 3, poles));
  }
  for (std::vector<Vec3>& entries : all) {
    expect_as_all_circles(entries, -1.0);
    for (int turn = 0; turn < 5; ++turn) {
      const Eigen::Matrix3d rotation = random.rotation();
      for (Vec3& x : entries) x = rotation * x;
      expect_as_all_circles(entries, -1.0);
      expect_as_all_circles(entries, -0.3);
    }
  }
}

}  // namespace
}  // namespace impinge
