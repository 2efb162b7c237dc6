// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/split_faces.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>

namespace impinge {
namespace {

// The sides that are to be cut, by their ends.
class CutSides {
 public:
  void cut(VertexIndex a, VertexIndex b) { middle_.try_emplace(key(a, b), kNotMade); }
  bool has(VertexIndex a, VertexIndex b) const { return middle_.contains(key(a, b)); }
  VertexIndex middle(VertexIndex a, VertexIndex b, TriangleMesh& mesh) {
    VertexIndex& made = middle_[key(a, b)];
    if (made == kNotMade) {
      made = static_cast<VertexIndex>(mesh.vertices.size());
      mesh.vertices.emplace_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
    }
    return made;
  }

 private:
  static constexpr VertexIndex kNotMade = ~VertexIndex{0};
  static std::uint64_t key(VertexIndex a, VertexIndex b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
  }
  std::unordered_map<std::uint64_t, VertexIndex> middle_;
};

// The same face with its longest side from corner 0 to corner 1.
Face from_longest(const TriangleMesh& mesh, const Face& face) {
  std::array<double, 3> length{};
  for (std::size_t k = 0; k < 3; ++k)
    length[k] = (corner(mesh, face, k) - corner(mesh, face, (k + 1) % 3)).squaredNorm();
  const auto k = static_cast<std::size_t>(std::ranges::max_element(length) - length.begin());
  return {face[k], face[(k + 1) % 3], face[(k + 2) % 3]};
}

// The sides to cut: if a side of a face is cut, so is its longest side.
CutSides closed(const std::vector<Face>& faces, const std::vector<bool>& marked) {
  CutSides sides;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; marked[f] && k < 3; ++k) sides.cut(faces[f][k], faces[f][(k + 1) % 3]);
  }
  for (bool more = true; more;) {
    more = false;
    for (const Face& f : faces) {
      if (sides.has(f[0], f[1]) || (!sides.has(f[1], f[2]) && !sides.has(f[2], f[0]))) continue;
      sides.cut(f[0], f[1]);
      more = true;
    }
  }
  return sides;
}

}  // namespace

SplitFaces split_faces(const TriangleMesh& mesh, const std::vector<bool>& marked) {
  std::vector<Face> faces;
  faces.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) faces.push_back(from_longest(mesh, face));
  CutSides sides = closed(faces, marked);
  SplitFaces split;
  split.mesh.vertices = mesh.vertices;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto add = [&](const Face& face) {
      split.mesh.faces.push_back(face);
      split.parent.push_back(f);
    };
    const auto [a, b, c] = faces[f];
    if (!sides.has(a, b)) {
      add(mesh.faces[f]);
      continue;
    }
    const VertexIndex m = sides.middle(a, b, split.mesh);
    if (sides.has(b, c)) {
      const VertexIndex n = sides.middle(b, c, split.mesh);
      add({m, b, n});
      add({m, n, c});
    } else {
      add({m, b, c});
    }
    if (sides.has(c, a)) {
      const VertexIndex n = sides.middle(c, a, split.mesh);
      add({a, m, n});
      add({n, m, c});
    } else {
      add({a, m, c});
    }
  }
  return split;
}

}  // namespace impinge
