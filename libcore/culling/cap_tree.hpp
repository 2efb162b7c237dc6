// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a surface, vertices or faces, summarised over ever smaller caps of directions.
//
// The nodes are the cells of a quadtree on the six faces of a cube, less those that would have one child. A
// node holds every direction of its parts within `angle` of its axis, and their radii between low and high.
// Sorted by counting and summarised from the leaves to the root: O(parts) time and memory.
//
//   angle of a node: the lesser of
//     max over its children of (angle between the axes + angle of the child),
//     max over the corners of its cell of the angle from the axis, if less than a quarter turn (such a cap is
//     convex and so holds the whole cell), + the largest angle of a part
//
// Numbers are floats, rounded outwards by kNodeSlack, which also covers that an axis is a unit vector to 1e-7
// only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sampling/cap_range.hpp"

namespace impinge {

// A vertex (a cap of no width) or a face.
struct CapItem {
  DirectionCap cap;
  RadiusRange range;  // mm
};

inline constexpr double kNodeSlack = 1e-6;  // of a radius; radians

struct CapNode {
  Eigen::Vector3f axis;
  float angle;          // radians; pi where nothing is known
  float low;            // mm
  float high;           // mm
  float mean;           // 2 / (1 / low + 1 / high), mm
  float spread;         // (high - low) / (2 high): the inverse of a radius is within spread / low of 1 / mean
  std::uint32_t first;  // child, or place of an item in order()
  std::uint32_t count : 31;
  std::uint32_t leaf : 1;
};

class CapTree {
 public:
  static constexpr std::size_t kDeepest = 11;      // levels of cells
  static constexpr std::size_t kMostChildren = 6;  // of the root; 4 elsewhere
  // What a search that opens one node at a time and keeps the rest never has more of.
  static constexpr std::size_t kMostPending = kMostChildren + 3 * kDeepest;

  explicit CapTree(std::span<const CapItem> items);

  // The root is the first; none without items.
  const std::vector<CapNode>& nodes() const& { return nodes_; }
  const std::vector<CapNode>& nodes() const&& = delete;  // they would be gone before they are read
  // Numbers of the items, those of a leaf one after the other.
  const std::vector<std::uint32_t>& order() const { return order_; }
  std::size_t bytes() const {
    return nodes_.size() * sizeof(CapNode) + order_.size() * sizeof(std::uint32_t);
  }

 private:
  std::vector<CapNode> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace impinge
