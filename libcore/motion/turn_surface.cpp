// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/turn_surface.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "mesh/triangle_distance.hpp"
#include "motion/part_distance.hpp"

namespace impinge {
namespace {

constexpr double kBeyond = 1.01;            // of the reach that walls have
constexpr double kWidestPiece = kPi / 3.0;  // of a wall, as the centre sees it
// Of the distance of the farther end of an edge: what turning it to the frame of the axis, and cutting it in
// pieces, may move a point of it by. A wall beyond stretches that with the point.
constexpr double kEdgeError = 64.0 * 0x1p-53;

std::vector<VertexIndex> listed(const std::vector<bool>& chosen) {
  std::vector<VertexIndex> list;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) list.push_back(static_cast<VertexIndex>(i));
  }
  return list;
}

// Points that cut the edge a - b in pieces of no more than kWidestPiece as the centre sees it, ends included.
std::vector<Vec3> cut_by_angle(const Vec3& a, const Vec3& b) {
  const Vec3 along = (b - a).stableNormalized();
  const double from = a.dot(along);
  const double to = b.dot(along);
  const double nearest = a.cross(along).norm();  // of the line
  const double start = std::atan2(from, nearest);
  const double width = std::atan2(to, nearest) - start;
  const auto pieces = static_cast<int>(std::ceil(width / kWidestPiece));
  std::vector<Vec3> points{a};
  for (int k = 1; k < pieces; ++k) {
    const double at = nearest * std::tan(start + width * k / pieces);
    points.emplace_back(a + std::clamp((at - from) / (to - from), 0.0, 1.0) * (b - a));
  }
  points.push_back(b);
  return points;
}

TurnFace wall_face(const Vec3& a, const Vec3& b, const Vec3& c, double doubt) {
  TurnFace face = turn_face(a, b, c);
  face.wall = true;
  face.doubt = doubt;
  return face;
}

// The wall of a jump edge a - b.
void add_wall(const Vec3& a, const Vec3& b, const WallReach& walls, std::vector<TurnFace>& faces) {
  if (walls.side == WallSide::within) {
    faces.push_back(wall_face(Vec3::Zero(), a, b, 0.0));
    return;
  }
  // A chord of the arc at this distance is nowhere nearer than the reach.
  const double reach = kBeyond * walls.reach / std::cos(0.5 * kWidestPiece);
  const double nearest = std::sqrt(squared_distance_to_segment(Vec3::Zero(), a, b));
  const double farthest = std::max(a.norm(), b.norm());
  const double doubt = kEdgeError * reach * farthest / nearest;
  const std::vector<Vec3> points = cut_by_angle(a, b);
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec3& from = points[k - 1];
    const Vec3& to = points[k];
    const double far = std::max({reach, from.norm(), to.norm()});
    const Vec3 far_from = far * from.stableNormalized();
    const Vec3 far_to = far * to.stableNormalized();
    faces.push_back(wall_face(from, to, far_to, doubt));
    faces.push_back(wall_face(from, far_to, far_from, doubt));
  }
}

}  // namespace

TurnFace turn_face(const Vec3& a, const Vec3& b, const Vec3& c) {
  std::array<double, 3> side{(b - a).norm(), (c - b).norm(), (a - c).norm()};
  std::ranges::sort(side);
  TurnFace face{{a, b, c}, (b - a).cross(c - a), side[1] * side[2], false, false, 0.0};
  face.thin = face.normal.norm() < kThin * face.size;
  return face;
}

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
  for (const Face& face : mesh.faces) {
    const auto& [a, b, c] = surface.faces.emplace_back(turn_face(x[face[0]], x[face[1]], x[face[2]])).corner;
    surface.smallest_radius =
        std::min(surface.smallest_radius, std::sqrt(squared_distance_to_triangle(Vec3::Zero(), a, b, c)));
  }
  surface.edges.reserve(parts.edges.size());
  for (const auto& [from, to] : parts.edges) surface.edges.push_back({x[from], x[to]});
  for (const VertexIndex v : parts.rim_vertices) surface.rim_vertices.push_back(x[v]);
  for (const JumpEdge& jump : parts.jumps) add_wall(x[jump.from], x[jump.to], walls, surface.walls);
  return surface;
}

}  // namespace impinge
