// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/pairwise.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/lengths.hpp"

namespace impinge {
namespace {

constexpr std::size_t kBlock = 256;  // faces tested at a time, so that the compiler can use vector registers

}  // namespace

RayCaster::RayCaster(const TriangleMesh& mesh) {
  require_lengths(mesh);
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    const auto& [a, b, c] = cone.corners();
    double doubt = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& from = cone.corners()[k];
      const Vec3& to = cone.corners()[(k + 1) % 3];
      const Vec3 plane = cone.side() * from.cross(to);
      for (std::size_t i = 0; i < 3; ++i) planes_[3 * k + i].push_back(plane[static_cast<Eigen::Index>(i)]);
      doubt = std::max(doubt, kPlaneTestError * from.norm() * to.norm());
    }
    planes_[9].push_back(doubt);
    determinant_.push_back(std::abs(a.dot(b.cross(c))));
    cones_.push_back(cone);
  }
}

double RayCaster::cast(const Vec3& u, Layer layer) const {
  double radius = kNoSurface;
  std::array<double, kBlock> inside;
  for (std::size_t begin = 0; begin < cones_.size(); begin += kBlock) {
    const std::size_t count = std::min(kBlock, cones_.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t f = begin + i;
      const double e0 = planes_[0][f] * u.x() + planes_[1][f] * u.y() + planes_[2][f] * u.z();
      const double e1 = planes_[3][f] * u.x() + planes_[4][f] * u.y() + planes_[5][f] * u.z();
      const double e2 = planes_[6][f] * u.x() + planes_[7][f] * u.y() + planes_[8][f] * u.z();
      const double least = e0 < e1 ? e0 : e1;
      inside[i] = (least < e2 ? least : e2) + planes_[9][f];
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (inside[i] < 0.0 || !cones_[begin + i].contains(u)) continue;
      keep(radius, radius_of(begin + i, u), layer);
    }
  }
  return radius;
}

double RayCaster::radius_of(std::size_t face, const Vec3& u) const {
  if (cones_[face].plane().exact) return cones_[face].radius(u);
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += planes_[3 * k][face] * u.x() + planes_[3 * k + 1][face] * u.y() + planes_[3 * k + 2][face] * u.z();
  }
  double farthest = 0.0;
  for (const Vec3& v : cones_[face].corners()) farthest = std::max(farthest, v.norm());
  return determinant_[face] / std::max(sum, determinant_[face] / farthest);
}

}  // namespace impinge
