// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/weld.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <vector>

namespace impinge {
namespace {

using Key = std::array<std::uint64_t, 3>;

struct KeyHash {
  std::size_t operator()(const Key& key) const {
    std::uint64_t h = 0;
    for (const std::uint64_t k : key) h = (std::rotl(h, 23) ^ k) * 0x9e3779b97f4a7c15U;
    return static_cast<std::size_t>(h ^ h >> 32U);
  }
};

Key key_of(const Vec3& v) {  // adding 0 turns -0 into 0
  return {std::bit_cast<std::uint64_t>(v.x() + 0.0), std::bit_cast<std::uint64_t>(v.y() + 0.0),
          std::bit_cast<std::uint64_t>(v.z() + 0.0)};
}

}  // namespace

std::vector<VertexIndex> first_at_place(const std::vector<Vec3>& vertices) {
  std::vector<VertexIndex> first;
  std::unordered_map<Key, VertexIndex, KeyHash> kept;
  for (const Vec3& v : vertices) {
    const auto own = static_cast<VertexIndex>(first.size());
    first.push_back(v.hasNaN() ? own : kept.emplace(key_of(v), own).first->second);
  }
  return first;
}

TriangleMesh weld(const TriangleMesh& mesh) {
  TriangleMesh welded;
  std::vector<VertexIndex> map = first_at_place(mesh.vertices);
  for (std::size_t v = 0; v < map.size(); ++v) {
    const bool kept = map[v] == v;
    map[v] = kept ? static_cast<VertexIndex>(welded.vertices.size()) : map[map[v]];
    if (kept) welded.vertices.push_back(mesh.vertices[v]);
  }
  for (const Face& face : mesh.faces) {
    const Face moved{map.at(face[0]), map.at(face[1]), map.at(face[2])};
    if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]) welded.faces.push_back(moved);
  }
  return welded;
}

TriangleMesh without_repeats(TriangleMesh mesh) {
  std::set<Face> seen;
  std::erase_if(mesh.faces, [&](Face face) {
    std::ranges::sort(face);
    return !seen.insert(face).second;
  });
  return mesh;
}

TriangleMesh continued(TriangleMesh mesh, const TriangleMesh& rest) {
  const std::size_t own = mesh.vertices.size();
  std::vector<Vec3> all = mesh.vertices;
  all.insert(all.end(), rest.vertices.begin(), rest.vertices.end());
  const std::vector<VertexIndex> first = first_at_place(all);
  std::vector<VertexIndex> to;
  for (std::size_t v = 0; v < rest.vertices.size(); ++v) {
    const VertexIndex at = first[own + v];
    const bool is_new = at == own + v;
    to.push_back(at < own ? at : is_new ? static_cast<VertexIndex>(mesh.vertices.size()) : to[at - own]);
    if (is_new) mesh.vertices.push_back(rest.vertices[v]);
  }
  for (const Face& face : rest.faces) mesh.faces.push_back({to[face[0]], to[face[1]], to[face[2]]});
  return mesh;
}

}  // namespace impinge
