// SPDX-License-Identifier: GPL-3.0-or-later
// A filled table as a kernel reads it: rows of equal length in which the entries of a cell are neighbours.
//
// Entry (i, j) of S stands at row i, column j. `rsid` gets its first column once more behind the last, so
// that no cell crosses the seam; `cube_gnomonic` has rows like that of its own. A cell is named by its first
// entry. What is stored is radii of `rsid` (the `smooth` interpolant) and inverse depths of `cube_gnomonic`
// (`mesh_exact`), in double, float or 16 bits as in sphere/stored_values.hpp.
//
// `usid` keeps its entries as they follow each other along the helix, four more at the end so that a gather
// may reach beyond the last, and its places are worked out in double whatever is stored. Entries without
// surface are NaN there, or stored_values.hpp's code for it; cells have the numbers of sphere/spiral.hpp.
//
// In the other two schemes an entry without surface holds a harmless number, since zeros would lead to
// denormals, which are a hundred times slower; its cells answer "none", as those of the rim do. The scalar
// look-up agrees except on a grid line with surface at both ends: there it answers even when the cell beside
// has none.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"
#include "sphere/stored_table.hpp"
#include "sphere/table_memory.hpp"

namespace impinge {

/// What the numbers of a table may be stored in.
template <class Value>
concept PackedValue =
    std::same_as<Value, double> || std::same_as<Value, float> || std::same_as<Value, std::uint16_t>;

/// Plain data; make it with the functions below. Value is what is stored.
template <SamplingScheme S, PackedValue Value>
struct PackedTable {
  /// Does a kernel work in double? Else in float.
  static constexpr bool kDouble = std::same_as<Value, double> || std::same_as<S, Usid>;
  using Real = std::conditional_t<kDouble, double, float>;                 // that a kernel works in
  using Word = std::conditional_t<kDouble, std::uint64_t, std::uint32_t>;  // of the mask, as wide as Real

  std::size_t divisions = 0;  // cells along a side of the cube; rows of cells of the grid; turns of the helix
  std::size_t stride = 0;     // entries of a row; 0 of the helix
  TableMemory<Value> values;  // entry e stands for smallest + step * values[e]
  double smallest = 0.0;      // mm or 1 / mm
  double step = 1.0;          // the same unit
  std::vector<Word> none;     // one bit an entry (a cell of the helix): no answer there; empty where all have

  /// Memory of numbers and mask.
  std::size_t bytes() const { return values.size() * sizeof(Value) + none.size() * sizeof(Word); }
};

/// Most entries of a table: their offsets in bytes have to fit into 32 bits.
inline constexpr std::size_t kMostPackedEntries = std::size_t{1} << 28;

/// std::invalid_argument for more than that.
void require_packed_entries(std::size_t entries);

/// Packs a filled table. std::invalid_argument for more entries than kMostPackedEntries and for numbers that
/// a float cannot hold; for a kernel of `rsid` in float, which squares lengths, for radii beyond those of
/// floats in mesh/lengths.hpp.
template <PackedValue Value>
PackedTable<CubeGnomonic, Value> packed_table(const RadialTable<CubeGnomonic>& filled);
template <PackedValue Value>
PackedTable<Rsid, Value> packed_table(const RadialTable<Rsid>& filled);
template <PackedValue Value>
PackedTable<Usid, Value> packed_table(const RadialTable<Usid>& filled);

}  // namespace impinge
