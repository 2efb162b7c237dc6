// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/fill/cube_view.hpp"

#include <algorithm>
#include <cmath>

#include "sphere/cube_faces.hpp"

namespace impinge {
namespace {

constexpr double kLeastShare = 0.125;  // of the largest coordinate, for a corner to be projected

double depth_through(const Vec3& v, std::size_t face) { return cube_sign(face) * v[cube_axes(face).depth]; }

SeenCorner project(const Vec3& v, std::size_t face, double half) {
  const double q = 1.0 / depth_through(v, face);
  const CubeAxes& axes = cube_axes(face);
  return {(v[axes.a] * q + 1.0) * half, (v[axes.b] * q + 1.0) * half, q, static_cast<std::uint32_t>(face)};
}

// Bit 6 f + g: v lies beyond the plane that separates what is seen through face f of the cube from face g, by
// a share of its distance; behind the centre where g is opposite to f.
std::uint64_t beyond(const Vec3& v, double share) {
  const std::array<double, 6> depth{v.x(), -v.x(), v.y(), -v.y(), v.z(), -v.z()};
  const double least = share * v.cwiseAbs().maxCoeff();
  std::uint64_t bits = 0;
  for (std::size_t f = 0; f < 6; ++f) {
    for (std::size_t g = 0; g < 6; ++g) {
      const double by = g == (f ^ 1U) ? depth[g] : depth[g] - depth[f];
      bits |= static_cast<std::uint64_t>(by > least) << (6 * f + g);
    }
  }
  return bits;
}

}  // namespace

CubeView::CubeView(const TriangleMesh& mesh, std::size_t divisions)
    : mesh_(&mesh),
      divisions_(divisions),
      corners_(mesh.vertices.size()),
      margin_face_(mesh.vertices.size(), kNone) {}

void CubeView::see(std::size_t first_vertex, std::size_t end_vertex) {
  const double half = 0.5 * static_cast<double>(divisions_);
  const auto inside = [&](double x) { return x > kLeastReach && x < 2.0 * half - kLeastReach; };
  for (std::size_t v = first_vertex; v < end_vertex; ++v) {
    const Vec3& x = mesh_->vertices[v];
    const std::size_t face = cube_face(x);
    const SeenCorner& seen = corners_[v] = project(x, face, half);
    if (inside(seen.x) && inside(seen.y) && seen.q < kMostInverse)
      margin_face_[v] = static_cast<std::uint8_t>(face);
  }
}

unsigned CubeView::may_be_seen(const Face& face) const {
  const double share = 4.0 * kLeastReach / static_cast<double>(divisions_);
  std::uint64_t all_beyond = ~std::uint64_t{0};
  for (const VertexIndex v : face) all_beyond &= beyond(mesh_->vertices[v], share);
  unsigned faces = 0;
  for (unsigned f = 0; f < 6; ++f)
    if ((all_beyond >> 6 * f & 0x3FU) == 0) faces |= 1U << f;
  return faces;
}

SeenFace CubeView::seen_across(const Face& face, std::size_t through) const {
  SeenFace seen;
  seen.projected = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& v = mesh_->vertices[face[k]];
    seen.corners[k] = project(v, through, 0.5 * static_cast<double>(divisions_));
    const double depth = depth_through(v, through);
    seen.projected =
        seen.projected && depth > kLeastShare * v.cwiseAbs().maxCoeff() && seen.corners[k].q < kMostInverse;
  }
  const auto last = static_cast<long>(divisions_);
  seen.window = seen.projected ? window_of(seen.corners) : GridWindow{0, last, 0, last};
  return seen;
}

}  // namespace impinge
