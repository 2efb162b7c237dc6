// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/length_unit.hpp"

#include <algorithm>
#include <limits>

#include "detection/formatted.hpp"

namespace impinge {
namespace {

constexpr double kApart = 5.0;       // times as far; radii of ball and socket differ by a tenth or so
constexpr double kSmallest = 0.1;    // mm
constexpr double kLargest = 1000.0;  // mm

}  // namespace

Reach reach_of(const TriangleMesh& mesh) {
  Reach reach{std::numeric_limits<double>::infinity(), 0.0};
  for (const Face& face : mesh.faces) {
    for (const VertexIndex v : face) {
      const double distance = mesh.vertices[v].norm();
      reach.nearest = std::min(reach.nearest, distance);
      reach.farthest = std::max(reach.farthest, distance);
    }
  }
  return reach;
}

std::string different_units(const Reach& ball, const Reach& socket) {
  const bool far = socket.nearest > kApart * ball.farthest || ball.nearest > kApart * socket.farthest;
  if (!far) return {};
  return formatted(
      "lies %.3g to %.3g mm from the centre of rotation, and the ball %.3g to %.3g mm; check that both "
      "meshes "
      "are in mm and in one frame",
      socket.nearest, socket.farthest, ball.nearest, ball.farthest);
}

std::string doubtful_unit(const Reach& ball) {
  if (ball.farthest >= kSmallest && ball.farthest <= kLargest) return {};
  return formatted(
      "reaches %.3g mm from the centre of rotation, which no joint does; lengths are read as mm, scale "
      "both meshes if theirs are in another unit",
      ball.farthest);
}

}  // namespace impinge
