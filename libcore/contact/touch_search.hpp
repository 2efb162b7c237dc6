// SPDX-License-Identifier: GPL-3.0-or-later
// Searches both scans for an item, a vertex or a face, that touches the other surface. Whole caps of items
// are decided at once; the caller's function tests the items that are left, one by one. The answer is the
// same as from testing all items, if the function uses the radii of the mesh, as the limits do
// (contact/cap_limits.hpp).
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
  const CapTree& tree;      // of the moved items
  const CapLimits& limits;  // of the other surface
  CapMove move;             // moves the items
};
/// Both scans: of the ball's items, then of the socket's.
using PosedTrees = std::array<PosedTree, 2>;

/// An item of one of the scans.
struct ScannedItem {
  std::size_t scan;    // 0 for the ball, 1 for the socket
  std::uint32_t item;  // place in the order of its tree
};

/// An item of either scan that touches, or std::nullopt if none does. touches(item) says whether an item has
/// a gap of 0 or less.
std::optional<ScannedItem> touching_item(const PosedTrees& posed,
                                         const std::function<bool(const ScannedItem&)>& touches);

}  // namespace impinge
