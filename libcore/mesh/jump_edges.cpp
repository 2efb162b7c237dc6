// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/jump_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>

#include "sphere/triangle_cone.hpp"

namespace impinge {
namespace {

// One side of a face: its edge with the lower index first, the face, and the corner across.
struct Wing {
  VertexIndex from;
  VertexIndex to;
  VertexIndex across;
  std::size_t face;
};

std::vector<Wing> sorted_wings(const TriangleMesh& mesh) {
  std::vector<Wing> wings;
  wings.reserve(3 * mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [from, to] = std::minmax(face[k], face[(k + 1) % 3]);
      wings.push_back({from, to, face[(k + 2) % 3], f});
    }
  }
  std::sort(wings.begin(), wings.end(), [](const Wing& a, const Wing& b) {
    return std::tie(a.from, a.to, a.face) < std::tie(b.from, b.to, b.face);
  });
  return wings;
}

double slope(const TriangleMesh& mesh, std::size_t f) {
  const Face& face = mesh.faces[f];
  const TriangleCone cone(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2));
  return cone.edge_on() ? std::numeric_limits<double>::infinity() : cone.largest_slope();
}

// Two faces that spread to opposite sides of the plane through the centre and their common edge.
bool continues(const TriangleMesh& mesh, const Wing& a, const Wing& b) {
  const Vec3& from = mesh.vertices[a.from];
  const Vec3& to = mesh.vertices[a.to];
  return orientation(from, to, mesh.vertices[a.across]) * orientation(from, to, mesh.vertices[b.across]) < 0;
}

}  // namespace

std::vector<JumpEdge> jump_edges(const TriangleMesh& mesh) {
  const std::vector<Wing> wings = sorted_wings(mesh);
  std::vector<JumpEdge> edges;
  for (std::size_t i = 0; i < wings.size();) {
    std::size_t end = i + 1;
    while (end < wings.size() && wings[end].from == wings[i].from && wings[end].to == wings[i].to) ++end;
    if (end - i != 2 || !continues(mesh, wings[i], wings[i + 1])) {
      JumpEdge edge{wings[i].from, wings[i].to, 0.0};
      for (std::size_t k = i; k < end; ++k) edge.slope = std::max(edge.slope, slope(mesh, wings[k].face));
      edges.push_back(edge);
    }
    i = end;
  }
  return edges;
}

}  // namespace impinge
