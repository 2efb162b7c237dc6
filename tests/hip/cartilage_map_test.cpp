// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: t(u) is the map's own value at its directions, the mean of the four nearest weighted by 1 / d^2
// elsewhere, so between their smallest and largest; a gap g > 0 becomes g / t(u), a gap g <= 0 stays.
#include "hip/cartilage_map.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

CartilageMap smooth_map(std::size_t faces) {
  CartilageMap map;
  for (const Vec3& v : sphere(1.0, faces).vertices) {
    map.directions.push_back(v.normalized());
    map.thickness.push_back(2.0 + v.z());
  }
  return map;
}

TEST(CartilageMap, GivesItsOwnValuesBack) {
  const CartilageMap map = smooth_map(500);
  for (std::size_t i = 0; i < map.directions.size(); ++i)
    EXPECT_EQ(thickness_at(map, 7.0 * map.directions[i]), thickness_at(map, map.directions[i]));
  EXPECT_EQ(thickness_at(map, map.directions[3]), map.thickness[3]);
}

// Neighbours of a map of 2000 directions are 0.08 apart, and the thickness changes by 1 a radian.
TEST(CartilageMap, IsCloseToASmoothThickness) {
  const CartilageMap map = smooth_map(4000);
  for (const Vec3& u : test::random_directions(500, 3)) EXPECT_NEAR(thickness_at(map, u), 2.0 + u.z(), 0.08);
}

// Four directions at equal distances: their mean; and with 1 / d^2 by hand.
TEST(CartilageMap, WeighsByTheInverseSquare) {
  const CartilageMap cross{{Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY()},
                           {1.0, 2.0, 3.0, 6.0}};
  EXPECT_NEAR(thickness_at(cross, Vec3::UnitZ()), 3.0, 1e-15);
  const Vec3 u(0.6, 0.0, 0.8);  // squared distances 0.8, 3.2, 2, 2
  const double weights = 1.0 / 0.8 + 1.0 / 3.2 + 0.5 + 0.5;
  EXPECT_NEAR(thickness_at(cross, u), (1.0 / 0.8 + 2.0 / 3.2 + 1.5 + 3.0) / weights, 1e-14);
}

TEST(CartilageMap, OfFewerThanFourDirectionsWorks) {
  EXPECT_EQ(thickness_at({{Vec3::UnitX()}, {2.5}}, -Vec3::UnitX()), 2.5);
  EXPECT_EQ(thickness_at({{Vec3::UnitX(), Vec3::UnitY()}, {1.0, 3.0}}, Vec3::UnitZ()), 2.0);
}

TEST(CartilageMap, SharesOfTheThickness) {
  const CartilageMap map{{Vec3::UnitX(), -Vec3::UnitX()}, {2.0, 0.0}};
  const std::vector<double> gap{3.0, 0.5, 0.0, -1.5, std::numeric_limits<double>::quiet_NaN(), 1.0};
  const std::vector<Vec3> places{Vec3(9, 0, 0), Vec3(8, 0, 0), Vec3(8, 0, 0),
                                 Vec3(8, 0, 0), Vec3(8, 0, 0), Vec3(-8, 0, 0)};
  const std::vector<double> share = shares_of_cartilage(gap, places, map);
  EXPECT_EQ(share[0], 1.5);
  EXPECT_EQ(share[1], 0.25);
  EXPECT_EQ(share[2], 0.0);
  EXPECT_EQ(share[3], -1.5);
  EXPECT_TRUE(std::isnan(share[4]));
  EXPECT_TRUE(std::isinf(share[5]));
}

}  // namespace
}  // namespace impinge
