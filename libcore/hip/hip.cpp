// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/hip.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "hip/hip_checks.hpp"
#include "hip/hip_parts.hpp"
#include "hip/hip_rings.hpp"
#include "mesh/loft.hpp"

namespace impinge {
namespace {

constexpr int kMostTries = 12;
constexpr double kCloseEnough = 0.01;
constexpr double kPartSpacing = 2.0;  // times the surface's spacing: parts seldom touch

// Faces that loft() makes of the rings.
std::size_t face_count(const PointRings& rings) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const std::size_t bands = i == 0 || i + 1 == rings.size() ? 1 : 2;
    count += rings[i].size() == 1 ? 0 : bands * rings[i].size();
  }
  return count;
}

void turn_over(TriangleMesh& mesh) {
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
}

// The number of faces goes with 1 / spacing^2, up to rounding.
double usual_spacing(const HipSurface& hip, std::size_t faces) {
  return hip.head_radius * std::sqrt(30.0 / static_cast<double>(faces));
}

template <class Rings>
TriangleMesh mesh_of(const HipSurface& hip, const Rings& rings_of, std::size_t faces) {
  double spacing = usual_spacing(hip, faces);
  PointRings rings = rings_of(hip, spacing);
  for (int k = 0; k < kMostTries; ++k) {
    const double ratio = static_cast<double>(face_count(rings)) / static_cast<double>(faces);
    if (std::abs(ratio - 1.0) < kCloseEnough) break;
    spacing *= std::sqrt(ratio);
    rings = rings_of(hip, spacing);
  }
  TriangleMesh mesh = loft(rings);
  turn_over(mesh);  // the rings run clockwise
  return mesh;
}

void mirror(TriangleMesh& mesh) {
  for (Vec3& v : mesh.vertices) v.x() = -v.x();
  turn_over(mesh);
}

}  // namespace

Hip make_hip(const HipParameters& parameters, std::size_t faces) {
  if (faces < kFewestHipFaces) {
    throw std::invalid_argument("a surface of a hip needs " + std::to_string(kFewestHipFaces) +
                                " faces or more, not " + std::to_string(faces));
  }
  const HipSurface surface = hip_surface(parameters);
  require_free_at_rest(surface);
  Hip hip{mesh_of(surface, femur_rings, faces), mesh_of(surface, acetabulum_rings, faces), {}, {}};
  const double spacing = kPartSpacing * usual_spacing(surface, faces);
  for (const BonePart& part : femur_parts(surface))
    append_part(hip.ball, hip.ball_parts, part.name, mesh_of(part, spacing));
  for (const BonePart& part : acetabulum_parts(surface))
    append_part(hip.socket, hip.socket_parts, part.name, mesh_of(part, spacing));
  if (parameters.side == Side::left) {
    mirror(hip.ball);
    mirror(hip.socket);
  }
  return hip;
}

BallSocketPair main_surfaces(const Hip& hip) {
  return {main_surface(hip.ball, hip.ball_parts), main_surface(hip.socket, hip.socket_parts)};
}

}  // namespace impinge
