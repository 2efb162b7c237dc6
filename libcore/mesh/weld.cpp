// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/weld.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <unordered_map>

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

// Keeps or merges the vertices one after the other: find(v) names the kept vertex to merge v into, if there
// is one, keep(v, index) takes note of a vertex that stays.
template <class Find, class Keep>
Weld weld_with(const TriangleMesh& mesh, const Find& find, const Keep& keep) {
  Weld weld;
  for (const Vec3& v : mesh.vertices) {
    const std::optional<VertexIndex> same = find(v);
    weld.map.push_back(same.value_or(static_cast<VertexIndex>(weld.mesh.vertices.size())));
    if (same) continue;
    keep(v, weld.map.back());
    weld.mesh.vertices.push_back(v);
  }
  weld.merged_vertices = mesh.vertices.size() - weld.mesh.vertices.size();
  for (const Face& face : mesh.faces) {
    const Face moved{weld.map.at(face[0]), weld.map.at(face[1]), weld.map.at(face[2])};
    if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0])
      weld.mesh.faces.push_back(moved);
  }
  weld.collapsed_faces = mesh.faces.size() - weld.mesh.faces.size();
  return weld;
}

// Cubes at least as wide as the tolerance, wide enough for their numbers to be exact, each with the vertices
// kept in it: whatever is within tolerance of a point lies in its cube or one of the 26 around it.
class Grid {
 public:
  Grid(const TriangleMesh& mesh, double tolerance) : tolerance_(tolerance) {
    double largest = 0.0;
    for (const Vec3& v : mesh.vertices) {
      if (v.allFinite()) largest = std::max(largest, v.cwiseAbs().maxCoeff());
    }
    width_ = std::max(tolerance, std::ldexp(largest, -40));
  }

  std::optional<VertexIndex> nearest(const Vec3& v) const {
    if (!v.allFinite()) return std::nullopt;
    std::optional<VertexIndex> best;
    double best_distance = tolerance_;
    for (int i = 0; i < 27; ++i) {
      const auto found = cubes_.find(cube(v, {i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1}));
      if (found == cubes_.end()) continue;
      for (const auto& [point, index] : found->second) {
        const double d = std::hypot(point.x() - v.x(), point.y() - v.y(), point.z() - v.z());
        const bool nearer =
            best ? d < best_distance || (d == best_distance && index < *best) : d <= best_distance;
        if (!nearer) continue;
        best = index;
        best_distance = d;
      }
    }
    return best;
  }

  void insert(const Vec3& v, VertexIndex index) {
    if (v.allFinite()) cubes_[cube(v, {0, 0, 0})].push_back({v, index});
  }

 private:
  struct Kept {
    Vec3 point;
    VertexIndex index;
  };

  Key cube(const Vec3& v, const std::array<int, 3>& step) const {
    Key key{};
    for (int k = 0; k < 3; ++k) {
      const auto cell = static_cast<std::int64_t>(std::floor(v[k] / width_));
      key[static_cast<std::size_t>(k)] = static_cast<std::uint64_t>(cell + step[static_cast<std::size_t>(k)]);
    }
    return key;
  }

  double tolerance_;
  double width_ = 1.0;
  std::unordered_map<Key, std::vector<Kept>, KeyHash> cubes_;
};

}  // namespace

Weld weld(const TriangleMesh& mesh) {
  std::unordered_map<Key, VertexIndex, KeyHash> kept;
  const auto key = [](const Vec3& v) {  // adding 0 turns -0 into 0
    return Key{std::bit_cast<std::uint64_t>(v.x() + 0.0), std::bit_cast<std::uint64_t>(v.y() + 0.0),
               std::bit_cast<std::uint64_t>(v.z() + 0.0)};
  };
  const auto find = [&](const Vec3& v) -> std::optional<VertexIndex> {
    const auto found = v.hasNaN() ? kept.end() : kept.find(key(v));
    return found == kept.end() ? std::nullopt : std::optional(found->second);
  };
  return weld_with(mesh, find, [&](const Vec3& v, VertexIndex index) { kept.emplace(key(v), index); });
}

Weld weld(const TriangleMesh& mesh, double tolerance) {
  if (!(tolerance > 0.0 && std::isfinite(tolerance))) {
    throw std::invalid_argument("a welding tolerance is a positive length in mm, not " +
                                std::to_string(tolerance));
  }
  Grid grid(mesh, tolerance);
  return weld_with(
      mesh, [&grid](const Vec3& v) { return grid.nearest(v); },
      [&grid](const Vec3& v, VertexIndex index) { grid.insert(v, index); });
}

}  // namespace impinge
