// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces may have a direction in a cap, and where a surface is missing, against points of the faces and
// rays against all of them.
#include "rotations/seen_surface.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "rotations/mesh_holes.hpp"
#include "support/dice.hpp"
#include "support/random_cases.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

Vec3 moved_by_angle(const Vec3& x, const Vec3& about, double angle) {
  return Eigen::AngleAxisd(angle, about.cross(x).normalized()) * x;
}

// Caps whose border a point of the face just reaches: of fat faces and slivers, by inner points, sides and
// corners.
TEST(SeenSurface, IsNearWhatTouchesTheCap) {
  test::Dice dice(5);
  std::size_t far = 0;
  for (std::size_t round = 0; round < random_cases(); ++round) {
    const double size = dice.power(-4.0, 0.0);
    const Vec3 middle = dice.direction();
    TriangleMesh mesh;
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(30.0 * (middle + size * dice.vector()));
    mesh.faces.push_back({0, 1, 2});
    const SeenSurface surface(mesh, Layer::farthest);
    ASSERT_EQ(surface.faces().size(), 1U);
    Vec3 shares(dice.between(0.0, 1.0), dice.between(0.0, 1.0), dice.between(0.0, 1.0));
    for (std::size_t k = 0; k < round % 3; ++k) shares[dice.whole(0, 2)] = 0.0;
    Vec3 point = shares[0] * mesh.vertices[0] + shares[1] * mesh.vertices[1] + shares[2] * mesh.vertices[2];
    if (point.norm() < 1e-3) continue;
    const double radius = dice.power(-4.0, 0.2);
    const Vec3 axis = moved_by_angle(point.normalized(), dice.direction(), radius * (1.0 - 1e-9));
    EXPECT_TRUE(surface.near(0, {axis, radius})) << round;
    EXPECT_TRUE(surface.any_near({axis, radius})) << round;
    if (!surface.near(0, {dice.direction(), std::min(radius, 0.1)})) ++far;
  }
  EXPECT_GT(far, random_cases() / 4);
}

TEST(MeshHoles, HoldWhatNoFaceCovers) {
  test::Dice dice(6);
  TriangleMesh ball = sphere(20.0, 1000);
  const Vec3 hole = dice.direction();
  std::erase_if(ball.faces, [&](const Face& face) {
    const auto corners = corners_of(ball, face);
    return angle_between(corners[0] + corners[1] + corners[2], hole) < 0.3 || dice.whole(0, 99) == 0;
  });
  const MeshHoles holes = mesh_holes(SeenSurface(ball, Layer::farthest));
  const RayCaster rays(ball);
  const auto covered = [&](const Vec3& u) { return !std::isnan(rays.cast(u, Layer::farthest)); };
  std::size_t missing = 0;
  std::size_t beside = 0;
  for (std::size_t round = 0; round < random_cases(); ++round) {
    const Vec3 u = dice.direction();
    const bool held = std::ranges::any_of(
        holes.caps, [&](const DirectionCap& cap) { return angle_between(cap.axis, u) <= cap.radius; });
    EXPECT_TRUE(held || covered(u)) << u.transpose();
    if (!covered(u)) ++missing;
    if (held && covered(u)) ++beside;
    const DirectionCap& empty = holes.empty[round % holes.empty.size()];
    EXPECT_FALSE(covered(moved_by_angle(empty.axis, u, empty.radius * dice.between(0.0, 1.0))))
        << u.transpose();
  }
  EXPECT_GT(missing, random_cases() / 50);
  EXPECT_LT(beside, missing);  // the caps are not much wider than the holes
}

}  // namespace
}  // namespace impinge
