// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/jump_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "mesh/edges.hpp"
#include "mesh/unpaired_edges.hpp"
#include "sphere/triangle_cone.hpp"

namespace impinge {
namespace {

double face_slope(const TriangleMesh& mesh, const Face& face) {
  const TriangleCone cone = cone_of(mesh, face);
  return cone.edge_on() ? std::numeric_limits<double>::infinity() : cone.largest_slope();
}

// The orientation of each face as the centre sees it, exact; 0 for a face without three corners.
std::vector<std::int8_t> sides_of(const TriangleMesh& mesh) {
  std::vector<std::int8_t> sides(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    if (!has_three_corners(mesh, face)) continue;
    const int side = orientation(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2));
    sides[f] = static_cast<std::int8_t>(side);
  }
  return sides;
}

// Do two faces spread to opposite sides of the plane through the centre and their common edge? Seen along a
// face's own direction of the edge, its third corner is on the side that its orientation tells.
bool continues(const TriangleMesh& mesh, const std::vector<std::int8_t>& sides,
               std::span<const HalfEdge> uses) {
  if (uses.size() != 2) return false;
  const bool same_way = ends(mesh, uses[0]) == ends(mesh, uses[1]);
  return sides[uses[0].face] * sides[uses[1].face] * (same_way ? 1 : -1) < 0;
}

}  // namespace

std::vector<JumpEdge> jump_edges(const TriangleMesh& mesh) {
  std::vector<JumpEdge> jumps;
  const std::vector<std::int8_t> sides = sides_of(mesh);
  const std::vector<bool> unpaired = unpaired_lower_ends(mesh, sides);
  if (std::ranges::find(unpaired, true) == unpaired.end()) return jumps;
  for_each_edge(mesh, unpaired, [&](std::span<const HalfEdge> uses) {
    if (continues(mesh, sides, uses)) return;
    const auto [from, to] = ends(mesh, uses.front());
    JumpEdge jump{from, to, 0.0};
    for (const HalfEdge h : uses) jump.slope = std::max(jump.slope, face_slope(mesh, mesh.faces[h.face]));
    jumps.push_back(jump);
  });
  return jumps;
}

}  // namespace impinge
