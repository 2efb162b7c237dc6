// SPDX-License-Identifier: GPL-3.0-or-later
// What culling rests on:
//   a node holds the directions and the radii of all its items
//   within(x, angle): every radius of the surface along u, angle(u, x) <= angle, is beyond the limit
#include "contact/cap_limits.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "contact/cap_lanes.hpp"
#include "mesh/bodies.hpp"
#include "support/cap_nodes.hpp"
#include "support/directions.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

Vec3 axis_of(const CapBlock& block, std::size_t lane) {
  return {block.x[lane], block.y[lane], block.z[lane]};
}

TEST(CapTree, EveryNodeHoldsItsItems) {
  std::vector<CapItem> items;
  for (const Vec3& u : test::random_directions(3000, 31)) {
    const double low = 20.0 + u.x();
    items.push_back({{u, 0.02 * (1.0 + u.y())}, {low, low + 0.1 * (1.0 + u.z())}});
  }
  const CapTree tree(items);
  std::vector<std::uint32_t> all;
  std::size_t nodes = 0;
  test::for_each_node(tree, [&](const CapNode& node, const CapBlock& block, std::size_t lane) {
    ++nodes;
    const auto below = test::items_below(tree, node);
    if (node.block == 0) all.insert(all.end(), below.begin(), below.end());
    for (const std::uint32_t k : below) {
      const CapItem& item = items[tree.order()[k]];
      const double away = angle_between(axis_of(block, lane), item.cap.axis) + item.cap.radius;
      EXPECT_LE(std::min(away, kPi), block.angle[lane]);
      EXPECT_LE(block.low[lane], item.range.low);
      EXPECT_GE(block.high[lane], item.range.high);
    }
  });
  EXPECT_LT(nodes, items.size() + items.size() / 2);
  std::ranges::sort(all);
  std::vector<std::uint32_t> every(items.size());
  std::iota(every.begin(), every.end(), 0U);
  EXPECT_EQ(all, every);
}

// The caps of leaves are little wider than their cells.
TEST(CapTree, CapsShrink) {
  std::vector<CapItem> items;
  for (const Vec3& u : test::random_directions(3000, 32)) items.push_back({{u, 0.0}, {20.0, 20.0}});
  test::for_each_node(CapTree(items), [&](const CapNode& node, const CapBlock& block, std::size_t lane) {
    EXPECT_LT(block.angle[lane], block.leaf(node.lane) ? 0.2F : 4.0F);
  });
}

// What kernels find for a single vertex in a direction.
float alone(const CapLimits& limits, const Vec3& u) {
  MovedCaps caps;
  caps.x.fill(static_cast<float>(u.x()));
  caps.y.fill(static_cast<float>(u.y()));
  caps.z.fill(static_cast<float>(u.z()));
  caps.angle.fill(0.0F);
  const CapLevels levels = limits.levels();
  lanes::WholeLanes steps;
  steps.fill(levels.steps[lanes::levels_of(caps.angle, levels)[0]]);
  return levels.limits[lanes::entries_of(caps, steps)[0]];
}

class LimitsOf : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Faces, LimitsOf, ::testing::Values(8, 200, 1500));

TEST_P(LimitsOf, AreKeptInEveryCap) {
  const TriangleMesh mesh = test::bumpy(GetParam());
  const CapLimits low(mesh, Layer::nearest);
  const CapLimits high(mesh, Layer::farthest);
  const RayCaster rays(mesh);
  const auto ways = test::random_directions(400, 33);
  const auto asides = test::random_directions(400, 34);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const double angle = std::pow(10.0, -4.0 + 4.4 * static_cast<double>(k) / 400.0);
    const Vec3 aside = (asides[k] - asides[k].dot(ways[k]) * ways[k]).normalized();
    for (const double share : {0.0, 0.5, 1.0}) {
      const auto radius = [&](double way) {
        return rays.cast((std::cos(way) * ways[k] + std::sin(way) * aside).normalized(), Layer::nearest);
      };
      const double wide = radius(share * angle);
      EXPECT_LE(low.within(ways[k], static_cast<float>(angle)), wide);
      EXPECT_GE(high.within(ways[k], static_cast<float>(angle)), wide);
    }
    const double here = rays.cast(ways[k], Layer::nearest);
    EXPECT_LE(alone(low, ways[k]), here);
    EXPECT_GE(alone(high, ways[k]), here);
  }
}

// The finest levels holds 6e6 limits and more: kernels find the last of them, too. Along +x of a face of n
// cells that is the entry (n / 2) (n + 1) + n / 2.
TEST(CapLimits, KernelsReachTheEndOfManyLevels) {
  constexpr std::uint32_t kPlace = 8'000'000;
  constexpr std::uint32_t kCells = 510;
  MovedCaps caps;
  caps.x.fill(20.0F);
  caps.y.fill(0.0F);
  caps.z.fill(0.0F);
  lanes::WholeLanes steps;
  steps.fill(static_cast<std::int32_t>((kPlace << CapLimits::kLineBits) + kCells));
  for (const std::int32_t entry : lanes::entries_of(caps, steps))
    EXPECT_EQ(entry, static_cast<std::int32_t>(kPlace + kCells / 2 * (kCells + 1) + kCells / 2));
}

// Small caps of a fine mesh have limits that are worth something: a radius changes by 2 mm a radian, over the
// cap, the way to an entry and a face.
TEST(CapLimits, AreTightInSmallCaps) {
  const TriangleMesh mesh = sphere(22.0, 3000, Vec3(2.0, 0.0, 0.0));
  const CapLimits limits(mesh, Layer::nearest);
  const RayCaster rays(mesh);
  for (const Vec3& u : test::random_directions(200, 35)) {
    const double radius = rays.cast(u, Layer::nearest);
    EXPECT_GT(limits.within(u, 0.05F), radius - 2.0 * (0.25 + 0.101 + 0.2));
    EXPECT_GT(alone(limits, u), radius - 2.0 * (0.0505 + 0.2));
  }
}

TEST(CapLimits, WhereThereIsNoSurfaceThereIsNoLimit) {
  const TriangleMesh mesh = cup(20.0, 30.0, 500);
  const Vec3 away = -Vec3::UnitZ();
  EXPECT_EQ(CapLimits(mesh, Layer::nearest).within(away, 0.2F), HUGE_VALF);
  EXPECT_EQ(CapLimits(mesh, Layer::farthest).within(away, 0.2F), -HUGE_VALF);
  EXPECT_LT(CapLimits(mesh, Layer::nearest).within(away, 2.7F), 20.1F);
  EXPECT_LT(CapLimits(mesh, Layer::nearest).within(Vec3::Zero(), HUGE_VALF), 20.1F);
  EXPECT_EQ(alone(CapLimits({}, Layer::nearest), away), HUGE_VALF);
}

}  // namespace
}  // namespace impinge
