// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles of two surfaces can meet, or come near each other, while one of them turns about an axis,
// and from which angle on?
//
// Each surface is a tree of spheres, made once for all axes. No turn changes the height of a sphere along the
// axis, its distance from the axis, or its distance from the centre: most pairs never come near each other,
// and for the others the angles have a closed form. The pair that may come near first is looked at next
// (best-first search).
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "contact/turn_surface.hpp"
#include "limits/sinusoid.hpp"

namespace impinge {

/// Triangles in a tree; a point is a triangle without extent. `doubt` of a triangle: it may be nearer than
/// its coordinates say by as much, mm.
class SweptParts {
 public:
  /// A sphere that holds one triangle, or two nodes that come later in the list.
  struct Node {
    Vec3 centre;            // mm
    double radius = 0.0;    // mm, doubt included
    std::uint32_t at = 0;   // index of the triangle, or of the first of the two nodes; the second comes next
    bool leaf = true;       // does it hold one triangle?
    double nearest = 0.0;   // mm, least distance of its triangles from the origin, doubt included
    double farthest = 0.0;  // mm, largest distance of its triangles from the origin, doubt included
  };

  SweptParts() = default;
  explicit SweptParts(std::vector<TurnFace> parts);  // in their centre frame, mm; n log n time

  const std::vector<TurnFace>& parts() const { return parts_; }  // in the order in which they were given
  const std::vector<Node>& nodes() const { return nodes_; }      // the root first; none without triangles
  bool empty() const { return nodes_.empty(); }
  /// Calls visit(index) for all triangles whose spheres come within `distance` of x, mm.
  template <class Visit>
  void visit_near(const Vec3& x, double distance, const Visit& visit) const {
    any_part(distance, x, [&](std::uint32_t part) {
      visit(part);
      return false;
    });
  }
  /// Is found(node) true for the leaf of some triangle, and for all nodes above it?
  template <class Found>
  bool any_node(const Found& found, std::uint32_t from = 0) const {
    if (nodes_.empty() || !found(nodes_[from])) return false;
    const Node& node = nodes_[from];
    return node.leaf || any_node(found, node.at) || any_node(found, node.at + 1);
  }
  /// Is every triangle farther than `distance` from x, mm?
  bool farther_than(double distance, const Vec3& x) const;

 private:
  // Calls found(triangle) for triangles near x until it is true; returns whether it was.
  template <class Found>
  bool any_part(double distance, const Vec3& x, const Found& found) const {
    std::vector<std::uint32_t> pending;
    if (!nodes_.empty()) pending.push_back(0);
    while (!pending.empty()) {
      const Node& node = nodes_[pending.back()];
      pending.pop_back();
      if ((node.centre - x).norm() - node.radius > distance) continue;
      if (!node.leaf)
        pending.insert(pending.end(), {node.at, node.at + 1});
      else if (found(node.at))
        return true;
    }
    return false;
  }
  void split(std::uint32_t* first, std::uint32_t* last, std::uint32_t node);

  std::vector<TurnFace> parts_;
  std::vector<Node> nodes_;
};

/// Is meet(i, j) true for some pair of triangles? A pair of nodes with apart(node, node) is not opened.
/// Triangles and nodes are given by their indices.
template <class Apart, class Meet>
bool any_pair(const SweptParts& one, const SweptParts& other, const Apart& apart, const Meet& meet) {
  if (one.empty() || other.empty()) return false;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pending{{0, 0}};
  while (!pending.empty()) {
    const auto [p, q] = pending.back();
    pending.pop_back();
    const SweptParts::Node& a = one.nodes()[p];
    const SweptParts::Node& b = other.nodes()[q];
    if (apart(p, q)) continue;
    if (a.leaf && b.leaf) {
      if (meet(a.at, b.at)) return true;
      continue;
    }
    const bool open_a = b.leaf || (!a.leaf && a.radius >= b.radius);
    for (std::uint32_t k = 0; k < 2; ++k) pending.emplace_back(open_a ? a.at + k : p, open_a ? q : b.at + k);
  }
  return false;
}

/// A surface that turns and one that rests, each with the rotation to the frame whose +z is the axis.
struct SweptPair {
  const SweptParts& turning;  // borrowed
  Eigen::Matrix3d turning_frame;
  const SweptParts& resting;  // borrowed
  Eigen::Matrix3d resting_frame;
};

/// The spheres of both surfaces in the frame of the axis, each computed when it is first asked for.
class SweptSpheres {
 public:
  explicit SweptSpheres(const SweptPair& pair);

  /// The least angle from `from` on, radians in [0, 2 pi], at which triangles of the two nodes may be within
  /// `within` mm of each other; infinite if they never are.
  double earliest(std::uint32_t turning, std::uint32_t resting, double within, double from);
  /// All such angles of a whole turn: at most two spans, in rising order.
  AngleSpans spans(std::uint32_t turning, std::uint32_t resting, double within);
  double rounding() const { return rounding_; }  // mm, above the rounding of any distance here

 private:
  struct Place {
    Vec3 centre;        // mm, in the frame of the axis
    double arm = -1.0;  // mm, distance from the axis; below 0 if not computed yet
  };
  const Place& turning(std::uint32_t node);
  const Place& resting(std::uint32_t node);

  const SweptPair& pair_;
  std::vector<Place> turning_;
  std::vector<Place> resting_;
  double rounding_;
};

/// Calls meet(i, j) for the pairs of triangles that may come within within(to) mm of each other at an angle
/// from `from` to `to`, radians. Pairs are visited in the order of their earliest angles. meet() returns the
/// new `to`, such as the first contact found so far.
template <class Within, class Meet>
void visit_meetings(const SweptPair& pair, double from, double to, const Within& within, const Meet& meet) {
  if (pair.turning.empty() || pair.resting.empty()) return;
  struct Pending {
    double angle;
    std::uint32_t turning;
    std::uint32_t resting;
    bool operator<(const Pending& other) const { return angle > other.angle; }  // the earliest on top
  };
  SweptSpheres spheres(pair);
  std::priority_queue<Pending> pending;
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    const double angle = spheres.earliest(a, b, within(to), from);
    if (angle <= to) pending.push({angle, a, b});
  };
  add(0, 0);
  while (!pending.empty() && pending.top().angle <= to) {
    const auto [angle, turning, resting] = pending.top();
    pending.pop();
    const SweptParts::Node& a = pair.turning.nodes()[turning];
    const SweptParts::Node& b = pair.resting.nodes()[resting];
    if (a.leaf && b.leaf) {
      to = meet(turning, resting);
    } else if (b.leaf || (!a.leaf && a.radius >= b.radius)) {
      for (std::uint32_t k = 0; k < 2; ++k) add(a.at + k, resting);
    } else {
      for (std::uint32_t k = 0; k < 2; ++k) add(turning, b.at + k);
    }
  }
}

/// Are two faces that do not pierce each other farther apart than `distance`, mm?
bool farther_than(const TurnFace& s, const TurnFace& t, double distance);

/// The distance, mm, that counts as near; its largest value in a span of angles.
using WithinSpan = std::function<double(const AngleSpan&)>;

/// The first angle, radians, up to `largest` in [0, 2 pi], at which turning triangles may be within that
/// distance of those at rest; `largest` if there is none. Before it no pair is as near. At it some pair is,
/// but for what a turn by 1e-5 rad moves it; or for more, where triangles stay nearly as near for long. No
/// faces may pierce each other at the start: distances are those of corners and edges, and such faces may be
/// missed.
double first_within(const SweptPair& pair, const WithinSpan& within, double largest);

}  // namespace impinge
