// SPDX-License-Identifier: GPL-3.0-or-later
// Trees of caps, node by node.
#pragma once

#include <cmath>
#include <vector>

#include "contact/cap_tree.hpp"
#include "mesh/bodies.hpp"

namespace impinge::test {

// A ball of about 22 mm with bumps.
inline TriangleMesh bumpy(std::size_t faces, double height = 1.0) {
  return radial_body(faces, [height](const Vec3& u) {
    return 22.0 + height * std::sin(9.0 * u.x()) * std::cos(7.0 * u.y() + 1.0);
  });
}

// Items of the leaves below a node.
inline std::vector<std::uint32_t> items_below(const CapTree& tree, const CapNode& node) {
  const CapBlock& block = tree.blocks()[node.block];
  std::vector<std::uint32_t> found;
  for (std::uint32_t k = 0; k < block.items[node.lane]; ++k) found.push_back(block.first[node.lane] + k);
  if (block.leaf(node.lane)) return found;
  for (std::uint32_t lane = 0; lane < tree.blocks()[block.first[node.lane]].nodes; ++lane) {
    const auto below = items_below(tree, {block.first[node.lane], lane});
    found.insert(found.end(), below.begin(), below.end());
  }
  return found;
}

// Calls visit(node, block, lane) for all nodes.
template <class Visit>
void for_each_node(const CapTree& tree, Visit&& visit) {
  for (std::uint32_t at = 0; at < tree.blocks().size(); ++at) {
    for (std::uint32_t lane = 0; lane < tree.blocks()[at].nodes; ++lane)
      visit(CapNode{at, lane}, tree.blocks()[at], static_cast<std::size_t>(lane));
  }
}

}  // namespace impinge::test
