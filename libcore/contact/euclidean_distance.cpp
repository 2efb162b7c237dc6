// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/euclidean_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "contact/part_distance.hpp"
#include "mesh/lengths.hpp"
#include "mesh/triangle_distance.hpp"
#include "sphere/infinity.hpp"

namespace impinge {
namespace {

using Box = Eigen::AlignedBox3d;

// The distance from some point of the face: one of a side, or one next to the foot of x. However wrong a thin
// face's normal makes the weights of the corners, they give a point of the face.
double enough_distance(const Vec3& x, const TurnFace& face) {
  const auto& [a, b, c] = face.corner;
  const double sides = std::sqrt(squared_distance_to_sides(x, a, b, c));
  const double squared = face.normal.squaredNorm();
  if (!(squared > 0.0)) return sides;
  const double of_b = face.normal.dot((x - a).cross(c - a)) / squared;
  const double of_c = face.normal.dot((b - a).cross(x - a)) / squared;
  if (!(of_b >= 0.0 && of_c >= 0.0 && of_b + of_c <= 1.0)) return sides;
  return std::min(sides, (x - a - of_b * (b - a) - of_c * (c - a)).norm());
}

// The functions that Eigen's search calls.
// NOLINTBEGIN(readability-identifier-naming): Eigen's names
struct NearestFace {
  using Scalar = double;
  double minimumOnVolume(const Box& box) const { return box.exteriorDistance(x); }
  double minimumOnObject(int at) {
    const TurnFace& face = faces[static_cast<std::size_t>(at)];
    const double least = least_distance(x, face);
    upper = std::min(upper, face.thin ? enough_distance(x, face) : least);
    return least;
  }

  const Vec3& x;
  const std::vector<TurnFace>& faces;
  double upper = kInfinity;
};
// NOLINTEND(readability-identifier-naming)

}  // namespace

EuclideanDistance::EuclideanDistance(const TriangleMesh& mesh) {
  if (mesh.faces.empty())
    throw std::invalid_argument("mesh: it has no faces, so there is no distance to it; read another file");
  std::vector<Box> boxes;
  require_lengths(mesh);
  for (const Face& face : mesh.faces) {
    faces_.push_back(turn_face(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)));
    Box box;
    for (const Vec3& v : faces_.back().corner) {
      box.extend(v);
      farthest_ = std::max(farthest_, v.norm());
    }
    boxes.push_back(box);
  }
  std::vector<int> order(faces_.size());
  std::iota(order.begin(), order.end(), 0);
  boxes_.init(order.begin(), order.end(), boxes.begin(), boxes.end());
}

DistanceBracket EuclideanDistance::at(const Vec3& x) const {
  NearestFace nearest{x, faces_};
  const double lower = Eigen::BVMinimize(boxes_, nearest);
  const double allowance = kDistanceAllowance * (x.norm() + farthest_);
  return {std::max(lower - allowance, 0.0), nearest.upper + allowance};
}

}  // namespace impinge
