// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edges.hpp"

#include <algorithm>

namespace impinge {

bool has_three_corners(const TriangleMesh& mesh, const Face& face) {
  const auto exists = [&mesh](VertexIndex v) { return v < mesh.vertices.size(); };
  return std::ranges::all_of(face, exists) && face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
}

EdgeList edges(const TriangleMesh& mesh) {
  struct Keyed {
    Edge edge;  // smaller end first
    HalfEdge half_edge;
  };
  std::vector<Keyed> keyed;
  keyed.reserve(3 * mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!has_three_corners(mesh, mesh.faces[f])) continue;
    for (std::size_t side = 0; side < 3; ++side) {
      const auto [a, b] = ends(mesh, {f, side});
      keyed.push_back({{std::min(a, b), std::max(a, b)}, {f, side}});
    }
  }
  std::ranges::stable_sort(keyed, {}, &Keyed::edge);
  EdgeList list;
  list.half_edges.reserve(keyed.size());
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    if (i == 0 || keyed[i].edge != keyed[i - 1].edge) list.first.push_back(i);
    list.half_edges.push_back(keyed[i].half_edge);
  }
  list.first.push_back(keyed.size());
  return list;
}

std::vector<Edge> boundary_edges(const TriangleMesh& mesh) {
  const EdgeList list = edges(mesh);
  std::vector<HalfEdge> open;
  for (std::size_t e = 0; e < list.size(); ++e) {
    if (list[e].size() == 1) open.push_back(list[e].front());
  }
  std::ranges::sort(
      open, [](HalfEdge a, HalfEdge b) { return a.face != b.face ? a.face < b.face : a.side < b.side; });
  std::vector<Edge> boundary;
  boundary.reserve(open.size());
  for (const HalfEdge h : open) boundary.push_back(ends(mesh, h));
  return boundary;
}

}  // namespace impinge
