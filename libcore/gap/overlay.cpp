// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace impinge {
namespace {

using Corners = std::array<Vec3, 3>;

constexpr double kWidestReach = 0.25;  // radians

std::vector<FaceCap> caps_of(const TriangleMesh& mesh) {
  std::vector<FaceCap> caps;
  for (const Face& face : mesh.faces) caps.push_back(face_cap(corners_of(mesh, face)));
  return caps;
}

// A margin half as wide again as the mean cap of a face.
double reach_of(const std::vector<FaceCap>& caps) {
  double sum = 0.0;
  for (const FaceCap& one : caps) sum += std::min(one.cap.radius, kWidestReach);
  return 1.5 * sum / static_cast<double>(std::max<std::size_t>(caps.size(), 1));
}

std::array<Corners, 4> quarters(const Corners& c) {
  const Vec3 ab = 0.5 * (c[0] + c[1]);
  const Vec3 bc = 0.5 * (c[1] + c[2]);
  const Vec3 ca = 0.5 * (c[2] + c[0]);
  return {{{c[0], ab, ca}, {ab, c[1], bc}, {ca, bc, c[2]}, {ab, bc, ca}}};
}

// Can a face with the radii `range` of the moved surface impinge on one with the radii `rest`?
bool may_reach(Surface moved, const RadiusRange& range, const RadiusRange& rest) {
  return moved == Surface::ball ? range.high >= rest.low : range.low <= rest.high;
}

// How often a face may be halved: until there are as many pieces as the mesh has faces.
int most_halvings(std::size_t faces) {
  int halvings = 0;
  while (halvings < 8 && (std::size_t{1} << (2 * halvings)) < faces) ++halvings;
  return halvings;
}

// Calls visit(face), until it returns true, for the faces of the surface at rest that may impinge with a
// piece of a moved face, some more than once. The piece is halved until it is small enough for one look-up;
// after the last halving all faces are tried.
template <class Visit>
bool visit_candidates(Surface moved, const NearFaces& rest, const Corners& piece, int halvings,
                      Visit& visit) {
  const FaceCap seen = face_cap(piece);
  if (seen.cap.radius <= rest.margin()) {
    const auto near = rest.near(seen.cap.axis);
    if (near.nothing() || !may_reach(moved, seen.range, near.range)) return false;
    return std::ranges::any_of(near.faces, visit);
  }
  if (halvings > 0) {
    return std::ranges::any_of(quarters(piece), [&](const Corners& part) {
      return visit_candidates(moved, rest, part, halvings - 1, visit);
    });
  }
  std::vector<std::uint32_t> all(rest.mesh().faces.size());
  std::iota(all.begin(), all.end(), 0U);
  return std::ranges::any_of(all, visit);
}

// Caps of at most a quarter turn share no direction if they are farther apart than the sum of their radii.
// The chord is used for small angles, as an angle is no less than its chord.
bool caps_apart(const FaceCap& a, const FaceCap& b) {
  return a.small() && b.small() && (a.cap.axis - b.cap.axis).norm() > a.cap.radius + b.cap.radius;
}

}  // namespace

SurfaceOverlay::Side::Side(TriangleMesh of)
    : mesh(std::move(of)), caps(caps_of(mesh)), near(mesh, reach_of(caps)) {}

SurfaceOverlay::SurfaceOverlay(TriangleMesh ball, TriangleMesh socket)
    : sides_{std::make_unique<Side>(std::move(ball)), std::make_unique<Side>(std::move(socket))} {}

// Calls visit(ball face, socket face) for every pair that may impinge, until it returns true.
template <class Visit>
bool SurfaceOverlay::visit_pairs(Surface moved, const Pose& pose, const Visit& visit) const {
  const bool ball = moved == Surface::ball;
  const Side& moving = *sides_[ball ? 0 : 1];
  const Side& rest = *sides_[ball ? 1 : 0];
  TriangleMesh posed = moving.mesh;
  for (Vec3& x : posed.vertices) x = to_other(moved, pose, x);
  const int halvings = most_halvings(rest.caps.size());
  for (std::size_t m = 0; m < posed.faces.size(); ++m) {
    if (moving.caps[m].side == 0) continue;
    const Corners corners = corners_of(posed, posed.faces[m]);
    const FaceCap seen = face_cap(corners);
    auto pair = [&](std::uint32_t f) {
      const FaceCap& other = rest.caps[f];
      if (other.side == 0 || !may_reach(moved, seen.range, other.range) || caps_apart(seen, other))
        return false;
      const OverlayFace here{corners, seen.side};
      const OverlayFace there{corners_of(rest.mesh, rest.mesh.faces[f]), other.side};
      return ball ? visit(here, there) : visit(there, here);
    };
    if (visit_candidates(moved, rest.near, corners, halvings, pair)) return true;
  }
  return false;
}

// Visits the pairs of (1), then the pairs of (2).
template <class Visit>
bool SurfaceOverlay::visit_both(const Pose& pose, const Visit& visit) const {
  return visit_pairs(Surface::ball, pose, visit) || visit_pairs(Surface::socket, pose, visit);
}

bool SurfaceOverlay::impinged(const Pose& pose) const { return visit_both(pose, reaches); }

std::optional<OverlayContact> SurfaceOverlay::deepest(const Pose& pose) const {
  std::optional<OverlayContact> found;
  visit_both(pose, [&](const OverlayFace& ball, const OverlayFace& socket) {
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
