// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: two faces without a common vertex whose radii at one entry differ by no more than the tolerance
// are a pair, each once.
#include <gtest/gtest.h>

#include "20_claims/claims_study.hpp"
#include "mesh/icosphere.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/joined.hpp"
#include "support/turned.hpp"

namespace impinge::lab {
namespace {

// Brute force over entries and pairs.
std::vector<FacePair> collisions_by_force(const TriangleMesh& mesh, const Rsid& scheme, double tolerance) {
  std::vector<FacePair> pairs;
  for (std::size_t a = 0; a < mesh.faces.size(); ++a) {
    for (std::size_t b = a + 1; b < mesh.faces.size(); ++b) {
      if (are_neighbours(mesh.faces[a], mesh.faces[b])) continue;
      const TriangleCone first = cone_of(mesh, mesh.faces[a]);
      const TriangleCone second = cone_of(mesh, mesh.faces[b]);
      for (std::size_t i = 0; i < scheme.size(); ++i) {
        const Vec3 u = scheme.direction(i);
        if (!first.contains(u) || !second.contains(u)) continue;
        if (std::abs(first.radius(u) - second.radius(u)) > tolerance) continue;
        pairs.emplace_back(a, b);
        break;
      }
    }
  }
  return pairs;
}

TEST(SelfCollisions, AreThoseOfBruteForce) {
  const TriangleMesh mesh =
      test::joined(icosphere(22.0, 0), test::moved(icosphere(22.0, 0), {1.5, 0.7, -0.4}));
  const Rsid scheme = Rsid::with_precision(6.0);
  for (const double tolerance : {0.2, 10.0}) {
    const auto expected = collisions_by_force(mesh, scheme, tolerance);
    EXPECT_EQ(self_collisions(mesh, scheme, tolerance), expected) << tolerance;
    EXPECT_TRUE(tolerance < 0.2 || expected.size() > 3U);
  }
}

}  // namespace
}  // namespace impinge::lab
