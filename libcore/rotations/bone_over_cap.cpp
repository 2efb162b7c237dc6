// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/bone_over_cap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "mesh/surface_vertices.hpp"
#include "rotations/bone_along_rays.hpp"
#include "rotations/radii_over_cap.hpp"

namespace impinge {
namespace {

const TriangleMesh& closed(const TriangleMesh& mesh) {
  if (!is_bone_beside_centre(mesh))
    throw std::runtime_error(
        "the socket is no closed mesh of one orientation with the centre outside of its bone, so that it is "
        "not known where its bone is; ask for the radial cut, or give the socket with its wall");
  return mesh;
}

}  // namespace

// Edge-on faces stay in the index: they bound the bone. The counted ray passes none of them.
BoneOverCap::BoneOverCap(const TriangleMesh& mesh)
    : index_(closed(mesh), Layer::nearest, kIndexReach),
      nearest_(without_edge_on(mesh), Layer::nearest),
      farthest_(without_edge_on(mesh), Layer::farthest) {
  for (const Face& face : mesh.faces) least_.push_back(face_cap(corners_of(mesh, face)).range.low);
}

// Notes which faces unit u meets, and how; false where it passes an edge within rounding.
bool BoneOverCap::crossings_along(const Vec3& u) const {
  for (std::size_t k = 0; k < near_.size(); ++k) {
    const TriangleCone& cone = index_.plane(near_[k]).cone;
    crossed_[k].winding = 0;
    if (cone.edge_on()) continue;
    const double inside = cone.least_edge_distance(u.x(), u.y(), u.z());
    if (std::abs(inside) <= cone.doubt()) return false;
    if (inside > 0.0) crossed_[k].winding = -cone.side();
  }
  return true;
}

bool BoneOverCap::find_crossings(const DirectionCap& cap) const {
  constexpr std::array<std::array<double, 2>, 4> kTried{
      {{0.0, 0.0}, {0.31, 0.17}, {-0.23, 0.29}, {0.07, -0.37}}};  // from the axis, in radii
  const Vec3 a = cap.axis.unitOrthogonal();
  const Vec3 b = cap.axis.cross(a);
  return std::ranges::any_of(kTried, [&](const auto& tried) {
    const double width = std::sin(cap.radius);
    return crossings_along((cap.axis + width * (tried[0] * a + tried[1] * b)).normalized());
  });
}

SpansOverCap BoneOverCap::over(const DirectionCap& cap) const {
  SpansOverCap found;
  if (cap.radius + kCapSlack > kIndexReach) {
    const float angle = std::nextafter(static_cast<float>(cap.radius), 4.0F);
    found.possible.add(static_cast<double>(nearest_.within(cap.axis, angle)),
                       static_cast<double>(farthest_.within(cap.axis, angle)));
    return found;
  }
  index_.faces_near(cap, near_);
  crossed_.assign(near_.size(), {});
  for (std::size_t k = 0; k < near_.size(); ++k) {
    const SurfacePlane& plane = index_.plane(near_[k]);
    const PlaneRange range = range_within(plane, cap);
    crossed_[k].range = {std::max(range.least, least_[near_[k]]) * (1.0 - kOutwards),
                         std::min(range.largest, plane.largest_radius) * (1.0 + kOutwards)};
  }
  const bool counted = find_crossings(cap);
  std::ranges::sort(crossed_, {}, [](const Crossed& c) { return c.range.low; });
  int winding = 0;
  double reached = 0.0;  // mm, the farthest that a face so far goes
  for (const Crossed& face : crossed_) {
    if (face.range.low > reached && (!counted || winding != 0)) {
      if (counted) found.certain.add(reached, face.range.low);
      if (reached > 0.0) found.possible.add(reached, face.range.low);
    }
    winding += face.winding;
    reached = std::max(reached, face.range.high);
    found.possible.add(face.range.low, face.range.high);
  }
  return found;
}

}  // namespace impinge
