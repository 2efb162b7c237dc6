// SPDX-License-Identifier: GPL-3.0-or-later
// Does an item of either scan, a vertex or a face, touch the other surface? Whole caps of items are decided
// at once; the items left over are tested one by one by the caller's function. The answer is that of testing
// all items.
//
// The function must agree with the limits: its radii are those of the mesh, see contact/cap_limits.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "contact/gap_bounds.hpp"

namespace impinge {

/// A scan in a pose.
struct PosedTree {
  const CapTree& tree;      // of the items that are moved
  const CapLimits& limits;  // of the other surface
  CapMove move;             // of the items
};
/// Both scans: of the ball's items and of the socket's.
using PosedTrees = std::array<PosedTree, 2>;

/// An item of one of the scans.
struct ScannedItem {
  std::size_t scan;    // 0 of the ball, 1 of the socket
  std::uint32_t item;  // place in the order of its tree
};

/// An item of either scan that touches, if one does. touches(item) says whether it has a gap of 0
/// or less.
std::optional<ScannedItem> touching_item(const PosedTrees& posed,
                                         const std::function<bool(const ScannedItem&)>& touches);

}  // namespace impinge
