// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of a tree of caps as they are made, from the leaves to the root.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "contact/cap_tree.hpp"
#include "contact/cube_cell.hpp"

namespace impinge {

/// What a node of a tree is made of, in double.
struct CapSummary {
  DirectionCap cap;     // holds the directions of all parts
  RadiusRange range;    // holds their radii, mm
  double widest = 0.0;  // cap of a part, radians
};

/// The caps and ranges of several in one. The axis is as exact as a float.
CapSummary summary_of(std::span<const CapSummary> parts);

/// Narrows the cap to what parts whose axes are in the cell can have.
void keep_to(const CubeCell& cell, CapSummary& summary);

/// A node, before it is written into its block.
struct SummarisedNode {
  CapSummary summary;       // of its parts
  std::uint32_t first = 0;  // see CapBlock
  std::uint32_t items = 0;
};

/// Writes a node into a lane, rounded outwards.
void write(const SummarisedNode& node, std::size_t lane, CapBlock& block);

}  // namespace impinge
