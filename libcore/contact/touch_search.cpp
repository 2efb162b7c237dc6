// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/touch_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace impinge {
namespace {

// The nodes that a search still has to open. Among the nodes found last, the one where a touch is likeliest
// is opened first.
class PendingNodes {
 public:
  struct Pending {
    std::uint32_t scan;  // 0 for the ball's items, 1 for the socket's
    CapNode node;        // of its tree
  };

  bool empty() const { return count_ == 0; }
  Pending pop() { return nodes_[--count_]; }

  // Adds the open nodes of a block, the likeliest one last.
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
  std::array<Pending, 2 * CapTree::kMostPending> nodes_;
  std::size_t count_ = 0;
};

}  // namespace

// The root that is pushed last is opened first; then the first scan's caps come before the second's.
std::optional<ScannedItem> touching_item(const PosedTrees& posed,
                                         const std::function<bool(const ScannedItem&)>& touches) {
  PendingNodes pending;
  const auto test = [&](std::uint32_t scan, std::uint32_t block) {
    const PosedTree& of = posed[scan];
    pending.push_open(scan, block, gap_bounds(of.tree.blocks()[block], of.move, of.limits, 0.0F));
  };
  for (std::size_t scan = posed.size(); scan-- > 0;)
    if (!posed[scan].tree.blocks().empty()) test(static_cast<std::uint32_t>(scan), 0);
  while (!pending.empty()) {
    const auto [scan, node] = pending.pop();
    const CapBlock& block = posed[scan].tree.blocks()[node.block];
    const std::uint32_t first = block.first[node.lane];
    if (!block.leaf(node.lane)) test(scan, first);
    for (std::uint32_t item = first; item < first + block.items[node.lane]; ++item)
      if (touches({scan, item})) return ScannedItem{scan, item};
  }
  return std::nullopt;
}

}  // namespace impinge
