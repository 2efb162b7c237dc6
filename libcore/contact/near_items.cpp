// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/near_items.hpp"

#include <cmath>

#include "contact/gap_bounds.hpp"
#include "contact/pending_nodes.hpp"

namespace impinge {

void visit_near(const PosedTree& posed, double gap, const ItemVisitor& visit) {
  const auto& blocks = posed.tree.blocks();
  if (blocks.empty()) return;
  PendingNodes pending;
  const auto test = [&](std::uint32_t block) {
    const float enough = std::nextafter(static_cast<float>(gap), HUGE_VALF);
    pending.push_open(0, block, gap_bounds(blocks[block], posed.move, posed.limits, {enough}));
  };
  test(0);
  while (!pending.empty()) {
    const CapNode next = pending.pop().node;
    const CapBlock& block = blocks[next.block];
    const std::uint32_t first = block.first[next.lane];
    if (!block.leaf(next.lane)) {
      test(first);
      continue;
    }
    for (std::uint32_t item = first; item < first + block.items[next.lane]; ++item) {
      gap = visit(item);
      if (gap == -HUGE_VAL) return;
    }
  }
}

}  // namespace impinge
