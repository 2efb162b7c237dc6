// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/length_unit.hpp"

#include <algorithm>
#include <limits>

#include "files/formatted.hpp"

namespace impinge {
namespace {

constexpr double kApart = 5.0;         // times as far; radii of ball and socket differ by a tenth or so
constexpr double kSmallest = 5.0;      // mm
constexpr double kLargest = 50.0;      // mm
constexpr double kLeastOfAny = 0.1;    // mm, of any animal
constexpr double kMostOfAny = 1000.0;  // mm

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

std::string different_units(const Reach& ball, const Reach& socket, double ratio) {
  const bool far = socket.nearest > kApart * ball.farthest || ball.nearest > kApart * socket.farthest;
  if (!far && !(ratio > kApart) && !(ratio < 1.0 / kApart)) return {};
  return formatted(
      "lies %.3g to %.3g mm from the centre of rotation, and the ball %.3g to %.3g mm; check that both "
      "meshes "
      "are in mm and in one frame",
      socket.nearest, socket.farthest, ball.nearest, ball.farthest);
}

std::string wrong_unit(double ball_radius) {
  if (!(ball_radius < kLeastOfAny) && !(ball_radius > kMostOfAny)) return {};
  const bool small = ball_radius < kLeastOfAny;
  return formatted(
      "has a radius of %.3g mm, which no joint has; lengths are read as mm: scale both meshes by %s if they "
      "are in %s",
      ball_radius, small ? "1000" : "0.001", small ? "metres" : "micrometres");
}

std::string doubtful_unit(double ball_radius) {
  if (!(ball_radius < kSmallest) && !(ball_radius > kLargest)) return {};
  return formatted(
      "has a radius of %.3g mm, and a human joint 5 to 50; lengths are read as mm, scale both meshes if "
      "theirs are in another unit",
      ball_radius);
}

}  // namespace impinge
