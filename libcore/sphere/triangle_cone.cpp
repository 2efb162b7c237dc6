// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/triangle_cone.hpp"

#include "sphere/orientation.hpp"

namespace impinge {

TriangleCone::TriangleCone(const Vec3& a, const Vec3& b, const Vec3& c)
    : corner_{a, b, c},
      side_(orientation(a, b, c)),
      plane_(face_plane(a, b, c, side_)),
      largest_radius_(std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()}))),
      smallest_radius_(std::sqrt(std::min({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()}))),
      grazing_(!(plane_.offset > kPlaneTestError * plane_.size * largest_radius_)) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& from = corner_[k];
    const Vec3& to = corner_[(k + 1) % 3];
    edge_plane_[k] = side_ * from.cross(to);
    doubt_[k] = kPlaneTestError * from.norm() * to.norm();
  }
}

}  // namespace impinge
