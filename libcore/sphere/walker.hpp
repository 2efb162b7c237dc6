// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the entries of a scheme that are inside or near a triangle, by the scheme's own walker or by a tree
// of caps that works for any scheme; and decides exactly which of them are inside.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sphere/direction.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

/// The directions within a margin of a triangle cone, with a test whether a cap surely misses them.
class ConeNeighbourhood {
 public:
  /// `margin` in radians.
  ConeNeighbourhood(const TriangleCone& cone, double margin) : margin_(margin + kRounding) {
    for (const Vec3& x : cone.corners()) axis_ += x.stableNormalized();
    double radius = 0.0;
    for (const Vec3& x : cone.corners()) radius = std::max(radius, angle_between(axis_, x));
    axis_.stableNormalize();
    // A cap of less than a quarter turn is convex: it holds the triangle if it holds the corners.
    reach_ = radius < 0.5 * kPi - kRounding ? radius + margin_ : kPi;
    for (std::size_t k = 0; k < 3; ++k) plane_[k] = cone.corners()[k].cross(cone.corners()[(k + 1) % 3]);
    if (cone.side() < 0)
      for (Vec3& normal : plane_) normal = -normal;
    if (cone.side() == 0) {  // an arc, with both sides of its plane
      plane_[0] = *std::ranges::max_element(plane_, {}, &Vec3::squaredNorm);
      plane_[1] = -plane_[0];
      plane_[2].setZero();
    }
    for (std::size_t k = 0; k < 3; ++k) length_[k] = plane_[k].norm();
    doubt_ = 2.0 * cone.doubt();
    of_direction_ = limits(0.0);
  }

  /// Is every direction within `radius` of the unit vector `axis` surely farther than the margin from the
  /// cone?
  bool misses(const Vec3& axis, double radius) const { return is_beyond(axis, limits(radius)); }
  /// Is the unit vector u surely farther than the margin from the cone?
  bool misses(const Vec3& u) const { return is_beyond(u, of_direction_); }

 private:
  static constexpr double kRounding = 1e-9;  // rad, far above all rounding in this class

  /// Limits beyond which a cap misses the cap round the triangle, or lies on the far side of an edge.
  struct Limits {
    double cosine;  // to the middle of the triangle
    double beside;  // sine above an edge's plane
  };
  Limits limits(double radius) const {
    return {reach_ + radius < kPi ? std::cos(reach_ + radius) : -2.0,
            margin_ + radius < 0.5 * kPi ? std::sin(margin_ + radius) : 2.0};
  }
  bool is_beyond(const Vec3& axis, const Limits& limits) const {
    if (axis.dot(axis_) < limits.cosine) return true;
    for (std::size_t k = 0; k < 3; ++k)
      if (plane_[k].dot(axis) < -limits.beside * length_[k] - doubt_) return true;
    return false;
  }

  double margin_;
  Vec3 axis_ = Vec3::Zero();
  double reach_ = kPi;
  std::array<Vec3, 3> plane_;
  std::array<double, 3> length_{};
  double doubt_ = 0.0;
  Limits of_direction_{};
};

/// A walker for any scheme: a tree of caps round runs of up to 16 consecutive entries that are close to each
/// other. Holds all directions, 24 bytes an entry, and about as much for the tree.
class WalkerTree {
 public:
  /// Asks the scheme for each direction once.
  template <class S>
  explicit WalkerTree(const S& scheme) : directions_(scheme.size()) {
    const double far = 8.0 * scheme.covering_radius();
    std::vector<Leaf> leaves;
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      directions_[i] = scheme.direction(i);
      const bool joins = !leaves.empty() && leaves.back().count < kMostInRun &&
                         (directions_[i] - directions_[leaves.back().first]).norm() < far;
      if (!joins) leaves.push_back({i, 0, Vec3::Zero(), 0.0});
      ++leaves.back().count;
    }
    for (Leaf& leaf : leaves) enclose(leaf);
    nodes_.reserve(2 * leaves.size());
    build(leaves);
  }

  template <class Visit>
  void visit_near(const TriangleCone& cone, double margin, Visit&& visit) const {
    const ConeNeighbourhood near(cone, margin);
    for (std::size_t k = 0; k < nodes_.size();) {
      const Node& node = nodes_[k];
      if (near.misses(node.axis, node.radius)) {
        k = node.after;
        continue;
      }
      visit_leaf(node, near, visit);
      ++k;
    }
  }

 private:
  static constexpr std::size_t kMostInRun = 16;

  /// Entries first .. first + count - 1, within `radius` of the axis.
  struct Leaf {
    std::size_t first;
    std::size_t count;
    Vec3 axis;
    double radius;
  };
  /// Nodes are in the order of a walk from the root; `after` is the first node that is not below this one.
  /// Only leaves have entries; elsewhere count is 0.
  struct Node : Leaf {
    std::size_t after;
  };

  /// Visits the entries of a leaf, in runs, without those that are surely too far.
  template <class Visit>
  void visit_leaf(const Leaf& leaf, const ConeNeighbourhood& near, Visit&& visit) const {
    const std::size_t end = leaf.first + leaf.count;
    for (std::size_t from = leaf.first; from < end; ++from) {
      const std::size_t first = from;
      while (from < end && !near.misses(directions_[from])) ++from;
      if (first == from) continue;
      visit_in_runs(
          first, from - first, [&](std::size_t i) { return directions_[first + i]; }, visit);
    }
  }

  void enclose(Leaf& leaf) const {
    const std::span entries(directions_.data() + leaf.first, leaf.count);
    for (const Vec3& u : entries) leaf.axis += u;
    leaf.axis = leaf.axis.isZero() ? entries[0] : Vec3(leaf.axis.normalized());
    for (const Vec3& u : entries) leaf.radius = std::max(leaf.radius, angle_between(leaf.axis, u));
  }

  /// Halves the leaves along the axis of space in which they spread most.
  void build(std::span<Leaf> leaves) {
    if (leaves.empty()) return;
    const std::size_t here = nodes_.size();
    if (leaves.size() == 1) {
      nodes_.push_back({leaves[0], here + 1});
      return;
    }
    Vec3 sum = Vec3::Zero();
    Vec3 low = leaves[0].axis;
    Vec3 high = low;
    for (const Leaf& leaf : leaves) {
      sum += leaf.axis;
      low = low.cwiseMin(leaf.axis);
      high = high.cwiseMax(leaf.axis);
    }
    Leaf all{0, 0, sum.isZero() ? leaves[0].axis : Vec3(sum.normalized()), 0.0};
    for (const Leaf& leaf : leaves)
      all.radius = std::max(all.radius, angle_between(all.axis, leaf.axis) + leaf.radius);
    nodes_.push_back({all, 0});
    Eigen::Index widest = 0;
    (high - low).maxCoeff(&widest);
    const std::size_t half = leaves.size() / 2;
    std::nth_element(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(half), leaves.end(),
                     [widest](const Leaf& a, const Leaf& b) { return a.axis[widest] < b.axis[widest]; });
    build(leaves.first(half));
    build(leaves.subspan(half));
    nodes_[here].after = nodes_.size();
  }

  std::vector<Vec3> directions_;
  std::vector<Node> nodes_;
};

/// The scheme's own walker, or else a WalkerTree. Make it once for many triangles: the tree looks at every
/// entry.
template <class S>
decltype(auto) walker_of(const S& scheme) {
  if constexpr (HasWalker<S>) {
    return scheme.walker();
  } else {
    return WalkerTree(scheme);
  }
}

/// Calls visit(entry, direction) once for every entry inside the cone or within `margin` radians of it, and
/// perhaps some outside.
template <class Walker, class Visit>
void for_each_entry_near(const Walker& walker, const TriangleCone& cone, double margin, Visit&& visit) {
  walker.visit_near(cone, margin, [&](const DirectionRun& run) {
    for (std::size_t k = 0; k < run.count; ++k) visit(run.first + k, run[k]);
  });
}

/// Calls visit(entry, direction) once for every entry whose direction the cone contains, boundary included.
/// The tests of a run are computed together, which the compiler turns into vector instructions; those in
/// doubt are decided exactly.
template <class Walker, class Visit>
void for_each_entry_inside(const Walker& walker, const TriangleCone& cone, Visit&& visit) {
  const double doubt = cone.doubt();
  walker.visit_near(cone, 0.0, [&](const DirectionRun& run) {
    std::array<double, DirectionRun::kMost> least;
    for (std::size_t k = 0; k < run.count; ++k)
      least[k] = cone.least_edge_distance(run.x[k], run.y[k], run.z[k]);
    for (std::size_t k = 0; k < run.count; ++k) {
      if (least[k] < -doubt) continue;
      const Vec3 u = run[k];
      if (least[k] > doubt || cone.contains(u)) visit(run.first + k, u);
    }
  });
}

}  // namespace impinge
