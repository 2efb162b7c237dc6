// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/centre_walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "mesh/triangle_distance.hpp"

namespace impinge {
namespace {

constexpr double kShell = 1.15;          // ratio of the two k of a shell
constexpr double kInmost = 0.05;         // the walls within are one shell from this k to the centre
constexpr double kEdgeRounding = 1e-12;  // share of the farther end, above what rounding does to a distance

// Rounding of n . a and of r |n|, n = (b - a) x (c - a), as a share of |b - a| |c - a| (|a| + r): 12
// roundings each. centre_walls.gappa.
constexpr double kHeightRounding = 24.0 * 0x1p-53;

// On which side of the face's plane are all centres within r, 1 or -1? 0 if they are on both.
int certain_side(const TriangleMesh& mesh, const Face& face, double r) {
  const Vec3& a = corner(mesh, face, 0);
  const Vec3 normal = area_vector(mesh, face);
  const double height = normal.dot(a);
  const double doubt = kHeightRounding * (a.norm() + r) * (corner(mesh, face, 1) - a).norm() *
                       (corner(mesh, face, 2) - a).norm();
  if (!(std::abs(height) > r * normal.norm() + doubt)) return 0;
  return height > 0.0 ? 1 : -1;
}

struct ScaledEdge {
  const Vec3& a;
  const Vec3& b;

  // Adds the wall between k and l times the edge.
  void add(double k, double l, double doubt, std::vector<TurnFace>& faces) const {
    for (const auto& [x, y, z] : {std::array<Vec3, 3>{k * a, k * b, l * b}, {k * a, l * b, l * a}}) {
      faces.push_back(turn_face(x, y, z));
      faces.back().doubt = doubt;
    }
  }
};

// Adds the walls beyond an edge: a point p meets one at k y only if |p - k y| <= moved + (k - 1) r.
void add_beyond(const ScaledEdge& edge, double nearest, double farthest, const WallQuestion& walls,
                std::vector<TurnFace>& faces) {
  const double moved = 2.0 * walls.r + walls.gap;  // the largest shift, and the threshold
  const double from = std::max(1.0, (walls.nearest - moved + walls.r) / (farthest + walls.r));
  // So k |y| <= |p| + moved + (k - 1) r. For an edge that may pass the centre k has no bound.
  const double left = nearest - walls.r - kEdgeRounding * farthest;
  const double to = left > 0.0 ? (walls.farthest + moved) / left : HUGE_VAL;
  if (!std::isfinite(to)) return edge.add(0.0, 1.0, 4.0 * (farthest + walls.farthest), faces);
  for (double k = from; k < to; k *= kShell) edge.add(k, kShell * k, (kShell * k - 1.0) * walls.r, faces);
}

// Adds the walls within an edge: a point p meets one at k x only if |p - k x| <= k moved + (1 - k) r.
void add_within(const ScaledEdge& edge, double nearest, double farthest, const WallQuestion& walls,
                std::vector<TurnFace>& faces) {
  const double moved = 3.0 * walls.r + walls.gap;  // no less than both terms, with the threshold
  const double low = (walls.nearest - moved) / farthest;
  for (double k = std::min(1.0, (walls.farthest + moved) / nearest); k > std::max(low, 0.0);) {
    const double next = k < kInmost ? 0.0 : k / kShell;
    edge.add(next, k, walls.common ? (1.0 - next) * walls.r : 0.0, faces);
    k = next;
  }
}

}  // namespace

std::vector<Edge> possible_jumps(const TriangleMesh& mesh, double r) {
  std::vector<int> sides;
  sides.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) sides.push_back(certain_side(mesh, face, r));
  std::vector<Edge> jumps;
  for_each_edge(mesh, [&](std::span<const HalfEdge> uses) {
    const Edge edge = ends(mesh, uses.front());
    if (uses.size() == 2) {
      const int way = ends(mesh, uses[1]) == edge ? 1 : -1;
      if (sides[uses[0].face] * sides[uses[1].face] * way < 0) return;
    }
    jumps.push_back(edge);
  });
  return jumps;
}

std::vector<TurnFace> shells(const TriangleMesh& mesh, const std::vector<Edge>& edges,
                             const WallQuestion& walls) {
  std::vector<TurnFace> faces;
  for (const Edge& edge : edges) {
    const ScaledEdge scaled{mesh.vertices[edge[0]], mesh.vertices[edge[1]]};
    const double nearest = std::sqrt(squared_distance_to_segment(Vec3::Zero(), scaled.a, scaled.b));
    const double farthest = std::max(scaled.a.norm(), scaled.b.norm());
    if (walls.beyond)
      add_beyond(scaled, nearest, farthest, walls, faces);
    else
      add_within(scaled, nearest, farthest, walls, faces);
  }
  return faces;
}

}  // namespace impinge
