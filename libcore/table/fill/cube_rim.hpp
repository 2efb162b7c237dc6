// SPDX-License-Identifier: GPL-3.0-or-later
// The rim of a surface, marked in the table that a kernel reads.
#pragma once

#include <vector>

#include "mesh/jump_edges.hpp"
#include "table/layer.hpp"
#include "table/packed_table.hpp"

namespace impinge {

/// A surface and its table, whose cells without four corners are marked already.
template <PackedValue Value>
struct RimTask {
  const TriangleMesh& mesh;                 // centre frame
  const CubeGnomonic& scheme;               // of the table
  Layer layer;                              // which crossing the table holds
  PackedTable<CubeGnomonic, Value>& table;  // whose mask gets the rim
};

/// Along the jump edges of the mesh, as mask_rim_along() of table/rim.hpp. A stored number counts as near
/// to a jump as its rounding allows, so every cell that numbers in double would mark is marked.
template <PackedValue Value>
void mark_rim(const RimTask<Value>& task, const std::vector<JumpEdge>& edges);

}  // namespace impinge
