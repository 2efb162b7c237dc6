// SPDX-License-Identifier: GPL-3.0-or-later
// The plain test of each pair against the oracle of exact signs:
//   thesis_ray_radius() = RayCaster::cast() but for rounding, away from faces seen edge-on
#include "methods/thesis_pairwise.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/uniform_directions.hpp"
#include "support/random_cases.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

constexpr double kRayRounding = 1e-9;  // mm

void expect_the_oracle(const TriangleMesh& mesh, const RayCaster& oracle, const Vec3& u, Layer layer) {
  const double expected = oracle.cast(u, layer);
  const double found = thesis_ray_radius(mesh, u, layer);
  ASSERT_EQ(std::isnan(found), std::isnan(expected)) << u.transpose();
  if (!std::isnan(expected)) {
    ASSERT_NEAR(found, expected, kRayRounding) << u.transpose();
  }
}

// At all entries of a grid, of which some lie on edges and vertices.
TEST(ThesisPairwise, FillsTheTableOfTheOracle) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  const Rsid scheme = Rsid::with_precision(5.0);
  for (const auto& [mesh, layer] : {std::pair{&pair.ball, Layer::farthest}, {&pair.socket, Layer::nearest}}) {
    const auto expected = fill_pairwise(*mesh, scheme, layer);
    const auto found = fill_thesis_pairwise(*mesh, scheme, layer);
    for (std::size_t i = 0; i < scheme.size(); ++i) {
      ASSERT_EQ(std::isnan(found.radii()[i]), std::isnan(expected.radii()[i])) << i;
      if (!std::isnan(expected.radii()[i])) {
        ASSERT_NEAR(found.radii()[i], expected.radii()[i], kRayRounding) << i;
      }
    }
    for (std::size_t c = 0; c < scheme.cells(); ++c)
      EXPECT_EQ(found.is_rim_cell(c), expected.is_rim_cell(c)) << c;
  }
}

TEST(ThesisPairwise, SeesVerticesAndTheMiddlesOfEdges) {
  const TriangleMesh mesh = octahedron(20.0);
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = mesh.vertices[face[k]];
      const Vec3& b = mesh.vertices[face[(k + 1) % 3]];
      EXPECT_NEAR(thesis_ray_radius(mesh, a.normalized(), Layer::farthest), 20.0, kRayRounding);
      EXPECT_NEAR(thesis_ray_radius(mesh, (a + b).normalized(), Layer::farthest), 20.0 / std::sqrt(2.0),
                  kRayRounding);
    }
  }
}

// Bodies about the centre and off it, both layers, rays in all directions.
TEST(ThesisPairwiseAttack, IsTheOracleAlongRandomRays) {
  std::mt19937_64 random(18);
  std::uniform_real_distribution<double> place(-8.0, 8.0);
  constexpr std::size_t kRays = 50;  // of a body
  for (std::size_t done = 0; done < random_cases(); done += kRays) {
    const TriangleMesh mesh = sphere(22.0, 80, {place(random), place(random), place(random)});
    const RayCaster oracle(mesh);
    const Layer layer = done / kRays % 2 == 0 ? Layer::farthest : Layer::nearest;
    for (const Vec3& u : uniform_directions(kRays, random())) expect_the_oracle(mesh, oracle, u, layer);
  }
}

}  // namespace
}  // namespace impinge::lab
