// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Certified mode: the fast table where its proven bound decides, the exact cells where it does not.
///
/// It tells on which side of a threshold the gap of every vertex is. At the moved vertex x the gap of the
/// table in 16 bits is off from what the exact cells answer by at most
///   o + (R + o) e / (1 - e) + 28 u |x|,   o = bound + storage,  e = u (46 + 5 Q + 13 n (C - 1))
/// bound the largest of cell_bounds.hpp over the cells that are decided, storage that of
/// sphere/stored_table.hpp, and the rest the roundings of both kernels (gap_kernels.hpp, exact_cells.hpp;
/// |gap| <= r + |x|): R is the largest radius of the table, so that no radius of the mesh or of what is
/// stored is above R + o in a decided cell, Q its largest number over the least, C the largest of these in
/// one decided cell, n the cells of a quarter turn. A vertex whose gap is nearer to the threshold is
/// undecided and goes to the exact cells. So does every vertex in an open cell: where the surface may end or
/// jump (open_cells.hpp), beside a cell without an answer, of which the bound says nothing, and in the cells
/// with the largest bounds, without which the bound of all others is so small that fewer vertices are
/// undecided. So every vertex is on the side that the exact cells say; a decided vertex keeps the gap of the
/// table. Exact cells answer as the mesh but for the roundings in exact_cells.hpp, at the vertex as moved in
/// float.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gap/simd/exact_cells.hpp"
#include "table/packed_table.hpp"

namespace impinge {

/// Plain data; make it with certified_table().
struct CertifiedTable {
  PackedTable<CubeGnomonic, std::uint16_t> table;  // that is asked first
  std::vector<std::uint32_t> open;                 // one bit an entry: its cell decides nothing
  double bound_mm = 0.0;                           // of a gap, but for the part that grows with |x|
  ExactCells exact;                                // that undecided vertices go to

  /// Of all of it, without the mesh.
  std::size_t bytes() const { return table.bytes() + open.size() * sizeof(std::uint32_t) + exact.bytes(); }
};

/// mesh in the centre frame; it must outlive the table. `divisions` cells along an edge of the cube.
CertifiedTable certified_table(const TriangleMesh& mesh, Layer layer, std::size_t divisions);
CertifiedTable certified_table(TriangleMesh&&, Layer, std::size_t) = delete;

/// What is asked and answered; its memory is used again by the next scan.
struct CertifiedGaps {
  float threshold = 0.0F;  // mm
  std::vector<float> gap;  // mm, certainly on the right side of the threshold; NaN where there is none
  std::vector<std::uint32_t> undecided;  // vertices that went to the exact cells, in rising order
  PackedVertices<float> asked;           // those vertices
  std::vector<float> answered;           // and their gaps
};
/// Gaps of every vertex of `scanned` to the surface of the table, by the threshold that is set in `found`.
void scan_gaps(const CertifiedTable& table, const PackedVertices<float>& vertices, const Pose& pose,
               Surface scanned, CertifiedGaps& found);

}  // namespace impinge
