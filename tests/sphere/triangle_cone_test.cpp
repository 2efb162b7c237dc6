// SPDX-License-Identifier: GPL-3.0-or-later
// r(u) = n.v0 / (n.u); r(u) u lies on the plane of the face; tan psi = |n x u| / (n.u).
#include "sphere/triangle_cone.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/directions.hpp"

namespace impinge {
namespace {

const Vec3 kA(20.0, 1.0, 2.0);
const Vec3 kB(18.0, 9.0, -1.0);
const Vec3 kC(19.0, 3.0, 8.0);

TEST(TriangleCone, MeetsConvexCombinationsOfItsCornersAtTheirDistance) {
  for (const TriangleCone& cone : {TriangleCone(kA, kB, kC), TriangleCone(kA, kC, kB)}) {
    for (const Vec3& w : test::random_directions(2000, 3)) {
      const Vec3 share = w.cwiseAbs() / w.cwiseAbs().sum();
      const Vec3 x = share[0] * kA + share[1] * kB + share[2] * kC;
      EXPECT_TRUE(cone.contains(x.normalized()));
      EXPECT_NEAR(cone.radius(x.normalized()), x.norm(), 1e-12);
    }
  }
}

TEST(TriangleCone, LeavesOutWhatIsNotBetweenItsCorners) {
  const TriangleCone cone(kA, kB, kC);
  for (const Vec3& w : test::random_directions(2000, 4)) {
    const Vec3 x = w[0] * kA + w[1] * kB + w[2] * kC;
    EXPECT_EQ(cone.contains(x.normalized()), w.minCoeff() >= 0.0);
  }
}

TEST(TriangleCone, SideFollowsTheOrderOfCorners) {
  EXPECT_EQ(TriangleCone(kA, kB, kC).side(), -TriangleCone(kA, kC, kB).side());
  EXPECT_TRUE(TriangleCone(kA, kB, kA + kB).edge_on());
  EXPECT_FALSE(TriangleCone(kA, kB, kC).edge_on());
}

TEST(TriangleCone, LargestSlopeIsThatOfADenseSample) {
  const TriangleCone cone(kA, kB, kC);
  const Vec3 n = (kB - kA).cross(kC - kA);
  double largest = 0.0;
  for (int i = 0; i <= 200; ++i) {
    for (int j = 0; i + j <= 200; ++j) {
      const Vec3 x = kA + (kB - kA) * (i / 200.0) + (kC - kA) * (j / 200.0);
      largest = std::max(largest, n.cross(x).norm() / std::abs(n.dot(x)));
    }
  }
  EXPECT_NEAR(cone.largest_slope(), largest, 1e-12);
  EXPECT_NEAR(cone.plane_distance(), std::abs(n.dot(kA)) / n.norm(), 1e-12);
}

// A ray that grazes the plane: n.u is rounding noise, the radius still lies between those of the corners.
TEST(TriangleCone, GrazingRadiusIsNoLargerThanTheFarthestCorner) {
  const TriangleCone cone({1.0, 0.0, 1e-17}, {50.0, 1.0, 0.0}, {50.0, -1.0, 0.0});
  for (double x = 1.0; x < 50.0; x += 0.37) {
    const Vec3 u = Vec3(x, 0.0, 0.0).normalized();
    if (!cone.contains(u)) continue;
    EXPECT_GT(cone.radius(u), 0.0);
    EXPECT_LE(cone.radius(u), std::sqrt(2501.0));
  }
}

}  // namespace
}  // namespace impinge
