// SPDX-License-Identifier: GPL-3.0-or-later
// A tree of caps of directions over the items of a surface, its vertices or faces.
//
// A node holds every direction of its items within `angle` of its axis, and their radii between low and high.
// The first block of nodes are the six faces of a cube. Each node has up to eight children, which are worked
// on together: the eighths of its cell or, if it has few items, runs of them, and then the items. Items are
// sorted by counting, and nodes made from the leaves to the root, in O(items). The angle of a node is the
// lesser of
//   max over its children of (angle between the axes + angle of the child),
//   max over the corners of its cell of the angle from the axis, if less than a quarter turn (such a cap is
//   convex and so holds the whole cell), + the largest angle of an item.
// Numbers are floats, rounded outwards by kNodeSlack. That also covers axes that are unit vectors to 1e-7
// only, and callers that compute with nodes in floats.
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

/// A face as an item. If it is a quarter turn wide or more its cap holds all directions, and if it is almost
/// edge-on its range holds all radii up to the largest. std::nullopt if its plane holds the centre, so that
/// it covers no direction.
std::optional<CapItem> cap_item(const TriangleMesh& mesh, const Face& face);

inline constexpr double kNodeSlack = 1e-5;  // as a share of radii, and in radians for angles

/// A number for each node of a block.
using CapLanes = std::array<float, 8>;

/// Up to eight nodes that are siblings.
struct alignas(64) CapBlock {
  static constexpr std::size_t kLanes = std::tuple_size_v<CapLanes>;  // nodes that a block has room for

  CapLanes x, y, z;  // unit axis
  CapLanes angle;    // radians; pi if nothing is known
  CapLanes low;      // mm
  CapLanes high;     // mm
  CapLanes mean;     // 2 / (1 / low + 1 / high), mm; 0 if low is
  CapLanes spread;   // (high - low) / (2 high): the inverse of a radius is within spread / low of 1 / mean
  std::array<std::uint32_t, kLanes>
      first{};  // for a leaf its first place in order(), else the block of its children
  std::array<std::uint32_t, kLanes> items{};  // number of items of a leaf; 0 for other nodes
  std::uint32_t nodes = 0;                    // how many lanes are in use, from the first on

  bool leaf(std::size_t lane) const { return items[lane] > 0; }  // does this node have items, not children?
};

/// Node `lane` of block `block`.
struct CapNode {
  std::uint32_t block;  // place among the blocks
  std::uint32_t lane;   // place in the block
};

class CapTree {
 public:
  static constexpr std::size_t kDeepest = 7;  // levels of cells
  /// The most nodes that wait in a depth-first search: the root's block, and one block of each level of
  /// cells, runs and items.
  static constexpr std::size_t kMostPending = 6 + (CapBlock::kLanes - 1) * (kDeepest + 2);

  explicit CapTree(std::span<const CapItem> items);  // sorts a copy of the items

  const std::vector<CapBlock>& blocks() const& { return blocks_; }  // the root first
  const std::vector<CapBlock>& blocks() const&& = delete;           // they would be gone before they are read
  /// Numbers of the items; the items of a leaf follow each other.
  const std::vector<std::uint32_t>& order() const { return order_; }
  /// Bytes of blocks and order.
  std::size_t bytes() const {
    return blocks_.size() * sizeof(CapBlock) + order_.size() * sizeof(std::uint32_t);
  }

 private:
  std::vector<CapBlock> blocks_;
  std::vector<std::uint32_t> order_;
};

}  // namespace impinge
