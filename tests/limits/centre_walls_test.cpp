// SPDX-License-Identifier: GPL-3.0-or-later
// The jump edges about every centre within the distance are listed, and no others but those next to a plane
// that such a centre may pass.
#include "limits/centre_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/jump_edges.hpp"
#include "support/dice.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

using test::Dice;

constexpr double kMeshRadius = 10.0;       // mm
constexpr double kShareInside = 0.999999;  // of r
constexpr int kOtherCentres = 5;           // besides those next to planes

// Folded, with holes, and with some faces turned round.
TriangleMesh random_surface(Dice& random) {
  TriangleMesh mesh = octahedron(kMeshRadius);
  const double moved = random.between(0.0, kMeshRadius);
  for (Vec3& x : mesh.vertices) x += random.rotation() * Vec3(0, 0, moved);
  std::erase_if(mesh.faces, [&](const Face&) { return random.between(0.0, 1.0) < 0.1; });
  for (Face& face : mesh.faces) {
    if (random.between(0.0, 1.0) < 0.2) std::swap(face[0], face[1]);
  }
  return mesh;
}

// On both sides towards every face, whose plane they pass if any centre within r does; and anywhere.
std::vector<Vec3> centres_within(const TriangleMesh& mesh, double r, Dice& random) {
  std::vector<Vec3> centres{Vec3::Zero()};
  for (const Face& face : mesh.faces) {
    const Vec3 way = kShareInside * r * area_vector(mesh, face).normalized();
    centres.insert(centres.end(), {way, -way});
  }
  for (int k = 0; k < kOtherCentres; ++k)
    centres.emplace_back(random.rotation() * Vec3(0, 0, r * random.between(0.0, kShareInside)));
  return centres;
}

std::set<Edge> jumps_about(TriangleMesh mesh, const Vec3& centre) {
  for (Vec3& x : mesh.vertices) x -= centre;
  std::set<Edge> edges;
  for (const JumpEdge& jump : jump_edges(mesh)) edges.insert({jump.from, jump.to});
  return edges;
}

// Edges of faces whose planes are as near as that.
std::set<Edge> edges_near(const TriangleMesh& mesh, double r) {
  std::set<Edge> near;
  for_each_edge(mesh, [&](std::span<const HalfEdge> uses) {
    const auto is_near = [&](HalfEdge h) {
      const Face& face = mesh.faces[h.face];
      return std::abs(area_vector(mesh, face).normalized().dot(corner(mesh, face, 0))) <= r;
    };
    if (std::ranges::any_of(uses, is_near)) near.insert(ends(mesh, uses.front()));
  });
  return near;
}

TEST(CentreWalls, AreOfTheEdgesThatMayJump) {
  Dice random(22);
  std::size_t edges = 0;
  std::size_t listed = 0;
  const std::size_t cases = random_cases();
  for (std::size_t k = 0; k < cases && !HasFailure(); ++k) {
    const TriangleMesh mesh = random_surface(random);
    const double r = random.power(-2.0, 0.7);
    const std::vector<Edge> list = possible_jumps(mesh, r);
    const std::set<Edge> possible(list.begin(), list.end());
    for (const Vec3& centre : centres_within(mesh, r, random))
      ASSERT_TRUE(std::ranges::includes(possible, jumps_about(mesh, centre))) << k;
    std::set<Edge> allowed = edges_near(mesh, (1.0 + 1e-9) * r);
    allowed.merge(jumps_about(mesh, Vec3::Zero()));
    ASSERT_TRUE(std::ranges::includes(allowed, possible)) << k;
    edges += impinge::edges(mesh).size();
    listed += list.size();
  }
  EXPECT_GT(listed, edges / 5);
  EXPECT_LT(listed, edges * 4 / 5);
}

}  // namespace
}  // namespace impinge
