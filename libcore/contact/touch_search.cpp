// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/touch_search.hpp"

#include "contact/gap_bounds.hpp"
#include "contact/pending_nodes.hpp"

namespace impinge {
namespace {

std::optional<ScannedItem> ask_leaf(std::size_t scan, const ItemRun& run, const ItemQuestion& touches) {
  for (std::uint32_t item = run.first; item < run.first + run.count; ++item) {
    if (touches({scan, item})) return ScannedItem{scan, item};
  }
  return std::nullopt;
}

}  // namespace

// Both roots are looked at first, at about the same time; then the ball's caps before the socket's.
std::optional<ScannedItem> touching_item(const PosedTrees& posed, const ItemQuestion& touches) {
  PendingNodes pending;
  const auto test = [&](std::uint32_t scan, std::uint32_t block) {
    const PosedTree& of = posed[scan];
    pending.push_open(scan, block, gap_bounds(of.tree.blocks()[block], of.move, of.limits, {}));
  };
  for (const std::uint32_t scan : {1U, 0U}) {
    if (!posed[scan].tree.blocks().empty()) test(scan, 0);
  }
  while (!pending.empty()) {
    const PendingNode next = pending.pop();
    const CapBlock& block = posed[next.scan].tree.blocks()[next.node.block];
    const std::uint32_t first = block.first[next.node.lane];
    if (!block.leaf(next.node.lane)) {
      test(next.scan, first);
    } else if (const auto item = ask_leaf(next.scan, {first, block.items[next.node.lane]}, touches)) {
      return item;
    }
  }
  return std::nullopt;
}

}  // namespace impinge
