// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/probe_directions.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge {
namespace {

// Each of equal boxes in (z, theta), which have equal areas, gets its share.
TEST(ProbeDirections, UniformOnesFillEqualAreasEqually) {
  constexpr std::size_t count = 64000;
  std::array<std::size_t, 64> boxes{};
  for (const Vec3& u : uniform_directions(count, 3)) {
    ASSERT_NEAR(u.norm(), 1.0, 4e-16);
    const auto row = std::min<std::size_t>(static_cast<std::size_t>(4.0 * (1.0 + u.z())), 7);
    const auto column = static_cast<std::size_t>(4.0 * to_angles(u).theta / kPi);
    ++boxes[8 * row + column];
  }
  // 1000 expected, with a standard deviation of 31.
  for (const std::size_t box : boxes) EXPECT_NEAR(static_cast<double>(box), 1000.0, 160.0);
}

TEST(ProbeDirections, TheSeedDecides) {
  EXPECT_EQ(uniform_directions(100, 1), uniform_directions(100, 1));
  EXPECT_NE(uniform_directions(100, 1), uniform_directions(100, 2));
  // The generator's own numbers, not those of a distribution: the same with every standard library.
  EXPECT_NEAR(uniform_directions(1, 5489)[0].z(), 2.0 * 0.786820954867802 - 1.0, 1e-12);
}

TEST(ProbeDirections, FeaturesAreAllVerticesAndEdges) {
  const TriangleMesh mesh = sphere(22.0, 200, {3.0, -1.0, 2.0});
  const auto features = feature_directions(mesh);
  ASSERT_EQ(features.size(), mesh.vertices.size() + 300);  // 3/2 edges a face of a closed mesh
  std::size_t found = 0;
  for (const Face& face : mesh.faces) {
    const Vec3 middle = (corner(mesh, face, 0) + corner(mesh, face, 1)).normalized();
    found +=
        std::ranges::any_of(features, [&](const Vec3& u) { return (u - middle).norm() < 1e-15; }) ? 1U : 0U;
  }
  EXPECT_EQ(found, mesh.faces.size());
}

TEST(ProbeDirections, PolarOnesFillBothCapsEqually) {
  constexpr double within = 0.05;
  const auto directions = polar_directions(within, 2000);
  std::size_t north = 0;
  std::size_t inner = 0;  // the half of the area next to a pole
  for (const Vec3& u : directions) {
    const double phi = std::acos(std::abs(u.z()));
    ASSERT_LT(phi, within);
    north += u.z() > 0.0 ? 1U : 0U;
    inner += phi < within / std::sqrt(2.0) ? 1U : 0U;
  }
  EXPECT_EQ(north, 1000U);
  EXPECT_NEAR(static_cast<double>(inner), 1000.0, 5.0);
}

}  // namespace
}  // namespace impinge
