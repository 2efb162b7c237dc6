// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/certified_table.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "gap/simd/open_cells.hpp"
#include "sphere/stored_table.hpp"
#include "table/exact_raster.hpp"
#include "table/table_bound.hpp"

namespace impinge {
namespace {

constexpr double kUnit = 0x1p-24;
constexpr double kTightness = 1.25;  // of the proven bound, over the largest error that was met
constexpr std::size_t kHalvings = 100000;
constexpr double kRoundUp = 1.0 + 0x1p-20;  // the comparison itself takes 4 u of it

using Codes = PackedTable<CubeGnomonic, std::uint16_t>;

bool answers(const Codes& table, std::size_t entry) {
  return table.none.empty() || (table.none[entry / 32] >> (entry % 32) & 1U) == 0U;
}

// That a cell of the scheme begins at.
std::size_t first_entry(std::size_t cell, std::size_t divisions) {
  const std::size_t row = cell / divisions;  // over all faces
  return (row + row / divisions) * (divisions + 1) + cell % divisions;
}

// What counts of the cells that answer, as they are stored.
struct StoredCells {
  double largest = 0.0;   // radius of a corner, mm
  double steepest = 1.0;  // largest number of a cell over its least
};

StoredCells stored_cells(const Codes& table, const Uint16InverseDepthTable<CubeGnomonic>& stored) {
  StoredCells found;
  for (std::size_t cell = 0; cell < stored.scheme().cells(); ++cell) {
    const std::size_t e = first_entry(cell, table.divisions);
    if (!answers(table, e)) continue;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const std::size_t corner : {e, e + 1, e + table.stride, e + table.stride + 1}) {
      const double number = table.smallest + table.step * table.values[corner];
      least = std::min(least, number);
      most = std::max(most, number);
      found.largest = std::max(found.largest, stored.radius_of(corner));
    }
    found.steepest = std::max(found.steepest, most / least);
  }
  return found;
}

// Is a cell without an answer next to this one, on its face of the cube?
bool beside_none(const Codes& table, std::size_t entry) {
  for (const std::size_t row : {entry - table.stride, entry, entry + table.stride})
    for (const std::size_t one : {row - 1, row, row + 1})
      if (one < table.values.size() && !answers(table, one)) return true;  // before the first: wraps
  return false;
}

// Cells that the table or the mesh calls open, and those that answer beside one that does not: a place may be
// rounded from that one into it, and of directions without an answer the bound says nothing.
std::vector<std::uint32_t> open_bits(const TriangleMesh& mesh, const InverseDepthTable<CubeGnomonic>& depths,
                                     const Codes& table) {
  std::vector<bool> open = open_cells(mesh, float_grid(table.divisions));
  for (std::size_t cell = 0; cell < depths.scheme().cells(); ++cell) {
    const std::size_t e = first_entry(cell, table.divisions);
    if (depths.rim_cells().contains(cell) || (answers(table, e) && beside_none(table, e))) open[e] = true;
  }
  std::vector<std::uint32_t> bits(open.size() / 32 + 1);
  for (std::size_t e = 0; e < open.size(); ++e) bits[e / 32] |= (open[e] ? 1U : 0U) << (e % 32);
  return bits;
}

}  // namespace

CertifiedTable certified_table(const TriangleMesh& mesh, Layer layer, std::size_t divisions) {
  const auto scheme = CubeGnomonic::with_precision(90.0 / static_cast<double>(divisions));
  const auto radii = fill_exact(mesh, scheme, layer);
  const InverseDepthTable<CubeGnomonic> depths(radii);
  const Uint16InverseDepthTable<CubeGnomonic> stored(radii);
  auto table = packed_table<std::uint16_t>(radii);
  const StoredCells cells = stored_cells(table, stored);
  const double range = table.smallest > 0.0 ? 1.0 + table.step / table.smallest * 65535.0 : 1.0;
  const double share =
      kUnit * (46.0 + 5.0 * range + 13.0 * static_cast<double>(divisions) * (cells.steepest - 1.0));
  const TableBound proven = table_bound(mesh, depths, layer, {kTightness, kHalvings});
  const double off = proven.bound_mm + stored.storage_bound();
  const double bound = share < 1.0 ? off + share / (1.0 - share) * (cells.largest + off)
                                   : std::numeric_limits<double>::infinity();
  auto open = open_bits(mesh, depths, table);
  return {std::move(table), std::move(open), kRoundUp * bound, exact_cells(mesh, layer)};
}

}  // namespace impinge
