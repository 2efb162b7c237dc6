// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a surface, vertices or faces, summarised over ever smaller caps of directions.
//
// The six faces of a cube are the first block of nodes, and each node has up to eight children, which are
// worked on together: the eighths of its cell, or, of a few parts, runs of them along the curve of the cells,
// and then the parts themselves. A node holds every direction of its parts within `angle` of its axis, and
// their radii between low and high. Sorted by counting and summarised from the leaves to the root: O(parts)
// time and memory.
//
//   angle of a node: the lesser of
//     max over its children of (angle between the axes + angle of the child),
//     max over the corners of its cell of the angle from the axis, if less than a quarter turn (such a cap is
//     convex and so holds the whole cell), + the largest angle of a part
//
// Numbers are floats, rounded outwards by kNodeSlack. That also covers that an axis is a unit vector to 1e-7
// only and that callers compute with nodes in floats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "table/face_cap.hpp"

namespace impinge {

/// A vertex (a cap of no width) or a face.
struct CapItem {
  DirectionCap cap;   // its directions
  RadiusRange range;  // mm
};

/// A face as an item. Its cap is all directions if it is a quarter turn wide or more, its range all radii up
/// to the largest if it is almost edge-on. None if its plane holds the centre: it covers no direction.
std::optional<CapItem> cap_item(const TriangleMesh& mesh, const Face& face);

inline constexpr double kNodeSlack = 1e-5;  // share of a radius; radians of an angle

/// A number for each node of a block.
using CapLanes = std::array<float, 8>;

/// Up to eight nodes that are siblings.
struct alignas(64) CapBlock {
  static constexpr std::size_t kLanes = std::tuple_size_v<CapLanes>;  // nodes that a block has room for

  CapLanes x, y, z;  // unit axis
  CapLanes angle;    // radians; pi where nothing is known
  CapLanes low;      // mm
  CapLanes high;     // mm
  CapLanes mean;     // 2 / (1 / low + 1 / high), mm; 0 if low is
  CapLanes spread;   // (high - low) / (2 high): the inverse of a radius is within spread / low of 1 / mean
  std::array<std::uint32_t, kLanes>
      first{};  // of a leaf, its first place in order(); else the block of its children
  std::array<std::uint32_t, kLanes> items{};  // number of items of a leaf; 0 in other nodes
  std::uint32_t nodes = 0;                    // how many of the eight are in use, the first ones

  bool leaf(std::size_t lane) const { return items[lane] > 0; }  // Has this node items, and no children?
};

/// Node `lane` of block `block`.
struct CapNode {
  std::uint32_t block;  // place among the blocks
  std::uint32_t lane;   // place in the block
};

class CapTree {
 public:
  static constexpr std::size_t kDeepest = 7;  // levels of cells
  /// Most nodes that wait in a depth-first search: those of the root's block, and of one block of each level
  /// of cells, runs and parts.
  static constexpr std::size_t kMostPending = 6 + (CapBlock::kLanes - 1) * (kDeepest + 2);

  explicit CapTree(std::span<const CapItem> items);  // sorts the items, which are copied

  const std::vector<CapBlock>& blocks() const& { return blocks_; }  // the root first
  const std::vector<CapBlock>& blocks() const&& = delete;           // they would be gone before they are read
  /// Numbers of the items, those of a leaf one after the other.
  const std::vector<std::uint32_t>& order() const { return order_; }
  /// Memory of blocks and order.
  std::size_t bytes() const {
    return blocks_.size() * sizeof(CapBlock) + order_.size() * sizeof(std::uint32_t);
  }

 private:
  std::vector<CapBlock> blocks_;
  std::vector<std::uint32_t> order_;
};

}  // namespace impinge
