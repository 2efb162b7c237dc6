// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/euclidean_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

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

using Tree = Eigen::KdBVH<double, 3, int>;

// The face nearest to a point. Eigen's own search starts from nothing, and keeps a queue.
class NearestFace {
 public:
  NearestFace(const Vec3& x, const std::vector<TurnFace>& faces, const Tree& tree)
      : x_(x), faces_(faces), tree_(tree) {}

  void look_at(int face) {
    const TurnFace& at = faces_[static_cast<std::size_t>(face)];
    const double least = least_distance(x_, at);
    upper_ = std::min(upper_, at.thin ? enough_distance(x_, at) : least);
    if (least >= lower_) return;
    lower_ = least;
    face_ = face;
  }

  // The nearer child first; leaves out boxes no nearer than the nearest face so far.
  void search(int node) {
    Tree::VolumeIterator box{}, last_box{};
    Tree::ObjectIterator face{}, last_face{};
    tree_.getChildren(node, box, last_box, face, last_face);
    for (; face != last_face; ++face) look_at(*face);
    if (box == last_box) return;
    std::array<std::pair<double, int>, 2> children;
    std::size_t count = 0;
    for (; box != last_box; ++box)
      children[count++] = {tree_.getVolume(*box).squaredExteriorDistance(x_), *box};
    if (count == 2 && children[1].first < children[0].first) std::swap(children[0], children[1]);
    for (std::size_t k = 0; k < count; ++k)
      if (children[k].first < lower_ * lower_) search(children[k].second);
  }

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  int face() const { return face_; }

 private:
  const Vec3& x_;
  const std::vector<TurnFace>& faces_;
  const Tree& tree_;
  double lower_ = kInfinity;
  double upper_ = kInfinity;
  int face_ = 0;
};

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

std::vector<DistanceBracket> EuclideanDistance::at(std::span<const Vec3> points) const {
  std::vector<DistanceBracket> found;
  found.reserve(points.size());
  int face = 0;
  for (const Vec3& x : points) {
    NearestFace nearest(x, faces_, boxes_);
    nearest.look_at(face);
    nearest.search(boxes_.getRootIndex());
    const double allowance = kDistanceAllowance * (x.norm() + farthest_);
    found.push_back({std::max(nearest.lower() - allowance, 0.0), nearest.upper() + allowance});
    face = nearest.face();
  }
  return found;
}

}  // namespace impinge
