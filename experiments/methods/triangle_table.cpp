// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "methods/maciel_triangles.hpp"
#include "sphere/angular_box.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

constexpr double kAngleMargin = 1e-9;  // radians, far above the rounding of an angle

// The nearest or farthest radius met so far, and its face.
struct Sampler {
  Sampler(std::size_t side, Layer layer)
      : table{side, std::vector<std::uint32_t>(side * side, kNoFace)},
        radius(side * side, kNoSurface),
        which(layer) {
    if (side == 0) throw std::invalid_argument("a table of triangles needs one ray or more a side");
  }

  void offer(const TriangleMesh& mesh, std::size_t f, std::size_t ray, const Vec3& u) {
    const double met = radius_on(mesh, mesh.faces[f], u);
    if (std::isnan(met)) return;
    const double before = radius[ray];
    keep(radius[ray], met, which);
    if (radius[ray] != before) table.face[ray] = static_cast<std::uint32_t>(f);
  }

  TriangleTable table;
  std::vector<double> radius;
  Layer which;
};

// Rays near a face: rows and columns; columns may cross the seam.
struct RayRange {
  std::size_t top;
  std::size_t bottom;
  long left;
  long right;
};

RayRange rays_near(const TriangleMesh& mesh, const Face& face, std::size_t side) {
  const AngularBox box =
      angular_box({corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)}, kAngleMargin);
  const auto count = static_cast<double>(side);
  const double row = kPi / count;
  const double column = 2.0 * kPi / count;
  const auto last = static_cast<long>(side) - 1;
  const auto clamped = [last](double at) {
    return static_cast<std::size_t>(std::clamp(static_cast<long>(std::floor(at)), 0L, last));
  };
  const auto left = static_cast<long>(std::floor(box.theta_min / column)) - 1;
  const auto right = static_cast<long>(std::floor((box.theta_min + box.theta_width) / column)) + 1;
  return {clamped(box.phi_min / row), clamped(box.phi_max / row), left, std::min(right, left + last)};
}

}  // namespace

Vec3 ray_direction(std::size_t side, std::size_t ray) {
  const auto count = static_cast<double>(side);
  const std::size_t row = ray / side;
  const std::size_t column = ray % side;
  return to_direction({(static_cast<double>(row) + 0.5) * kPi / count,
                       (static_cast<double>(column) + 0.5) * 2.0 * kPi / count});
}

std::size_t ray_of(std::size_t side, const Vec3& x) {
  const auto [phi, theta] = to_angles(x);
  const auto count = static_cast<double>(side);
  const auto place = [side](double share) { return std::min(static_cast<std::size_t>(share), side - 1); };
  return place(phi / kPi * count) * side + place(theta / (2.0 * kPi) * count);
}

double radius_on(const TriangleMesh& mesh, const Face& face, const Vec3& x) {
  const Vec3& a = corner(mesh, face, 0);
  const Vec3& b = corner(mesh, face, 1);
  const Vec3& c = corner(mesh, face, 2);
  const double at_c = x.dot(a.cross(b));
  const double at_a = x.dot(b.cross(c));
  const double at_b = x.dot(c.cross(a));
  const double sum = at_a + at_b + at_c;
  const bool inside = sum > 0.0 ? std::min({at_a, at_b, at_c}) >= 0.0 : std::max({at_a, at_b, at_c}) <= 0.0;
  const double scale = a.dot(b.cross(c)) / sum;
  return inside && scale > 0.0 ? scale * x.norm() : kNoSurface;  // no face behind the centre
}

TriangleTable fill_triangles_pairwise(const TriangleMesh& mesh, std::size_t side, Layer layer) {
  Sampler sampler(side, layer);
  for (std::size_t ray = 0; ray < side * side; ++ray) {
    const Vec3 u = ray_direction(side, ray);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) sampler.offer(mesh, f, ray, u);
  }
  return sampler.table;
}

TriangleTable fill_triangles(const TriangleMesh& mesh, std::size_t side, Layer layer) {
  Sampler sampler(side, layer);
  const auto columns = static_cast<long>(side);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const RayRange near = rays_near(mesh, mesh.faces[f], side);
    for (std::size_t row = near.top; row <= near.bottom; ++row) {
      for (long j = near.left; j <= near.right; ++j) {
        const std::size_t ray = row * side + static_cast<std::size_t>((j % columns + columns) % columns);
        sampler.offer(mesh, f, ray, ray_direction(side, ray));
      }
    }
  }
  return sampler.table;
}

double radius_at(const TriangleTable& table, const TriangleMesh& mesh, const Vec3& x) {
  const std::uint32_t face = table.face[ray_of(table.side, x)];
  return face == kNoFace ? kNoSurface : radius_on(mesh, mesh.faces[face], x);
}

std::size_t missed_faces(const TriangleTable& table, const TriangleMesh& mesh) {
  std::vector<bool> referred(mesh.faces.size());
  for (const std::uint32_t face : table.face) {
    if (face != kNoFace) referred[face] = true;
  }
  std::size_t missed = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    missed += !referred[f] && !cone_of(mesh, mesh.faces[f]).edge_on() ? 1U : 0U;
  return missed;
}

}  // namespace impinge::lab
