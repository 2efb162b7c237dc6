// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/icosahedron.hpp"

#include <Eigen/Geometry>

namespace impinge {
namespace {

/// The corner at azimuth 36 k degrees.
Vec3 ring(long k, double side) {
  const CosSin azimuth = half_turn_fraction(k, 5);
  const double z = 1.0 / std::sqrt(5.0);
  return {2.0 * z * azimuth.cos, 2.0 * z * azimuth.sin, side * z};
}

Icosahedron::Face make_face(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double volume = a.cross(b).dot(c);
  Icosahedron::Face made{
      {a, b, c}, {b.cross(c) / volume, c.cross(a) / volume, a.cross(b) / volume}, Vec3::Zero()};
  made.axis = made.dual[0] + made.dual[1] + made.dual[2];
  return made;
}

}  // namespace

const Icosahedron& Icosahedron::instance() {
  static const Icosahedron all;
  return all;
}

Icosahedron::Icosahedron() {
  for (long k = 0; k < 5; ++k) {
    set_diamond(static_cast<std::size_t>(k), Vec3::UnitZ(), ring(2 * k, 1.0), ring(2 * k + 1, -1.0),
                ring(2 * k + 2, 1.0));
    set_diamond(static_cast<std::size_t>(k) + 5, ring(2 * k + 2, 1.0), ring(2 * k + 1, -1.0), -Vec3::UnitZ(),
                ring(2 * k + 3, -1.0));
  }
  for (std::size_t f = 0; f < 10; ++f) {
    middle_[f] = face[f].axis;
    for (std::size_t other = 10; other < 20; ++other) {
      if (face[other].axis.dot(middle_[f]) < face[opposite_[f]].axis.dot(middle_[f])) opposite_[f] = other;
    }
  }
}

void Icosahedron::set_diamond(std::size_t d, const Vec3& a, const Vec3& p, const Vec3& f, const Vec3& q) {
  face[2 * d] = make_face(a, p, q);
  face[2 * d + 1] = make_face(f, q, p);
}

}  // namespace impinge
