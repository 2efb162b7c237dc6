// SPDX-License-Identifier: GPL-3.0-or-later
// Searches of trees of caps, the likeliest nodes first.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "contact/cap_tree.hpp"

namespace impinge {

/// The nodes of a tree that a depth-first search still has to visit.
struct PendingBlocks {
  std::array<std::uint32_t, CapTree::kMostPending> blocks;
  std::size_t count = 0;

  void push(std::uint32_t block) { blocks[count++] = block; }
  std::uint32_t pop() { return blocks[--count]; }
};

inline Vec3 axis_of(const CapBlock& block, std::size_t k) { return {block.x[k], block.y[k], block.z[k]}; }

/// Calls found(item) for items of a tree until it is true; returns whether it was. Of the nodes found last
/// the one with the largest depth comes first; nodes with a depth below 0 are left out. Ends after
/// most_items.
template <class Depth, class Found>
bool search_deepest(const CapTree& tree, std::size_t most_items, const Depth& depth_of, const Found& found) {
  PendingBlocks pending;
  pending.push(0);
  std::size_t asked = 0;
  while (pending.count > 0 && asked < most_items) {
    const CapBlock& block = tree.blocks()[pending.pop()];
    std::size_t likeliest = pending.count;
    double deepest = -HUGE_VAL;
    for (std::size_t k = 0; k < block.nodes; ++k) {
      const double depth = depth_of(block, k);
      if (!(depth >= 0.0)) continue;
      for (std::uint32_t item = block.first[k]; item < block.first[k] + block.items[k]; ++item) {
        ++asked;
        if (found(item)) return true;
      }
      if (block.leaf(k)) continue;
      if (depth > deepest) likeliest = pending.count;
      deepest = std::max(deepest, depth);
      pending.push(block.first[k]);
    }
    if (likeliest < pending.count) std::swap(pending.blocks[likeliest], pending.blocks[pending.count - 1]);
  }
  return false;
}

}  // namespace impinge
