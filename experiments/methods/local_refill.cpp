// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/local_refill.hpp"

#include <cmath>

namespace impinge {
std::vector<std::size_t> changed_faces(const TriangleMesh& before, const TriangleMesh& after) {
  if (before.faces != after.faces || before.vertices.size() != after.vertices.size()) {
    throw std::invalid_argument(
        "the meshes before and after do not have the same faces: fill the table anew");
  }
  std::vector<bool> moved(before.vertices.size());
  for (std::size_t v = 0; v < moved.size(); ++v) moved[v] = before.vertices[v] != after.vertices[v];
  std::vector<std::size_t> changed;
  for (std::size_t f = 0; f < before.faces.size(); ++f) {
    if (std::ranges::any_of(before.faces[f], [&](VertexIndex v) { return moved[v]; })) changed.push_back(f);
  }
  return changed;
}

DirectionCap cap_of_faces(const TriangleMesh& before, const TriangleMesh& after,
                          const std::vector<std::size_t>& faces) {
  DirectionCap everywhere{Vec3::UnitZ(), kPi};
  std::vector<DirectionCap> caps;
  Vec3 sum = Vec3::Zero();
  for (const TriangleMesh* mesh : {&before, &after}) {
    for (const std::size_t f : faces) {
      const FaceCap seen = face_cap(corners_of(*mesh, mesh->faces[f]));
      if (!seen.small()) return everywhere;
      caps.push_back(seen.cap);
      sum += seen.cap.axis;
    }
  }
  if (sum.norm() == 0.0) return everywhere;
  DirectionCap all{sum.normalized(), 0.0};
  for (const DirectionCap& cap : caps)
    all.radius = std::max(all.radius, angle_between(all.axis, cap.axis) + cap.radius + kCapSlack);
  return all.radius < kPi ? all : everywhere;
}

bool surely_outside(const TriangleMesh& mesh, const Face& face, const DirectionCap& cap) {
  const FaceCap own = face_cap(corners_of(mesh, face));
  return own.small() && angle_between(own.cap.axis, cap.axis) > own.cap.radius + cap.radius + kCapSlack;
}

}  // namespace impinge
