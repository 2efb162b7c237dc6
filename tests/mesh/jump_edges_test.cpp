// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: an edge is a jump unless it is used by two faces alone, which spread to opposite sides of the
// plane through the centre and the edge:
//   side(f) side(g) w < 0,  w = +1 where both run through the edge the same way, -1 otherwise
// Jumps come by their lower and upper ends. Faces without three corners use no edge.
#include "mesh/jump_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/edges.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/unpaired_edges.hpp"

namespace impinge {
namespace {

int side_of(const TriangleMesh& mesh, const Face& face) {
  return orientation(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2));
}

using UsesByEdge = std::map<Edge, std::vector<HalfEdge>>;

UsesByEdge uses_of(const TriangleMesh& mesh) {
  UsesByEdge uses;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!has_three_corners(mesh, mesh.faces[f])) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [from, to] = ends(mesh, {f, k});
      uses[{std::min(from, to), std::max(from, to)}].push_back({f, k});
    }
  }
  return uses;
}

bool jumps(const TriangleMesh& mesh, const std::vector<HalfEdge>& uses) {
  if (uses.size() != 2) return true;
  const int way = ends(mesh, uses[0]) == ends(mesh, uses[1]) ? 1 : -1;
  return side_of(mesh, mesh.faces[uses[0].face]) * side_of(mesh, mesh.faces[uses[1].face]) * way >= 0;
}

double slope_of(const TriangleMesh& mesh, const std::vector<HalfEdge>& uses) {
  double slope = 0.0;
  for (const HalfEdge use : uses) {
    const TriangleCone cone = cone_of(mesh, mesh.faces[use.face]);
    slope = std::max(slope, cone.edge_on() ? std::numeric_limits<double>::infinity() : cone.largest_slope());
  }
  return slope;
}

void expect_jumps(const TriangleMesh& mesh) {
  const std::vector<JumpEdge> found = jump_edges(mesh);
  auto next = found.begin();
  for (const auto& [edge, uses] : uses_of(mesh)) {
    if (!jumps(mesh, uses)) continue;
    ASSERT_NE(next, found.end()) << edge[0] << ' ' << edge[1];
    EXPECT_EQ((Edge{next->from, next->to}), ends(mesh, uses.front()));
    EXPECT_EQ(next->slope, slope_of(mesh, uses));
    ++next;
  }
  EXPECT_EQ(next, found.end());
}

TEST(JumpEdges, OfSurfacesAndWhatIsCutFromThem) {
  for (TriangleMesh mesh : {make_ball_socket_pair(300).ball, make_ball_socket_pair(300).socket, cone(),
                            octahedron(20.0), sphere(22.0, 300, {30.0, 5.0, -8.0})}) {
    expect_jumps(mesh);
    std::swap(mesh.faces[1][0], mesh.faces[1][1]);  // turned round, which is no jump
    mesh.faces.push_back(mesh.faces[4]);            // twice: edges of three faces
    mesh.faces.erase(mesh.faces.begin() + 6);
    expect_jumps(mesh);
    const std::vector<Face> once = mesh.faces;
    mesh.faces.insert(mesh.faces.end(), once.begin(), once.end());  // all edges of four faces
    expect_jumps(mesh);
  }
}

// Few vertices, so that edges have none to many faces, some of them without three corners or through the
// centre, and vertices have up to thirteen edges.
TEST(JumpEdges, OfAnyFaces) {
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    TriangleMesh mesh;
    const std::size_t vertices = 4 + random() % 10;
    const auto place = [&] { return static_cast<double>(random() % 5) - 2.0; };
    for (std::size_t v = 0; v < vertices; ++v) mesh.vertices.emplace_back(place(), place(), place());
    const auto any = [&] {
      return static_cast<VertexIndex>(random() % (round % 4 == 0 ? vertices + 1 : vertices));
    };
    for (std::size_t f = random() % 60; f > 0; --f) mesh.faces.push_back({any(), any(), any()});
    expect_jumps(mesh);
  }
}

// A body about the centre whose vertices have up to as many edges as it has others.
TEST(JumpEdges, NoneOnAFan) {
  for (const std::size_t around : {3U, 4U, 5U, 8U, 9U, 40U, 64U, 65U, 100U}) {
    for (const bool ends_first : {true, false}) {
      TriangleMesh mesh;
      if (ends_first) mesh.vertices = {{0, 0, 20}, {0, 0, -20}};
      const auto first = static_cast<VertexIndex>(mesh.vertices.size());
      for (std::size_t k = 0; k < around; ++k) {
        const double angle = 2.0 * kPi * static_cast<double>(k) / static_cast<double>(around);
        mesh.vertices.emplace_back(20.0 * std::cos(angle), 20.0 * std::sin(angle), 0.0);
      }
      if (!ends_first) mesh.vertices.insert(mesh.vertices.end(), {{0, 0, 20}, {0, 0, -20}});
      const auto top = static_cast<VertexIndex>(ends_first ? 0 : around);
      for (std::size_t k = 0; k < around; ++k) {
        const auto a = first + static_cast<VertexIndex>(k);
        const auto b = first + static_cast<VertexIndex>((k + 1) % around);
        mesh.faces.insert(mesh.faces.end(), {{a, b, top}, {b, a, top + 1}});
      }
      EXPECT_TRUE(jump_edges(mesh).empty());
      expect_jumps(mesh);
      mesh.faces.pop_back();
      EXPECT_EQ(jump_edges(mesh).size(), 3U);
      expect_jumps(mesh);
    }
  }
}

TEST(JumpEdges, LowerEndsAreMarkedForThemAlone) {
  const TriangleMesh mesh = make_ball_socket_pair(300).socket;
  std::vector<std::int8_t> sides;
  for (const Face& face : mesh.faces) sides.push_back(static_cast<std::int8_t>(side_of(mesh, face)));
  std::vector<bool> expected(mesh.vertices.size());
  for (const JumpEdge& jump : jump_edges(mesh)) expected[std::min(jump.from, jump.to)] = true;
  EXPECT_EQ(unpaired_lower_ends(mesh, sides), expected);
}

// The hubs of a large fan: the general matching sorts what begins there, and still finds no jump.
TEST(JumpEdges, HubsAreLeftToTheGeneralMatching) {
  TriangleMesh mesh{{{0, 0, 20}, {0, 0, -20}}, {}};
  constexpr VertexIndex kAround = 65;
  for (VertexIndex k = 0; k < kAround; ++k) {
    const double angle = 2.0 * kPi * k / kAround;
    mesh.vertices.emplace_back(20.0 * std::cos(angle), 20.0 * std::sin(angle), 0.0);
    const VertexIndex next = 2 + (k + 1) % kAround;
    mesh.faces.insert(mesh.faces.end(), {{2 + k, next, 0}, {next, 2 + k, 1}});
  }
  const std::vector<std::int8_t> sides(mesh.faces.size(), 1);
  const std::vector<bool> unpaired = unpaired_lower_ends(mesh, sides);
  EXPECT_TRUE(unpaired[0] && unpaired[1]);
  EXPECT_EQ(std::ranges::count(unpaired, true), 2);
  EXPECT_TRUE(jump_edges(mesh).empty());
}

TEST(JumpEdges, EdgesOfSomeVertices) {
  TriangleMesh mesh = make_ball_socket_pair(300).socket;
  mesh.faces.push_back({0, 1, 1000000});
  std::vector<bool> wanted(mesh.vertices.size());
  for (std::size_t v = 0; v < wanted.size(); v += 3) wanted[v] = true;
  std::vector<std::pair<std::size_t, std::size_t>> expected;
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for_each_edge(mesh, [&](std::span<const HalfEdge> uses) {
    if (!wanted[std::ranges::min(ends(mesh, uses.front()))]) return;
    for (const HalfEdge use : uses) expected.emplace_back(use.face, use.side);
  });
  for_each_edge(mesh, wanted, [&](std::span<const HalfEdge> uses) {
    for (const HalfEdge use : uses) found.emplace_back(use.face, use.side);
  });
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace impinge
