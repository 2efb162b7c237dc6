// SPDX-License-Identifier: GPL-3.0-or-later
#include "culling/touch_search.hpp"

#include "culling/gap_bounds.hpp"
#include "culling/pending_nodes.hpp"

namespace impinge {
namespace {

std::optional<ScannedVertex> ask_leaf(const CulledScan& scan, const CapMove& move,
                                      const VertexQuestion& touches, const ItemRun& run) {
  for (std::uint32_t item = run.first; item < run.first + run.count; ++item) {
    const ScannedVertex at{scan.scanned(), scan.vertex(item)};
    if (touches(at, move.place(scan.position(item)))) return at;
  }
  return std::nullopt;
}

}  // namespace

// Both roots are looked at first, at about the same time; then the ball's caps before the socket's.
std::optional<ScannedVertex> touching_vertex(const PosedScans& posed, const VertexQuestion& touches) {
  PendingNodes pending;
  const auto test = [&](std::uint32_t scan, std::uint32_t block) {
    const CulledScan& of = posed.scans[scan];
    pending.push_open(scan, block, gap_bounds(of.tree().blocks()[block], posed.moves[scan], of.limits(), {}));
  };
  for (const std::uint32_t scan : {1U, 0U}) {
    if (!posed.scans[scan].tree().blocks().empty()) test(scan, 0);
  }
  while (!pending.empty()) {
    const PendingNode next = pending.pop();
    const CulledScan& scan = posed.scans[next.scan];
    const CapBlock& block = scan.tree().blocks()[next.node.block];
    const std::uint32_t first = block.first[next.node.lane];
    if (!block.leaf(next.node.lane)) {
      test(next.scan, first);
    } else if (const auto vertex =
                   ask_leaf(scan, posed.moves[next.scan], touches, {first, block.items[next.node.lane]})) {
      return vertex;
    }
  }
  return std::nullopt;
}

}  // namespace impinge
