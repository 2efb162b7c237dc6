// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes that a search still has to open.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "contact/gap_bounds.hpp"

namespace impinge {

/// A node of one of the two scans.
struct PendingNode {
  std::uint32_t scan;  // 0 of the ball's vertices, 1 of the socket's
  CapNode node;        // of its tree
};

/// Of those found last the one where a touch is likeliest is opened first.
class PendingNodes {
 public:
  bool empty() const { return count_ == 0; }      // nothing is left to be opened
  PendingNode pop() { return nodes_[--count_]; }  // the last one, which is taken out

  /// Takes in the open nodes of a block, the likeliest of them as the last.
  void push_open(std::uint32_t scan, std::uint32_t block, const GapBounds& bounds) {
    const std::size_t first = count_;
    std::size_t likeliest = first;
    float least = HUGE_VALF;
    for (std::uint32_t open = bounds.open; open != 0; open &= open - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(open));
      nodes_[count_] = {scan, {block, lane}};
      likeliest = bounds.likely[lane] < least ? count_ : likeliest;
      least = std::min(least, bounds.likely[lane]);
      ++count_;
    }
    if (count_ > first) std::swap(nodes_[likeliest], nodes_[count_ - 1]);
  }

 private:
  std::array<PendingNode, 2 * CapTree::kMostPending> nodes_;
  std::size_t count_ = 0;
};

}  // namespace impinge
