// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sphere_section.hpp"

#include <cmath>

namespace impinge {
namespace {

// |a + t (b - a)| = radius for a inside and b outside: the larger root of the quadratic, which is in (0, 1].
Vec3 crossing(const Vec3& inside, const Vec3& outside, double radius) {
  const Vec3 step = outside - inside;
  const double half = inside.dot(step);
  const double missing = radius * radius - inside.squaredNorm();
  const double root = std::sqrt(half * half + step.squaredNorm() * missing);
  return inside + missing / (half + root) * step;
}

}  // namespace

std::vector<Segment> sphere_section(const TriangleMesh& mesh, double radius) {
  std::vector<Segment> section;
  for (const Face& face : mesh.faces) {
    std::array<bool, 3> outside{};
    for (std::size_t k = 0; k < 3; ++k) outside[k] = corner(mesh, face, k).norm() >= radius;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool alone = outside[k] != outside[(k + 1) % 3] && outside[k] != outside[(k + 2) % 3];
      if (!alone) continue;
      Segment segment;
      for (std::size_t j = 0; j < 2; ++j) {
        const Vec3& one = corner(mesh, face, k);
        const Vec3& other = corner(mesh, face, (k + 1 + j) % 3);
        segment[j] = outside[k] ? crossing(other, one, radius) : crossing(one, other, radius);
      }
      section.push_back(segment);
    }
  }
  return section;
}

}  // namespace impinge
