// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edges.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace impinge {

bool has_three_corners(const TriangleMesh& mesh, const Face& face) {
  const auto exists = [&mesh](VertexIndex v) { return v < mesh.vertices.size(); };
  return std::ranges::all_of(face, exists) && face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
}

void require_countable_edges(const TriangleMesh& mesh) {
  if (mesh.faces.size() > std::numeric_limits<std::uint32_t>::max() / 3)
    throw std::invalid_argument("a mesh of more than 1,431,655,765 faces: decimate it");
}

namespace {

// A half-edge at the smaller of its ends, in few bytes, as fresh memory takes time.
struct Spoke {
  VertexIndex larger;
  std::uint32_t place;  // 3 times the face, and the side

  HalfEdge half_edge() const { return {place / 3, place % 3}; }
};

// The spokes of vertex v are spokes[first[v]] .. spokes[first[v + 1] - 1], in the order of the faces.
struct Spokes {
  std::vector<Spoke> spokes;
  std::vector<std::uint32_t> first;
};

// The numbers of all faces of a mesh, used like a list.
struct EveryFace {
  std::size_t count;

  std::size_t size() const { return count; }
  std::size_t operator[](std::size_t k) const { return k; }
};

// Calls visit(half_edge, its ends) for the half-edges of the faces with three corners whose lower end is
// wanted.
template <class Faces, class Wanted, class Visit>
void for_each_half_edge(const TriangleMesh& mesh, const Faces& faces, const Wanted& wanted, Visit&& visit) {
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const std::size_t f = faces[k];
    if (!has_three_corners(mesh, mesh.faces[f])) continue;
    for (std::size_t side = 0; side < 3; ++side) {
      const Edge edge = ends(mesh, {f, side});
      if (wanted(std::ranges::min(edge))) visit(HalfEdge{f, side}, edge);
    }
  }
}

// Sorts by counting, so that the time is linear.
template <class Faces, class Wanted>
Spokes spokes_of(const TriangleMesh& mesh, const Faces& faces, const Wanted& wanted) {
  require_countable_edges(mesh);
  Spokes all;
  all.first.assign(mesh.vertices.size() + 2, 0);
  for_each_half_edge(mesh, faces, wanted,
                     [&](HalfEdge, const Edge& edge) { ++all.first[std::ranges::min(edge) + 2]; });
  for (std::size_t v = 2; v < all.first.size(); ++v) all.first[v] += all.first[v - 1];
  all.spokes.resize(all.first.back());
  for_each_half_edge(mesh, faces, wanted, [&](HalfEdge h, const Edge& edge) {
    all.spokes[all.first[std::ranges::min(edge) + 1]++] = {std::ranges::max(edge),
                                                           static_cast<std::uint32_t>(3 * h.face + h.side)};
  });
  return all;
}

void for_each_edge_of(Spokes all, const std::function<void(std::span<const HalfEdge>)>& visit) {
  std::vector<HalfEdge> uses;
  for (std::size_t v = 0; v + 1 < all.first.size(); ++v) {
    const std::span own = std::span(all.spokes).subspan(all.first[v], all.first[v + 1] - all.first[v]);
    std::ranges::sort(own, [](const Spoke& a, const Spoke& b) {
      return a.larger != b.larger ? a.larger < b.larger : a.place < b.place;
    });
    for (std::size_t i = 0; i < own.size(); ++i) {
      uses.push_back(own[i].half_edge());
      if (i + 1 < own.size() && own[i + 1].larger == own[i].larger) continue;
      visit(uses);
      uses.clear();
    }
  }
}

}  // namespace

void for_each_edge(const TriangleMesh& mesh, const std::function<void(std::span<const HalfEdge>)>& visit) {
  const EveryFace faces{mesh.faces.size()};
  for_each_edge_of(spokes_of(mesh, faces, [](VertexIndex) { return true; }), visit);
}

void for_each_edge(const TriangleMesh& mesh, const std::vector<bool>& lower_ends,
                   const std::function<void(std::span<const HalfEdge>)>& visit) {
  const auto wanted = [&](VertexIndex v) { return v < lower_ends.size() && lower_ends[v]; };
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (std::ranges::any_of(mesh.faces[f], wanted)) faces.push_back(f);
  for_each_edge_of(spokes_of(mesh, faces, wanted), visit);
}

EdgeList edges(const TriangleMesh& mesh) {
  EdgeList list;
  list.half_edges.reserve(3 * mesh.faces.size());
  for_each_edge(mesh, [&list](std::span<const HalfEdge> uses) {
    list.first.push_back(list.half_edges.size());
    list.half_edges.insert(list.half_edges.end(), uses.begin(), uses.end());
  });
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
