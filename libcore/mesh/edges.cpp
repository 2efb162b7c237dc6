// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edges.hpp"

#include <algorithm>
#include <tuple>

namespace impinge {

bool has_three_corners(const TriangleMesh& mesh, const Face& face) {
  const auto exists = [&mesh](VertexIndex v) { return v < mesh.vertices.size(); };
  return std::ranges::all_of(face, exists) && face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
}

namespace {

// A half-edge at the smaller of its ends.
struct Spoke {
  VertexIndex larger;
  HalfEdge half_edge;
};

// Those of vertex v are spokes[first[v]] .. spokes[first[v + 1] - 1], in the order of the faces.
struct Spokes {
  std::vector<Spoke> spokes;
  std::vector<std::size_t> first;
};

template <class Visit>
void for_each_half_edge(const TriangleMesh& mesh, Visit&& visit) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!has_three_corners(mesh, mesh.faces[f])) continue;
    for (std::size_t side = 0; side < 3; ++side) visit(HalfEdge{f, side});
  }
}

// A counting sort, so that the time is linear.
Spokes spokes_of(const TriangleMesh& mesh) {
  Spokes all;
  all.first.assign(mesh.vertices.size() + 2, 0);
  for_each_half_edge(mesh, [&](HalfEdge h) { ++all.first[std::ranges::min(ends(mesh, h)) + 2]; });
  for (std::size_t v = 2; v < all.first.size(); ++v) all.first[v] += all.first[v - 1];
  all.spokes.resize(all.first.back());
  for_each_half_edge(mesh, [&](HalfEdge h) {
    const Edge edge = ends(mesh, h);
    all.spokes[all.first[std::ranges::min(edge) + 1]++] = {std::ranges::max(edge), h};
  });
  return all;
}

}  // namespace

EdgeList edges(const TriangleMesh& mesh) {
  Spokes all = spokes_of(mesh);
  EdgeList list;
  list.half_edges.reserve(all.spokes.size());
  for (std::size_t v = 0; v + 1 < all.first.size(); ++v) {
    const std::span own = std::span(all.spokes).subspan(all.first[v], all.first[v + 1] - all.first[v]);
    std::ranges::sort(own, [](const Spoke& a, const Spoke& b) {
      const auto key = [](const Spoke& s) {
        return std::tuple(s.larger, s.half_edge.face, s.half_edge.side);
      };
      return key(a) < key(b);
    });
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (i == 0 || own[i].larger != own[i - 1].larger) list.first.push_back(list.half_edges.size());
      list.half_edges.push_back(own[i].half_edge);
    }
  }
  list.first.push_back(list.half_edges.size());
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
