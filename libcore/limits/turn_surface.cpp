// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/turn_surface.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "mesh/triangle_distance.hpp"

namespace impinge {
namespace {

constexpr double kSliver = 1e-4;  // of the product of two sides: the normal has ten digits above it
constexpr double kBeyond = 1.01;  // of the reach that walls have
constexpr double kNearest =
    1e-3;  // of the reach: an edge that passes the centre more closely counts as that far

TurnFace face_of(const Vec3& a, const Vec3& b, const Vec3& c, bool wall) {
  std::array<double, 3> side{(b - a).norm(), (c - b).norm(), (a - c).norm()};
  std::ranges::sort(side);
  TurnFace face{{a, b, c}, (b - a).cross(c - a), side[1] * side[2], wall, false};
  face.sliver = face.normal.norm() < kSliver * face.size;
  return face;
}

std::vector<VertexIndex> listed(const std::vector<bool>& chosen) {
  std::vector<VertexIndex> list;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) list.push_back(static_cast<VertexIndex>(i));
  }
  return list;
}

// The wall of a jump edge a - b.
void add_wall(const Vec3& a, const Vec3& b, const WallReach& walls, std::vector<TurnFace>& faces) {
  if (walls.side == WallSide::within) {
    faces.push_back(face_of(Vec3::Zero(), a, b, true));
    return;
  }
  const double nearest =
      std::max(std::sqrt(squared_distance_to_segment(Vec3::Zero(), a, b)), kNearest * walls.reach);
  const double stretch = std::max(1.0, kBeyond * walls.reach / nearest);
  faces.push_back(face_of(a, b, stretch * b, true));
  faces.push_back(face_of(a, stretch * b, stretch * a, true));
}

}  // namespace

TurnParts::TurnParts(const TriangleMesh& mesh) : jumps(jump_edges(mesh)) {
  std::vector<bool> chosen(mesh.vertices.size(), false);
  for (const Face& face : mesh.faces) {
    for (const VertexIndex v : face) chosen[v] = true;
  }
  vertices = listed(chosen);
  chosen.assign(chosen.size(), false);
  for (const JumpEdge& jump : jumps) chosen[jump.from] = chosen[jump.to] = true;
  rim_vertices = listed(chosen);
  const EdgeList list = impinge::edges(mesh);
  for (std::size_t e = 0; e < list.size(); ++e) edges.push_back(ends(mesh, list[e].front()));
}

TurnSurface turn_surface(const TriangleMesh& mesh, const TurnParts& parts, const Eigen::Matrix3d& rotation,
                         const WallReach& walls) {
  TurnSurface surface;
  std::vector<Vec3> x(mesh.vertices.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = rotation * mesh.vertices[i];
  for (const VertexIndex v : parts.vertices) {
    surface.vertices.push_back(x[v]);
    surface.largest_radius = std::max(surface.largest_radius, x[v].norm());
  }
  surface.faces.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces)
    surface.faces.push_back(face_of(x[face[0]], x[face[1]], x[face[2]], false));
  surface.edges.reserve(parts.edges.size());
  for (const auto& [from, to] : parts.edges) surface.edges.push_back({x[from], x[to]});
  for (const VertexIndex v : parts.rim_vertices) surface.rim_vertices.push_back(x[v]);
  for (const JumpEdge& jump : parts.jumps) add_wall(x[jump.from], x[jump.to], walls, surface.walls);
  return surface;
}

}  // namespace impinge
