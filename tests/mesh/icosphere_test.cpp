// SPDX-License-Identifier: GPL-3.0-or-later
// 20 * 4^n faces and, by Euler's formula for a closed surface whose faces are triangles, half as many
// vertices and two; every edge has one face on either side; the volume grows towards that of the sphere.
#include "mesh/icosphere.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

namespace impinge {
namespace {

constexpr double kRadius = 22.0;  // mm

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Face& face : mesh.faces) sum += area_vector(mesh, face).dot(corner(mesh, face, 0)) / 6.0;
  return sum;
}

TEST(Icosphere, IsClosedAndItsCornersLieOnTheSphere) {
  std::size_t faces = 20;
  for (std::size_t halvings = 0; halvings < 5; ++halvings, faces *= 4) {
    const TriangleMesh mesh = icosphere(kRadius, halvings);
    ASSERT_EQ(mesh.faces.size(), faces);
    ASSERT_EQ(mesh.vertices.size(), faces / 2 + 2);
    std::set<std::pair<VertexIndex, VertexIndex>> directed;
    for (const Face& face : mesh.faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_TRUE(directed.emplace(face[k], face[(k + 1) % 3]).second);
      }
    }
    for (const auto& [a, b] : directed) EXPECT_TRUE(directed.contains({b, a}));
    for (const Vec3& v : mesh.vertices) EXPECT_NEAR(v.norm(), kRadius, 1e-12);
  }
}

// The icosahedron with corners at R has the volume (5 (3 + sqrt 5) / 12) a^3, a = R / sin 72 degrees.
TEST(Icosphere, FacesOutwardsAndFillsTheSphere) {
  const double edge = kRadius / std::sin(0.4 * kPi);
  const double icosahedron = 5.0 * (3.0 + std::sqrt(5.0)) / 12.0 * edge * edge * edge;
  EXPECT_NEAR(volume(icosphere(kRadius, 0)), icosahedron, 1e-9 * icosahedron);
  const double ball = 4.0 / 3.0 * kPi * kRadius * kRadius * kRadius;
  double missing = ball - icosahedron;
  for (std::size_t halvings = 1; halvings < 6; ++halvings) {
    const double left = ball - volume(icosphere(kRadius, halvings));
    EXPECT_GT(left, 0.0);
    EXPECT_LT(left, 0.35 * missing);  // a quarter in the end
    missing = left;
  }
}

TEST(Icosphere, RefusesWhatIsNoSphere) {
  EXPECT_THROW(icosphere(0.0, 1), std::invalid_argument);
  EXPECT_THROW(icosphere(-1.0, 1), std::invalid_argument);
  EXPECT_THROW(icosphere(std::numeric_limits<double>::quiet_NaN(), 1), std::invalid_argument);
  EXPECT_THROW(icosphere(kRadius, 9), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
