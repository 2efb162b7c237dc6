// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a surface, vertices or faces, summarised over ever smaller caps of directions.
//
// The nodes are the cells of a quadtree on the six faces of a cube, less those that would have one child, in
// blocks of up to four siblings that are worked on together. A node holds every direction of its parts within
// `angle` of its axis, and their radii between low and high. Sorted by counting and summarised from the
// leaves to the root: O(parts) time and memory.
//
//   angle of a node: the lesser of
//     max over its children of (angle between the axes + angle of the child),
//     max over the corners of its cell of the angle from the axis, if less than a quarter turn (such a cap is
//     convex and so holds the whole cell), + the largest angle of a part
//
// Numbers are floats, rounded outwards by kNodeSlack. That also covers that an axis is a unit vector to 1e-7
// only and that what is worked out of a node is worked out in floats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sampling/cap_range.hpp"

namespace impinge {

// A vertex (a cap of no width) or a face.
struct CapItem {
  DirectionCap cap;   // its directions
  RadiusRange range;  // mm
};

inline constexpr double kNodeSlack = 1e-5;  // of a radius; radians

// A number of each node of a block.
using CapLanes = Eigen::Array4f;

// Up to four nodes that are siblings.
struct CapBlock {
  static constexpr std::size_t kLanes = 4;  // nodes that a block has room for

  CapLanes x, y, z;  // unit axis
  CapLanes angle;    // radians; pi where nothing is known
  CapLanes low;      // mm
  CapLanes high;     // mm
  CapLanes mean;     // 2 / (1 / low + 1 / high), mm; 0 if low is
  CapLanes spread;   // (high - low) / (2 high): the inverse of a radius is within spread / low of 1 / mean
  std::array<std::uint32_t, kLanes>
      first{};  // place of an item in order(); without items, the block of its children
  std::array<std::uint32_t, kLanes> items{};  // of a leaf; 0 in other nodes
  std::uint32_t nodes = 0;                    // of the four, the first so many are there

  bool leaf(std::size_t lane) const { return items[lane] > 0; }  // Has this node items, and no children?
};

// Node `lane` of block `block`.
struct CapNode {
  std::uint32_t block;  // place among the blocks
  std::uint32_t lane;   // place in the block
};

class CapTree {
 public:
  static constexpr std::size_t kDeepest = 11;  // levels of cells
  static constexpr std::size_t kRoots = 2;     // blocks of the six faces of the cube, the first ones
  // Nodes that a search has at most which opens one at a time, the last that it found.
  static constexpr std::size_t kMostPending = 6 + 3 * (kDeepest + 1);

  explicit CapTree(std::span<const CapItem> items);  // sorts the items, which are copied

  const std::vector<CapBlock>& blocks() const& { return blocks_; }  // the roots first
  const std::vector<CapBlock>& blocks() const&& = delete;           // they would be gone before they are read
  // Numbers of the items, those of a leaf one after the other.
  const std::vector<std::uint32_t>& order() const { return order_; }
  // Memory of blocks and order.
  std::size_t bytes() const {
    return blocks_.size() * sizeof(CapBlock) + order_.size() * sizeof(std::uint32_t);
  }

 private:
  std::vector<CapBlock> blocks_;
  std::vector<std::uint32_t> order_;
};

}  // namespace impinge
