// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms: about its own centre a sphere is faced squarely and gap and distance are one; outside a plane
// met at psi the gap is 1 / cos psi times the distance.
#include "10_euclidean/distance_study.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge::lab {
namespace {

TEST(DistanceStudy, ASphereIsFacedSquarely) {
  const TriangleMesh ball = sphere(26.0, 4000);
  const auto shares = distance_shares(ball, sphere(22.0, 200).vertices);
  ASSERT_EQ(shares.size(), 4U);
  EXPECT_EQ(shares[0].zone, "facing");
  EXPECT_EQ(shares[0].gap.size(), 102U);
  for (const double ratio : shares[0].gap) EXPECT_NEAR(ratio, 1.0, 0.01);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_TRUE(shares[k].gap.empty());
}

TEST(DistanceStudy, AnglesAndRimsSetPointsApart) {
  const TriangleMesh plane{{{40, -20, 10}, {0, 80, 10}, {-40, -20, 10}}, {{0, 1, 2}}};
  const double psi = std::acos(1.0 / std::sqrt(3.0));
  const Vec3 off(9.0, -9.95, 5.0);  // whose ray ends just inside the side y = -20
  const auto found = distance_shares(plane, std::vector<Vec3>{{0, 0, 9.5}, {9, 9, 9}, off});
  ASSERT_EQ(found[0].gap.size(), 1U);
  EXPECT_NEAR(found[0].gap[0], 1.0, 1e-12);
  ASSERT_EQ(found[2].gap.size(), 1U);
  EXPECT_NEAR(found[2].gap[0], 1.0 / std::cos(psi), 1e-12);
  ASSERT_EQ(found[3].gap.size(), 1U);
  EXPECT_NEAR(found[3].gap[0], off.norm() / 5.0, 1e-12) << "the gap is |x|, the plane is 5 mm above";
}

}  // namespace
}  // namespace impinge::lab
