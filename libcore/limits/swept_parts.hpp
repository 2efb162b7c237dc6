// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of two surfaces can meet, or come near each other, while one of them turns about an axis, and
// from which angle on.
//
// Both are trees of spheres, made once for all axes. Two spheres whose centres are at heights z and y above
// the plane across the axis, at a and b from it and at azimuths f + t and g are D apart where
//   4 a b sin^2((f + t - g) / 2) = D^2 - (z - y)^2 - (a - b)^2,
// which gives the angles at which their contents may be that near, whatever they are. No turn changes a
// distance from the origin: where one is farther out than the other by more than that, as a socket is than
// most of the head, they never are. The pair that may be first is opened next (best-first search), so that
// few pairs of parts are looked at and none is missed that could be first.
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

/// Triangles (a point is one without extent), in a tree. `doubt` of a part, mm, is by how much nearer it may
/// be than it is drawn.
class SweptParts {
 public:
  /// A sphere that holds one part, or two nodes further on.
  struct Node {
    Vec3 centre;            // mm
    double radius = 0.0;    // mm, doubt included
    std::uint32_t at = 0;   // of the part, or of the first of the two nodes
    bool leaf = true;       // is it one part?
    double nearest = 0.0;   // mm, of the parts from the origin, doubt included
    double farthest = 0.0;  // mm, the same
  };

  SweptParts() = default;
  explicit SweptParts(std::vector<TurnFace> parts);  // in their centre frame, mm; takes n log n

  const std::vector<TurnFace>& parts() const { return parts_; }  // in their order
  const std::vector<Node>& nodes() const { return nodes_; }      // the root first; none without parts
  bool empty() const { return nodes_.empty(); }
  /// Calls visit(part) for those whose spheres come within `distance` of x, mm.
  template <class Visit>
  void visit_near(const Vec3& x, double distance, const Visit& visit) const {
    any_part(distance, x, [&](std::uint32_t part) {
      visit(part);
      return false;
    });
  }
  /// Does some part have found(node) true of its sphere, and of all that hold it?
  template <class Found>
  bool any_node(const Found& found, std::uint32_t from = 0) const {
    if (nodes_.empty() || !found(nodes_[from])) return false;
    const Node& node = nodes_[from];
    return node.leaf || any_node(found, node.at) || any_node(found, node.at + 1);
  }
  /// Is every part farther than `distance` from x? mm.
  bool farther_than(double distance, const Vec3& x) const;

 private:
  // Until found(part) is true.
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

/// Is meet(part, part) true of two parts? Nodes of which apart(node, node) is true are not opened. All by
/// their places.
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

/// The spheres of both as the axis sees them.
class SweptSpheres {
 public:
  explicit SweptSpheres(const SweptPair& pair);

  /// The least angle from `from` on, radians in [0, 2 pi], at which the contents of two nodes may be within
  /// that distance, mm; infinite if they never are.
  double earliest(std::uint32_t turning, std::uint32_t resting, double within, double from);
  /// All such angles of a turn: at most two spans, the first that begins first.
  AngleSpans spans(std::uint32_t turning, std::uint32_t resting, double within);
  double rounding() const { return rounding_; }  // mm, more than that of any distance here

 private:
  struct Place {
    Vec3 centre;        // mm, in the frame of the axis
    double arm = -1.0;  // mm, from the axis; not worked out yet if below 0
  };
  const Place& turning(std::uint32_t node);
  const Place& resting(std::uint32_t node);

  const SweptPair& pair_;
  std::vector<Place> turning_;
  std::vector<Place> resting_;
  double rounding_;
};

/// Calls meet(i, j) for pairs of parts that may come within within(to) of each other, mm, at an angle from
/// `from` to `to`, radians, in the order of the earliest one. meet() returns the `to` that holds from then
/// on: the first angle found so far.
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

/// Are these farther apart than `distance`, mm? Of no use where they pierce each other.
bool farther_than(const TurnFace& s, const TurnFace& t, double distance);

/// The largest distance that is asked for in a span of angles, mm.
using WithinSpan = std::function<double(const AngleSpan&)>;

/// The first angle up to `largest` at which the turning parts may be within that distance of those at rest;
/// no pair is before, and what is returned is early by the way of 1e-5 rad at most unless parts stay about as
/// near as that; `largest` if there is none. largest in [0, 2 pi].
/// Parts that pierce each other at the start may go unseen: distances are those of corners and edges.
double first_within(const SweptPair& pair, const WithinSpan& within, double largest);

}  // namespace impinge
