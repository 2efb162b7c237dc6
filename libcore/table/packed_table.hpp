// SPDX-License-Identifier: GPL-3.0-or-later
// A filled table in the form that a kernel reads: rows of equal length in which the entries of a cell are
// neighbours. Numbers are in double, float or 16 bits, as in sphere/stored_values.hpp.
//
// `rsid` stores radii (the `smooth` interpolant), `cube_gnomonic` inverse depths (`mesh_exact`). Entry (i, j)
// stands at row i, column j; a cell is named by its first entry. `rsid` gets its first column once more after
// the last, so that no cell crosses the seam. An entry without surface holds a harmless number, as zeros
// would lead to denormals, which are a hundred times slower; its cells answer "none", like rim cells. The
// scalar look-up also answers on a grid line with surface at both ends if the cell beside has none.
//
// `usid` stores radii in the order of the helix, and four more entries at the end, so that a gather may reach
// beyond the last. Its places are worked out in double whatever is stored. Entries without surface are NaN,
// or the code for it; cells have the numbers of sphere/spiral.hpp.
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

/// The types in which the numbers of a table may be stored.
template <class Value>
concept PackedValue =
    std::same_as<Value, double> || std::same_as<Value, float> || std::same_as<Value, std::uint16_t>;

/// Plain data, made by the functions below. `Value` is the type that is stored.
template <SamplingScheme S, PackedValue Value>
struct PackedTable {
  /// Does the kernel work in double? Else in float.
  static constexpr bool kDouble = std::same_as<Value, double> || std::same_as<S, Usid>;
  using Real = std::conditional_t<kDouble, double, float>;                 // the kernel works in this
  using Word = std::conditional_t<kDouble, std::uint64_t, std::uint32_t>;  // of the mask, as wide as Real

  std::size_t divisions = 0;  // cells along a side of the cube; rows of cells of the grid; turns of the helix
  std::size_t stride = 0;     // entries of a row; 0 for the helix
  TableMemory<Value> values;  // entry e stands for smallest + step * values[e]
  double smallest = 0.0;      // mm or 1 / mm
  double step = 1.0;          // the same unit
  std::vector<Word> none;     // a bit for each entry (helix: cell), 1 for no answer; empty if all answer

  /// Bytes of numbers and mask.
  std::size_t bytes() const { return values.size() * sizeof(Value) + none.size() * sizeof(Word); }
};

/// The most entries of a table: their offsets in bytes have to fit into 32 bits.
inline constexpr std::size_t kMostPackedEntries = std::size_t{1} << 28;

/// Throws std::invalid_argument for more entries than kMostPackedEntries.
void require_packed_entries(std::size_t entries);

/// Packs a filled table. Throws std::invalid_argument for more entries than kMostPackedEntries and for
/// numbers that a float cannot hold. A kernel of `rsid` in float squares lengths; for it radii must be within
/// the range of floats in mesh/lengths.hpp.
template <PackedValue Value>
PackedTable<CubeGnomonic, Value> packed_table(const RadialTable<CubeGnomonic>& filled);
template <PackedValue Value>
PackedTable<Rsid, Value> packed_table(const RadialTable<Rsid>& filled);
template <PackedValue Value>
PackedTable<Usid, Value> packed_table(const RadialTable<Usid>& filled);

}  // namespace impinge
