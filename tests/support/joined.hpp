// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes made of others, and of single faces.
#pragma once

#include <utility>

#include "mesh/edges.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::test {

inline TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other) {
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Face& f : other.faces) mesh.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
  return mesh;
}

inline TriangleMesh inside_out(TriangleMesh mesh) {
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  return mesh;
}

// A socket with bone behind it: `back`, of the same vertices in their order, faces away from the centre, and
// strips join both along the boundary of the front.
inline TriangleMesh with_back(const TriangleMesh& front, const TriangleMesh& back) {
  TriangleMesh bone = joined(front, inside_out(back));
  const auto away = static_cast<VertexIndex>(front.vertices.size());
  for (const auto& [a, b] : boundary_edges(front)) {
    bone.faces.push_back({b, a, a + away});
    bone.faces.push_back({b, a + away, b + away});
  }
  return bone;
}

// With three vertices of its own.
inline void add_face(TriangleMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
  mesh.faces.push_back({first, first + 1, first + 2});
}

}  // namespace impinge::test
