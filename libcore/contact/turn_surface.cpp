// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/turn_surface.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "contact/part_distance.hpp"
#include "mesh/triangle_distance.hpp"

namespace impinge {
namespace {

constexpr double kBeyond = 1.01;            // walls reach so many times as far as they must
constexpr double kWidestPiece = kPi / 3.0;  // of a wall, as the centre sees it
// How far a point of an edge may move when the edge is turned to the frame of the axis and cut, as a share of
// the distance of its farther end. A wall beyond stretches that with the point.
constexpr double kEdgeError = 64.0 * 0x1p-53;

// Points that cut the edge a - b into pieces of at most kWidestPiece as the centre sees it, ends included.
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

// Adds the wall beyond an edge. A chord of the arc at its outer distance is nowhere nearer than the reach.
void add_wall_beyond(const Vec3& a, const Vec3& b, double least, std::vector<TurnFace>& faces) {
  const double reach = kBeyond * least / std::cos(0.5 * kWidestPiece);
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

TurnFace turn_point(const Vec3& x) { return turn_face(x, x, x); }

TurnFace turned_by(const Eigen::Matrix3d& rotation, const TurnFace& face) {
  TurnFace moved = turn_face(rotation * face.corner[0], rotation * face.corner[1], rotation * face.corner[2]);
  moved.wall = face.wall;
  moved.doubt = face.doubt;
  return moved;
}

std::vector<TurnFace> walls_beyond(const TriangleMesh& mesh, const std::vector<JumpEdge>& jumps,
                                   double reach) {
  std::vector<TurnFace> walls;
  for (const JumpEdge& jump : jumps)
    add_wall_beyond(mesh.vertices[jump.from], mesh.vertices[jump.to], reach, walls);
  return walls;
}

std::vector<TurnFace> walls_within(const TriangleMesh& mesh, const std::vector<JumpEdge>& jumps) {
  std::vector<TurnFace> walls;
  walls.reserve(jumps.size());
  for (const JumpEdge& jump : jumps)
    walls.push_back(wall_face(Vec3::Zero(), mesh.vertices[jump.from], mesh.vertices[jump.to], 0.0));
  return walls;
}

}  // namespace impinge
