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

std::vector<TurnFace> turn_faces(const TriangleMesh& mesh) {
  std::vector<TurnFace> faces;
  faces.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces)
    faces.push_back(turn_face(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)));
  return faces;
}

TurnParts::TurnParts(const TriangleMesh& mesh, bool walls)
    : nearest(mesh.faces.size()),
      first_corner(mesh.faces.size(), {false, false, false}),
      first_side(mesh.faces.size(), {false, false, false}),
      jumps(walls ? jump_edges(mesh) : std::vector<JumpEdge>{}) {
  std::vector<bool> chosen(mesh.vertices.size(), false);
  std::vector<Vec3> middles;
  middles.reserve(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexIndex v = mesh.faces[f][k];
      first_corner[f][k] = !chosen[v];
      chosen[v] = true;
    }
    const auto [a, b, c] = corners_of(mesh, mesh.faces[f]);
    nearest[f] = std::sqrt(squared_distance_to_triangle(Vec3::Zero(), a, b, c));
    middles.emplace_back(a + b + c);
  }
  by_face = order_by_place(middles);
  vertices = listed(chosen);
  std::vector<Vec3> places;
  places.reserve(vertices.size());
  for (const VertexIndex v : vertices) places.push_back(mesh.vertices[v]);
  by_vertex = order_by_place(places);
  chosen.assign(chosen.size(), false);
  for (const JumpEdge& jump : jumps) chosen[jump.from] = chosen[jump.to] = true;
  rim_vertices = listed(chosen);
  for_each_edge(mesh, [&](std::span<const HalfEdge> half_edges) {
    first_side[half_edges[0].face][half_edges[0].side] = true;
  });
}

TurnSurface::TurnSurface(const TriangleMesh& of, const TurnParts& its_parts, const Eigen::Matrix3d& rotation,
                         const WallReach& reach)
    : mesh(&of), parts(&its_parts), points(of.vertices.size()) {
  for (const VertexIndex v : parts->vertices) {
    points[v] = TurnPoint(rotation * mesh->vertices[v]);
    largest_radius = std::max(largest_radius, points[v].r);
  }
  for (const double nearest : parts->nearest) smallest_radius = std::min(smallest_radius, nearest);
  for (const JumpEdge& jump : parts->jumps) add_wall(points[jump.from].x, points[jump.to].x, reach, walls);
}

TurnFace TurnSurface::face(std::size_t f) const {
  const Face& face = mesh->faces[f];
  return turn_face(points[face[0]].x, points[face[1]].x, points[face[2]].x);
}

TurnTree TurnSurface::tree(double margin) const {
  std::vector<TurnBox> boxes;
  boxes.reserve(mesh->faces.size());
  for (std::size_t f = 0; f < mesh->faces.size(); ++f) {
    const Face& face = mesh->faces[f];
    const std::array corners{&points[face[0]], &points[face[1]], &points[face[2]]};
    boxes.push_back(turn_box(corners, parts->nearest[f], margin));
  }
  return {boxes, parts->by_face};
}

}  // namespace impinge
