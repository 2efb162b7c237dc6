// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/certified_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "kernels/open_cells.hpp"
#include "sampling/exact_raster.hpp"
#include "sampling/table_bound.hpp"
#include "sphere/quantised_table.hpp"

namespace impinge {
namespace {

constexpr double kUnit = 0x1p-24;
constexpr double kTightness = 1.25;  // of the proven bound, over the largest error that was met
constexpr std::size_t kHalvings = 100000;
constexpr double kRoundUp = 1.0 + 0x1p-20;  // for the roundings of the comparison itself

struct RadiiOfCells {
  double largest = 0.0;       // mm
  double largest_step = 0.0;  // between the corners of a cell, mm
};

RadiiOfCells radii_of_cells(const RadialTable<CubeGnomonic>& table) {
  const std::size_t lines = table.scheme().divisions() + 1;
  const auto radii = table.radii();
  RadiiOfCells found;
  for (std::size_t e = 0; e + lines + 1 < radii.size(); ++e) {
    const std::array<double, 4> corner{radii[e], radii[e + 1], radii[e + lines], radii[e + lines + 1]};
    const bool last = e % lines == lines - 1 || e / lines % lines == lines - 1;
    if (last || std::isnan(corner[0] + corner[1] + corner[2] + corner[3])) continue;
    const auto [low, high] = std::ranges::minmax(corner);
    found.largest = std::max(found.largest, high);
    found.largest_step = std::max(found.largest_step, high - low);
  }
  return found;
}

// Cells that either the table or the mesh calls open.
std::vector<std::uint32_t> open_bits(const TriangleMesh& mesh, const RadialTable<CubeGnomonic>& table) {
  const std::size_t n = table.scheme().divisions();
  std::vector<bool> open = open_cells(mesh, float_grid(n));
  for (std::size_t cell = 0; cell < table.scheme().cells(); ++cell) {
    const std::size_t row = cell / n;  // over all faces
    if (table.is_rim_cell(cell)) open[(row + row / n) * (n + 1) + cell % n] = true;
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
  const RadiiOfCells cells = radii_of_cells(radii);
  auto table = lane_table<std::uint16_t>(depths);
  const double range = table.smallest > 0.0 ? 1.0 + table.step / table.smallest * 65535.0 : 1.0;
  const double rounding = kUnit * ((46.0 + 5.0 * range) * cells.largest +
                                   13.0 * static_cast<double>(divisions) * cells.largest_step);
  const TableBound proven = table_bound(mesh, depths, layer, {kTightness, kHalvings});
  const double storage = Uint16InverseDepthTable<CubeGnomonic>(depths).storage_bound();
  return {std::move(table), open_bits(mesh, radii), kRoundUp * (proven.bound_mm + storage + rounding),
          exact_cells(mesh, layer)};
}

}  // namespace impinge
