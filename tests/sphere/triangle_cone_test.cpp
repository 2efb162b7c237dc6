// SPDX-License-Identifier: GPL-3.0-or-later
// r(u) = n.v0 / (n.u); r(u) u lies on the plane of the face; tan psi = |n x u| / (n.u).
#include "sphere/triangle_cone.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sphere/angular_box.hpp"
#include "sphere/schemes/usid.hpp"
#include "sphere/turn_clip.hpp"
#include "sphere/walker.hpp"
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

// A box holds every direction of its triangle, bulge of the great circles and poles included.

bool holds(const AngularBox& box, const Vec3& x) {
  const auto [phi, theta] = to_angles(x);
  if (phi < box.phi_min || phi > box.phi_max) return false;
  if (phi == 0.0 || phi == kPi) return true;
  const double from_left = std::fmod(theta - box.theta_min + 8.0 * kPi, 2.0 * kPi);
  return from_left <= box.theta_width || from_left >= 2.0 * kPi - 1e-12;
}

// Points of the triangle on a grid of 20 by 20 barycentric steps, edges and corners included.
void expect_inside(const std::array<Vec3, 3>& t, double margin) {
  const AngularBox box = angular_box(t, margin);
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; i + j <= 20; ++j) {
      const Vec3 x = t[0] + (t[1] - t[0]) * (i / 20.0) + (t[2] - t[0]) * (j / 20.0);
      ASSERT_TRUE(holds(box, x)) << t[0].transpose() << " | " << t[1].transpose() << " | "
                                 << t[2].transpose();
    }
  }
}

TEST(AngularBox, HoldsRandomTrianglesOfAllSizes) {
  const auto u = test::random_directions(3000, 5);
  for (std::size_t k = 0; k + 2 < u.size(); k += 3) {
    for (const double size : {1e-6, 1e-2, 0.3, 3.0}) {
      expect_inside({u[k], (u[k] + size * u[k + 1]).normalized(), (u[k] + size * u[k + 2]).normalized()},
                    0.0);
    }
  }
}

TEST(AngularBox, HoldsTrianglesAtThePolesAndTheSeam) {
  for (const double z : {1.0, -1.0}) {
    expect_inside({Vec3(0, 0, z), {0.1, 0, z}, {0, 0.1, z}}, 0.0);           // pole a corner
    expect_inside({Vec3(-0.1, 0, z), {0.1, 0, z}, {0, 0.1, z}}, 0.0);        // pole on an edge
    expect_inside({Vec3(-0.1, -0.1, z), {0.1, -0.1, z}, {0, 0.1, z}}, 0.0);  // pole inside
    expect_inside({Vec3(1e-9, 0, z), {0.1, -0.1, z}, {0.1, 0.1, z}}, 0.0);   // pole just outside
  }
  expect_inside({Vec3(1, -0.1, 0), {1, 0.1, 0}, {1, 0, 0.1}}, 0.0);  // across theta = 0
  expect_inside({Vec3(1, 0, 0), {1, 0.1, 0}, {1, 0, 0.1}}, 0.0);     // along it
}

TEST(AngularBox, PoleOfAnotherHemisphereIsNotTakenIn) {
  const AngularBox north = angular_box({Vec3(-0.1, -0.1, 1), {0.1, -0.1, 1}, {0, 0.1, 1}});
  EXPECT_EQ(north.phi_min, 0.0);
  EXPECT_LT(north.phi_max, 0.2);
}

// Every direction within the margin of the triangle is in the box.
TEST(AngularBox, MarginIsAnAngleOnTheSphere) {
  const auto u = test::random_directions(2000, 6);
  for (std::size_t k = 0; k + 3 < u.size(); k += 4) {
    const std::array<Vec3, 3> t{u[k], (u[k] + 0.1 * u[k + 1]).normalized(),
                                (u[k] + 0.1 * u[k + 2]).normalized()};
    for (const double margin : {0.001, 0.05}) {
      const AngularBox box = angular_box(t, margin);
      const Vec3 aside = u[k + 3].cross(t[1]).normalized();
      ASSERT_TRUE(holds(box, std::cos(0.999 * margin) * t[1] + std::sin(0.999 * margin) * aside));
    }
  }
}

// What a turn of a spiral has inside a triangle, or near it, TurnClip keeps.

TriangleCone triangle(const std::vector<Vec3>& u, std::size_t k, double size) {
  return {u[k], (u[k] + size * u[k + 1]).normalized(), (u[k] + size * u[k + 2]).normalized()};
}

// Points of turns with 0.03 radians between them, at every azimuth: those in the cone are in a part.
TEST(TurnClip, KeepsAllThatIsInside) {
  constexpr double kSpacing = 0.03;
  const auto u = test::random_directions(600, 73);
  for (std::size_t k = 0; k + 2 < u.size(); k += 3) {
    const TriangleCone cone = triangle(u, k, k % 2 == 0 ? 0.2 : 2.0);
    if (cone.edge_on()) continue;
    const AngularBox box = angular_box(cone.corners());
    const TurnClip clip(cone, box, {0.0, kSpacing, 0.0});
    for (double phi = box.phi_min; phi <= box.phi_max; phi += kSpacing) {
      const double rise = kSpacing * box.theta_width / (2.0 * kPi);
      const double middle = std::min(phi + 0.5 * rise, kPi);
      for (std::size_t piece = 0; piece < clip.pieces(); ++piece) {
        const TurnClip::Part part = clip.part(piece, {{std::cos(middle), std::sin(middle)}, rise});
        for (double share = 0.005; share < 1.0; share += 0.01) {
          const double turn = clip.azimuth(piece) + share * (clip.azimuth(piece + 1) - clip.azimuth(piece));
          const double polar = std::min(phi + kSpacing * (turn - clip.azimuth(0)), kPi);
          if (!cone.contains(to_direction({polar, 2.0 * kPi * turn}))) continue;
          ASSERT_LE(part.from, share);
          ASSERT_GE(part.to, share);
        }
      }
    }
  }
}

// Why it is there: of the entries that a walker visits nearly all are inside.
TEST(TurnClip, KeepsLittleElse) {
  const Usid helix = Usid::with_precision(0.25);
  const auto u = test::random_directions(300, 74);
  std::size_t visited = 0;
  std::size_t inside = 0;
  for (std::size_t k = 0; k + 2 < u.size(); k += 3) {
    const TriangleCone cone = triangle(u, k, 0.2);
    helix.walker().visit_near(cone, 0.0, [&](const DirectionRun& run) { visited += run.count; });
    for_each_entry_inside(helix.walker(), cone, [&](std::size_t, const Vec3&) { ++inside; });
  }
  EXPECT_LT(static_cast<double>(visited), 1.25 * static_cast<double>(inside));
}

TEST(TurnClip, ClipsNothingWhereThereIsNoTriangle) {
  const Vec3 u = Vec3(1, 2, 3).normalized();
  const TriangleCone point(u, u, u);
  const TurnClip clip(point, angular_box(point.corners(), 0.1), {0.1, 0.03, 0.0});
  const TurnClip::Part part = clip.part(0, {{u.z(), std::hypot(u.x(), u.y())}, 0.0});
  EXPECT_EQ(part.from, 0.0);
  EXPECT_EQ(part.to, 1.0);
}

}  // namespace
}  // namespace impinge
