// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/bone_along_rays.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/validation.hpp"

namespace impinge {

std::optional<BoneAlongRay> bone_along(const NearFaces& faces, const Vec3& u, bool inside_out) {
  constexpr double kOnePlace = 1e-6;  // where faces lie upon each other, crossings into bone come first
  std::vector<std::pair<double, int>> crossings;  // negative radius, mm; 1 into bone from outside, or -1
  const bool doubtful = faces.any_hit(u, [&](std::uint32_t f, int side) {
    const TriangleCone cone = cone_of(faces.mesh(), faces.mesh().faces[f]);
    const double inside = cone.least_edge_distance(u.x(), u.y(), u.z());
    if (std::abs(inside) <= cone.doubt()) return true;
    const int into = (side > 0) != inside_out ? 1 : -1;
    if (inside > 0.0) crossings.emplace_back(-cone.radius(u) * (1.0 + kOnePlace * into), into);
    return false;
  });
  if (doubtful) return std::nullopt;
  std::ranges::sort(crossings);
  BoneAlongRay found;
  for (const auto& crossing : crossings) {
    found.at_centre += crossing.second;
    found.least = std::min(found.least, found.at_centre);
  }
  return found;
}

bool is_bone_beside_centre(const TriangleMesh& mesh) {
  const auto volume = validate(mesh).volume;
  if (!volume) return false;
  const NearFaces faces(mesh, 0.0);
  bool asked = false;  // rays past edges tell nothing
  const bool beside = std::ranges::all_of(mesh.faces, [&](const Face& face) {
    const Vec3 middle = corner(mesh, face, 0) + corner(mesh, face, 1) + corner(mesh, face, 2);
    const auto bone = bone_along(faces, middle.stableNormalized(), *volume < 0.0);
    asked = asked || bone.has_value();
    return !bone || (bone->least == 0 && bone->at_centre == 0);
  });
  return beside && asked;
}

}  // namespace impinge
