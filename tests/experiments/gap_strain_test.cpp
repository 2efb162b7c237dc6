// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: a gap g over cartilage of thickness h is a strain of 1 - g / h, 0 from g = h on, 1 from g = 0
// down, and NaN where there is no gap; by place, h is that of the map there.
#include "24_strain/gap_strain.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge::lab {
namespace {

TEST(GapStrain, IsTheOverlapOverTheThickness) {
  EXPECT_EQ(gap_strain(1.0, 4.0), 0.75);
  EXPECT_EQ(gap_strain(4.0, 4.0), 0.0);
  EXPECT_EQ(gap_strain(4.5, 4.0), 0.0);
  EXPECT_EQ(gap_strain(0.0, 4.0), 1.0);
  EXPECT_EQ(gap_strain(-0.5, 4.0), 1.0);
  EXPECT_TRUE(std::isnan(gap_strain(std::numeric_limits<double>::quiet_NaN(), 4.0)));
}

TEST(GapStrain, WithoutCartilageBoneTouchesBoneOrNothing) {
  EXPECT_EQ(gap_strain(1e-300, 0.0), 0.0);
  EXPECT_EQ(gap_strain(0.0, 0.0), 1.0);
}

// Concentric spheres with their ball moved by t along z: the gap of a vertex x of the socket is
// |x| - t cos - root(R^2 - t^2 sin^2), and the strain that over h (1 + z / 2) taken from 1.
TEST(GapStrain, ByPlaceTakesTheThicknessThere) {
  const TriangleMesh socket = sphere(28.0, 200);
  const double t = 1.5;
  CartilageMap map;
  std::vector<double> gap;
  std::vector<double> expected;
  for (const Vec3& x : socket.vertices) {
    const double z = x.normalized().z();
    map.directions.push_back(x.normalized());
    map.thickness.push_back(4.0 * (1.0 + 0.5 * z));
    gap.push_back(28.0 - t * z - std::sqrt(24.0 * 24.0 - t * t * (1.0 - z * z)));
    expected.push_back(std::max(0.0, 1.0 - gap.back() / map.thickness.back()));
  }
  const std::vector<double> strain = gap_strains(gap, socket.vertices, map);
  double largest = 0.0;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    EXPECT_NEAR(strain[i], expected[i], 1e-15);
    largest = std::max(largest, strain[i]);
  }
  EXPECT_NEAR(largest, 1.0 - 2.5 / 6.0, 1e-12) << "at the pole";
}

}  // namespace
}  // namespace impinge::lab
