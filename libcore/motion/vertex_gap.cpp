// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/vertex_gap.hpp"

#include <cmath>

namespace impinge {
namespace {

constexpr double kMargin = 1e-9;  // radians

// Of a vertex of that surface, at x in the frame of the other one; none if it is not below the smallest.
std::optional<double> gap(Surface of, const NearFaces& met, const Vec3& x, double smallest) {
  const double length = x.norm();
  if (length == 0.0) return std::nullopt;
  const NearFaces::Near near = met.near(x);
  if (near.nothing()) return std::nullopt;
  if (signed_gap(of, near.range, length).low >= smallest) return std::nullopt;
  const double radius = met.radius(x / length, near, facing_layer(other(of)));
  if (std::isnan(radius)) return std::nullopt;
  return signed_gap(of, radius, length);
}

}  // namespace

VertexGaps::VertexGaps(const TriangleMesh& ball, const TriangleMesh& socket)
    : ball_(ball, kMargin), socket_(socket, kMargin) {}

std::optional<VertexGap> VertexGaps::smallest(const Pose& pose) const {
  std::optional<VertexGap> found;
  double smallest = HUGE_VAL;
  for (const Surface of : kSurfaces) {
    const bool ball = of == Surface::ball;
    for (const Vec3& v : (ball ? ball_ : socket_).mesh().vertices) {
      const Vec3 x = to_other(of, pose, v);
      const auto here = gap(of, ball ? socket_ : ball_, x, smallest);
      if (!here || *here >= smallest) continue;
      smallest = *here;
      found = VertexGap{*here, ball ? x : v};
    }
  }
  return found;
}

}  // namespace impinge
