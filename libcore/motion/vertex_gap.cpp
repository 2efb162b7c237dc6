// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/vertex_gap.hpp"

#include <cmath>

namespace impinge {
namespace {

constexpr double kMargin = 1e-9;  // radians

// Sign of the gap |x| - r: +1 for a vertex of the socket over the ball, -1 for one of the ball under the
// socket.
struct Scan {
  const NearFaces& surface;
  Layer layer;
  double sign;
};

std::optional<double> gap(const Scan& scan, const Vec3& x, double smallest) {
  const double length = x.norm();
  if (length == 0.0) return std::nullopt;
  const NearFaces::Near near = scan.surface.near(x);
  if (near.nothing()) return std::nullopt;
  const double least = scan.sign > 0.0 ? length - near.range.high : near.range.low - length;
  if (least >= smallest) return std::nullopt;
  const double radius = scan.surface.radius(x / length, near, scan.layer);
  if (std::isnan(radius)) return std::nullopt;
  return scan.sign * (length - radius);
}

}  // namespace

VertexGaps::VertexGaps(const TriangleMesh& ball, const TriangleMesh& socket)
    : ball_(ball, kMargin), socket_(socket, kMargin) {}

std::optional<VertexGap> VertexGaps::smallest(const Pose& pose) const {
  std::optional<VertexGap> found;
  double smallest = HUGE_VAL;
  const auto consider = [&](const Scan& scan, const Vec3& x, const Vec3& place) {
    const auto here = gap(scan, x, smallest);
    if (!here || *here >= smallest) return;
    smallest = *here;
    found = VertexGap{*here, place};
  };
  for (const Vec3& v : ball_.mesh().vertices) {
    const Vec3 x = to_socket(pose, v);
    consider({socket_, Layer::nearest, -1.0}, x, x);
  }
  for (const Vec3& v : socket_.mesh().vertices) consider({ball_, Layer::farthest, 1.0}, to_ball(pose, v), v);
  return found;
}

}  // namespace impinge
