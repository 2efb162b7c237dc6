// SPDX-License-Identifier: GPL-3.0-or-later
#include "23_detection_diagrams/plane_section.hpp"

namespace impinge::lab {
namespace {

// Of the edge between a corner at height front >= 0 and one at height behind < 0: the same bits from either
// of its faces.
Vec3 edge_crossing(const Vec3& in_front, double front, const Vec3& at_back, double behind) {
  return in_front + front / (front - behind) * (at_back - in_front);
}

}  // namespace

std::vector<Segment> plane_section(const TriangleMesh& mesh, const Vec3& normal) {
  std::vector<Segment> section;
  for (const Face& face : mesh.faces) {
    std::array<double, 3> height{};
    for (std::size_t k = 0; k < 3; ++k) height[k] = normal.dot(corner(mesh, face, k));
    const auto front = [&](std::size_t k) { return height[k % 3] >= 0.0; };
    for (std::size_t k = 0; k < 3; ++k) {
      const bool alone = front(k) != front(k + 1) && front(k) != front(k + 2);
      if (!alone) continue;
      Segment segment;
      for (std::size_t j = 0; j < 2; ++j) {
        const std::size_t other = (k + 1 + j) % 3;
        const std::size_t a = front(k) ? k : other;
        const std::size_t b = front(k) ? other : k;
        segment[j] = edge_crossing(corner(mesh, face, a), height[a], corner(mesh, face, b), height[b]);
      }
      section.push_back(segment);
    }
  }
  return section;
}

}  // namespace impinge::lab
