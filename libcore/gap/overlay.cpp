// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace impinge {
namespace {

using Corners = std::array<Vec3, 3>;

// Of a face that is larger than the reach of an index: no more than make as many pieces as there are faces.
int most_halvings(const FaceIndex& index) {
  int halvings = 0;
  while (halvings < 8 && (std::size_t{1} << (2 * halvings)) < index.size()) ++halvings;
  return halvings;
}

Corners corners_of(const std::vector<Vec3>& vertices, const Face& face) {
  return {vertices[face[0]], vertices[face[1]], vertices[face[2]]};
}

std::array<Corners, 4> quarters(const Corners& c) {
  const Vec3 ab = 0.5 * (c[0] + c[1]);
  const Vec3 bc = 0.5 * (c[1] + c[2]);
  const Vec3 ca = 0.5 * (c[2] + c[0]);
  return {{{c[0], ab, ca}, {ab, c[1], bc}, {ca, bc, c[2]}, {ab, bc, ca}}};
}

// A surface at rest, and which of the two it is.
struct RestSurface {
  const TriangleMesh& mesh;
  const FaceIndex& index;
  bool is_socket;
};

// Can a face with these radii, of the other surface, reach any with those?
bool may_reach(const RestSurface& rest, const RadiusRange& moved, const RadiusRange& range) {
  return rest.is_socket ? moved.high >= range.low : moved.low <= range.high;
}

// Calls visit(face) for faces of the surface at rest that may share a direction with the piece and be
// reached, some more than once, until it returns true. Pieces are small enough for one look into the index;
// in the end all faces are tried.
template <class Visit>
bool visit_candidates(const RestSurface& rest, const Corners& piece, int halvings, Visit& visit) {
  const FaceIndex::SeenFace seen = see_face(piece);
  if (seen.cap.radius <= rest.index.reach()) {
    const auto near = rest.index.near(seen.cap.axis);
    if (near.range.empty() || !may_reach(rest, seen.range, near.range)) return false;
    return std::ranges::any_of(near.faces, visit);
  }
  if (halvings > 0) {
    const auto parts = quarters(piece);
    return std::ranges::any_of(
        parts, [&](const Corners& part) { return visit_candidates(rest, part, halvings - 1, visit); });
  }
  std::vector<std::uint32_t> all(rest.index.size());
  std::iota(all.begin(), all.end(), 0U);
  return std::ranges::any_of(all, visit);
}

// Caps of at most a quarter turn each that are farther apart than both their radii share no direction. An
// angle is no less than its chord, which tells the smallest angles, too.
bool caps_apart(const DirectionCap& a, const DirectionCap& b) {
  if (a.radius >= 0.5 * kPi || b.radius >= 0.5 * kPi) return false;
  return (a.axis - b.axis).norm() > a.radius + b.radius;
}

// The other surface: its vertices are where the pose has put them, its index is that of the surface at rest.
struct MovedSurface {
  const std::vector<Vec3>& vertices;
  const std::vector<Face>& faces;
  const FaceIndex& index;
};

// Calls visit(ball face, socket face) for every pair that may impinge, until it returns true.
template <class Visit>
bool visit_pairs(const RestSurface& rest, const MovedSurface& moved, const Visit& visit) {
  const int halvings = most_halvings(rest.index);
  for (std::size_t m = 0; m < moved.faces.size(); ++m) {
    if (moved.index.face(m).side == 0) continue;
    const Corners corners = corners_of(moved.vertices, moved.faces[m]);
    const FaceIndex::SeenFace seen = see_face(corners);
    auto pair = [&](std::uint32_t f) {
      const FaceIndex::SeenFace& other = rest.index.face(f);
      if (other.side == 0 || !may_reach(rest, seen.range, other.range) || caps_apart(seen.cap, other.cap))
        return false;
      const OverlayFace moving{corners, seen.side};
      const OverlayFace resting{corners_of(rest.mesh.vertices, rest.mesh.faces[f]), other.side};
      return rest.is_socket ? visit(moving, resting) : visit(resting, moving);
    };
    if (visit_candidates(rest, corners, halvings, pair)) return true;
  }
  return false;
}

// Pairs of (1) and then those of (2).
template <class Visit>
bool visit_both(const SurfaceOverlay& joint, const Pose& pose, const Visit& visit) {
  std::vector<Vec3> moved(joint.ball().vertices.size());
  std::ranges::transform(joint.ball().vertices, moved.begin(),
                         [&](const Vec3& x) { return to_socket(pose, x); });
  if (visit_pairs({joint.socket(), joint.socket_index(), true},
                  {moved, joint.ball().faces, joint.ball_index()}, visit))
    return true;
  moved.resize(joint.socket().vertices.size());
  std::ranges::transform(joint.socket().vertices, moved.begin(),
                         [&](const Vec3& y) { return to_ball(pose, y); });
  return visit_pairs({joint.ball(), joint.ball_index(), false},
                     {moved, joint.socket().faces, joint.socket_index()}, visit);
}

}  // namespace

SurfaceOverlay::SurfaceOverlay(TriangleMesh ball, TriangleMesh socket)
    : ball_(std::move(ball)), socket_(std::move(socket)), ball_index_(ball_), socket_index_(socket_) {}

bool SurfaceOverlay::impinged(const Pose& pose) const { return visit_both(*this, pose, reaches); }

std::optional<OverlayContact> SurfaceOverlay::deepest(const Pose& pose) const {
  std::optional<OverlayContact> found;
  visit_both(*this, pose, [&](const OverlayFace& ball, const OverlayFace& socket) {
    return visit_overlay(ball, socket, [&](const OverlayPoint& point) {
      if (point.order < 0) return false;
      const double depth = std::max(0.0, depth_at(ball, socket, point));
      if (!found || depth > found->depth) found = OverlayContact{depth, point.kind};
      return false;
    });
  });
  return found;
}

}  // namespace impinge
