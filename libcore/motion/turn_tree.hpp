// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of two bodies can meet while one of them turns about an axis, and from which angle on.
//
// A turn about +z keeps of every point its height z, its distance rho from the axis and its distance r from
// the centre, and adds the angle to its azimuth. So two parts can only meet if their ranges of z, rho and r
// overlap, and not before the angle at which those of their azimuths begin to. A tree over such boxes for
// each body, opened pair by pair from the earliest angle on (best-first search), visits few of the pairs of
// parts and misses none that could be first.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <span>
#include <vector>

#include "sphere/direction.hpp"

namespace impinge {

/// Where a part is as seen from the axis, +z through the centre.
struct TurnBox {
  double z_low = HUGE_VAL;      // mm, least height
  double z_high = -HUGE_VAL;    // mm, largest height
  double rho_low = HUGE_VAL;    // mm, least distance from the axis
  double rho_high = -HUGE_VAL;  // mm, largest distance from the axis
  double r_low = HUGE_VAL;      // mm, least distance from the centre
  double r_high = -HUGE_VAL;    // mm, largest distance from the centre
  double from = 0.0;            // radians, where the azimuths begin
  double to = 0.0;              // radians, where they end; a turn or more after `from`: all round
};

/// A point by what a turn keeps of it, and its azimuth.
struct TurnPoint {
  TurnPoint() = default;
  explicit TurnPoint(const Vec3& at);  // mm, in the frame of the axis

  Vec3 x = Vec3::Zero();  // mm
  double rho = 0.0;       // mm from the axis
  double r = 0.0;         // mm from the centre
  double azimuth = 0.0;   // radians
};

/// The box of all points within `margin` mm of a point, of an edge or of a triangle, by its one to three
/// corners. r_low: a distance from the centre that none of the points is below, before the margin.
TurnBox turn_box(std::span<const TurnPoint* const> corners, double r_low, double margin);

/// The smallest box that holds both.
TurnBox joined(const TurnBox& a, const TurnBox& b);

/// The earliest angle from `from` on, radians, at which the contents of two boxes can meet when those of the
/// first turn; infinite if they never can. No contact is missed by rounding.
double earliest_meeting(const TurnBox& turning, const TurnBox& resting, double from);

/// Places of the points in an order of which halves, quarters and so on lie together. O(n log n).
std::vector<std::uint32_t> order_by_place(std::span<const Vec3> points);

/// A balanced binary tree over boxes, in a given order: the boxes change with the axis, the order need not.
class TurnTree {
 public:
  TurnTree() = default;
  /// boxes[order[k]] is the kth leaf. Takes linear time.
  TurnTree(std::span<const TurnBox> boxes, std::span<const std::uint32_t> order);

  bool empty() const { return nodes_.empty(); }
  const TurnBox& box(std::uint32_t node) const { return nodes_[node].box; }
  bool is_leaf(std::uint32_t node) const { return nodes_[node].count == 1; }
  /// How many leaves the node has.
  std::uint32_t count(std::uint32_t node) const { return nodes_[node].count; }
  /// The box, by its place among those given, of a leaf.
  std::uint32_t item(std::uint32_t node) const { return nodes_[node].item; }
  /// Node 0 is the root; both halves of another node.
  static std::uint32_t first_half(std::uint32_t node) { return node + 1; }
  std::uint32_t second_half(std::uint32_t node) const { return node + 2 * (nodes_[node].count / 2); }

 private:
  struct Node {
    TurnBox box;
    std::uint32_t count;  // of leaves
    std::uint32_t item;   // of a leaf
  };
  void lay_out(std::span<const std::uint32_t> order);

  std::vector<Node> nodes_;
};

/// Calls meet(i, j) for pairs of items that can meet at an angle from `from` to `to`, radians, in the order
/// of the earliest one. meet() returns the `to` that holds from then on: the first contact found so far.
template <class Meet>
void visit_meetings(const TurnTree& turning, const TurnTree& resting, double from, double to,
                    const Meet& meet) {
  if (turning.empty() || resting.empty()) return;
  struct Pair {
    double angle;
    std::uint32_t turning;
    std::uint32_t resting;
    bool operator<(const Pair& other) const { return angle > other.angle; }
  };
  std::priority_queue<Pair> pending;
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    const double angle = earliest_meeting(turning.box(a), resting.box(b), from);
    if (angle <= to) pending.push({angle, a, b});
  };
  add(0, 0);
  while (!pending.empty() && pending.top().angle <= to) {
    const auto [angle, a, b] = pending.top();
    pending.pop();
    if (turning.is_leaf(a) && resting.is_leaf(b)) {
      to = meet(turning.item(a), resting.item(b));
    } else if (turning.count(a) >= resting.count(b)) {
      add(TurnTree::first_half(a), b);
      add(turning.second_half(a), b);
    } else {
      add(a, TurnTree::first_half(b));
      add(a, resting.second_half(b));
    }
  }
}

}  // namespace impinge
