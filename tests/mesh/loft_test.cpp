// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: a band between rings of m and n points has m + n faces, a fan round a pole of n points n; the
// surface is closed between two poles, open otherwise; normals point outward.
#include "mesh/loft.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/validation.hpp"

namespace impinge {
namespace {

using Rings = std::vector<std::vector<Vec3>>;

std::vector<Vec3> circle(std::size_t n, double z, double radius) {
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < n; ++k) {
    const double turn = 2.0 * kPi * static_cast<double>(k) / static_cast<double>(n);
    points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z);
  }
  return points;
}

TEST(Loft, BetweenTwoPolesIsClosed) {
  const Rings rings{{{0, 0, 2}}, circle(7, 1, 2), circle(12, 0, 3), circle(5, -1, 2), {{0, 0, -2}}};
  const MeshReport report = validate(loft(rings));
  EXPECT_EQ(report.vertices, 26U);
  EXPECT_EQ(report.faces, 7U + 7U + 12U + 12U + 5U + 5U);
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.flipped_faces + report.degenerate_faces + report.duplicate_faces, 0U);
  EXPECT_GT(report.volume.value(), 0.0);
}

// A tube of 40 sides: pi r^2 h of the polygon.
TEST(Loft, WithoutPolesIsOpen) {
  const TriangleMesh tube = loft(Rings{circle(40, 3, 2), circle(40, 0, 2)});
  const MeshReport report = validate(tube);
  EXPECT_EQ(report.faces, 80U);
  EXPECT_EQ(report.boundary_edges, 80U);
  double flux = 0.0;
  for (const Face& face : tube.faces) {
    Vec3 middle = (corner(tube, face, 0) + corner(tube, face, 1) + corner(tube, face, 2)) / 3.0;
    middle.z() = 0.0;
    flux += 0.5 * area_vector(tube, face).dot(middle);
  }
  EXPECT_NEAR(flux, 2.0 * 20.0 * 4.0 * std::sin(2.0 * kPi / 40.0) * 3.0, 1e-9);
}

TEST(Loft, RefusesWhatIsNoRing) {
  EXPECT_THROW(loft(Rings{circle(5, 0, 1)}), std::invalid_argument);
  EXPECT_THROW(loft(Rings{circle(5, 0, 1), {}}), std::invalid_argument);
  EXPECT_THROW(loft(Rings{circle(5, 0, 1), circle(2, 1, 1)}), std::invalid_argument);
  EXPECT_THROW(loft(Rings{{{0, 0, 1}}, {{0, 0, 0}}}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
