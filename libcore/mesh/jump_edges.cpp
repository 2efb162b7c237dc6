// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/jump_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "mesh/edges.hpp"
#include "sphere/triangle_cone.hpp"

namespace impinge {
namespace {

double face_slope(const TriangleMesh& mesh, const Face& face) {
  const TriangleCone cone = cone_of(mesh, face);
  return cone.edge_on() ? std::numeric_limits<double>::infinity() : cone.largest_slope();
}

const Vec3& corner_across(const TriangleMesh& mesh, HalfEdge h) {
  return corner(mesh, mesh.faces[h.face], (h.side + 2) % 3);
}

// Two faces that spread to opposite sides of the plane through the centre and their common edge.
bool continues(const TriangleMesh& mesh, std::span<const HalfEdge> sides) {
  if (sides.size() != 2) return false;
  const auto [a, b] = ends(mesh, sides[0]);
  const Vec3& from = mesh.vertices[a];
  const Vec3& to = mesh.vertices[b];
  return orientation(from, to, corner_across(mesh, sides[0])) *
             orientation(from, to, corner_across(mesh, sides[1])) <
         0;
}

}  // namespace

std::vector<JumpEdge> jump_edges(const TriangleMesh& mesh) {
  std::vector<JumpEdge> jumps;
  const EdgeList list = edges(mesh);
  for (std::size_t e = 0; e < list.size(); ++e) {
    if (continues(mesh, list[e])) continue;
    const auto [from, to] = ends(mesh, list[e].front());
    JumpEdge jump{from, to, 0.0};
    for (const HalfEdge h : list[e]) jump.slope = std::max(jump.slope, face_slope(mesh, mesh.faces[h.face]));
    jumps.push_back(jump);
  }
  return jumps;
}

}  // namespace impinge
