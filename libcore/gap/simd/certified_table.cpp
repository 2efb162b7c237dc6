// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/certified_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "gap/simd/cell_bounds.hpp"
#include "gap/simd/open_cells.hpp"
#include "sphere/stored_table.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

constexpr double kUnit = 0x1p-24;
constexpr double kGaps = 10.0;              // mm: gaps are taken to be spread evenly over so much
constexpr int kFinest = -64;                // quarter octaves of a millimetre: 2^-16 mm
constexpr int kCoarsest = 16;               // 16 mm
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

// Is a cell without an answer next to this one, on its face of the cube?
bool beside_none(const Codes& table, std::size_t entry) {
  for (const std::size_t row : {entry - table.stride, entry, entry + table.stride})
    for (const std::size_t one : {row - 1, row, row + 1})
      if (one < table.values.size() && !answers(table, one)) return true;  // before the first: wraps
  return false;
}

// Cells that the table or the mesh calls open, and those that answer beside one that does not: a place may be
// rounded from that one into it, and of directions without an answer the bounds say nothing.
std::vector<bool> open_cells_of(const TriangleMesh& mesh, const InverseDepthTable<CubeGnomonic>& depths,
                                const Codes& table) {
  std::vector<bool> open = open_cells(mesh, float_grid(table.divisions));
  for (std::size_t cell = 0; cell < depths.scheme().cells(); ++cell) {
    const std::size_t e = first_entry(cell, table.divisions);
    if (depths.rim_cells().contains(cell) || (answers(table, e) && beside_none(table, e))) open[e] = true;
  }
  return open;
}

// What holds for all cells that are decided.
struct DecidedCells {
  double bound_mm = 0.0;  // on the error of the table, without what storage adds
  double steepest = 1.0;  // largest number in a cell over its least
};

// Of a cell that is decided.
void include(const Codes& table, std::size_t e, const CellBound& bound, DecidedCells& decided) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const std::size_t corner : {e, e + 1, e + table.stride, e + table.stride + 1}) {
    const double number = table.smallest + table.step * table.values[corner];
    least = std::min(least, number);
    most = std::max(most, number);
  }
  decided.bound_mm = std::max(decided.bound_mm, bound.mm);
  decided.steepest = std::max({decided.steepest, bound.steepest, most / least});
}

// The bound (mm) that leaves the fewest vertices undecided: those in cells above it, which will be open, and
// those whose gap is within it of the threshold.
double best_bound(const std::vector<double>& bounds) {
  std::array<std::size_t, kCoarsest - kFinest + 1> above{};  // bounds by quarter octaves
  for (const double mm : bounds)
    ++above[static_cast<std::size_t>(
        std::clamp(std::ceil(4.0 * std::log2(mm)), kFinest + 0.0, kCoarsest + 0.0) - kFinest)];
  double best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  std::size_t open = bounds.size();
  for (int k = kFinest; k < kCoarsest; ++k) {
    open -= above[static_cast<std::size_t>(k - kFinest)];
    const double bound = std::exp2(0.25 * k);
    const double undecided =
        static_cast<double>(open) / static_cast<double>(bounds.size()) + 2.0 * bound / kGaps;
    if (undecided >= least) continue;
    least = undecided;
    best = bound;
  }
  return best;
}

// Opens the cells whose bound is above the best one.
DecidedCells decide_cells(const Codes& table, const std::vector<CellBound>& bounds, std::vector<bool>& open) {
  std::vector<double> left;
  const auto decides = [&](std::size_t e) { return bounds[e].mm > 0.0 && !open[e] && answers(table, e); };
  for (std::size_t e = 0; e < bounds.size(); ++e)
    if (decides(e)) left.push_back(bounds[e].mm);
  const double best = best_bound(left);
  DecidedCells found;
  for (std::size_t e = 0; e < bounds.size(); ++e) {
    if (!decides(e)) continue;
    if (bounds[e].mm <= best)
      include(table, e, bounds[e], found);
    else
      open[e] = true;
  }
  return found;
}

double largest_radius(const RadialTable<CubeGnomonic>& table) {  // mm
  double largest = 0.0;
  for (const double radius : table.radii()) largest = std::max(largest, std::isnan(radius) ? 0.0 : radius);
  return largest;
}

std::vector<std::uint32_t> bits_of(const std::vector<bool>& open) {
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
  std::vector<bool> open = open_cells_of(mesh, depths, table);
  const DecidedCells cells = decide_cells(table, cell_bounds(mesh, layer, depths), open);
  const double range = table.smallest > 0.0 ? 1.0 + table.step / table.smallest * 65535.0 : 1.0;
  const double share =
      kUnit * (46.0 + 5.0 * range + 13.0 * static_cast<double>(divisions) * (cells.steepest - 1.0));
  const double off = cells.bound_mm + stored.storage_bound();
  const double bound = share < 1.0 ? off + share / (1.0 - share) * (largest_radius(radii) + off)
                                   : std::numeric_limits<double>::infinity();
  return {std::move(table), bits_of(open), kRoundUp * bound, exact_cells(mesh, layer)};
}

}  // namespace impinge
