// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/packed_table.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include "mesh/lengths.hpp"
#include "sphere/stored_values.hpp"

namespace impinge {
namespace {

constexpr double kHarmless = 1.0;  // stands for a missing number

// Rows of `stride` entries, NaN where there is no surface; rows_of_cells says whose rows begin cells.
struct Rows {
  std::vector<double> numbers;
  std::size_t stride = 0;
};

template <class Table>
void store(const Rows& rows, Table& table) {
  using Value = typename decltype(table.values)::value_type;
  table.stride = rows.stride;
  table.values.reserve(rows.numbers.size());
  if constexpr (std::same_as<Value, std::uint16_t>) {
    const Uint16Values coded(rows.numbers);
    table.smallest = coded.smallest();
    table.step = coded.step();
    for (std::size_t e = 0; e < coded.size(); ++e)
      table.values.push_back(std::isnan(rows.numbers[e]) ? std::uint16_t{0} : coded.code(e));
  } else {
    if constexpr (std::same_as<Value, float>) static_cast<void>(FloatValues(rows.numbers));  // for its checks
    for (const double number : rows.numbers)
      table.values.push_back(static_cast<Value>(std::isnan(number) ? kHarmless : number));
  }
}

// Does the cell that begins at entry e lack a corner? So does the last entry of a row, which begins no cell.
bool lacks_corner(const Rows& rows, std::size_t e) {
  if (e + rows.stride + 1 >= rows.numbers.size()) return true;
  return std::isnan(rows.numbers[e]) || std::isnan(rows.numbers[e + 1]) ||
         std::isnan(rows.numbers[e + rows.stride]) || std::isnan(rows.numbers[e + rows.stride + 1]);
}

// The cell of the scheme, and the entry that it begins at.
struct CellStart {
  std::size_t cell;
  std::size_t entry;
};

template <class Table, class StartOf>
void mask(const Rows& rows, const CellMask& rim, std::size_t cells, StartOf&& start_of, Table& table) {
  using Word = typename Table::Word;
  constexpr std::size_t kBits = 8 * sizeof(Word);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const std::size_t entry = start_of(cell);
    if (!rim.contains(cell) && !lacks_corner(rows, entry)) continue;
    if (table.none.empty()) table.none.resize(rows.numbers.size() / kBits + 1, Word{0});
    table.none[entry / kBits] |= Word{1} << (entry % kBits);
  }
}

// A kernel in float squares what it compares with these radii.
void require_float_radii(std::span<const double> radii) {
  for (const double r : radii) {
    if (std::isnan(r) || (r >= kLeastFloatLength && r <= kMostFloatLength)) continue;
    char text[160];
    std::snprintf(
        text, sizeof text,
        "a kernel in float takes radii from %.2g to %.2g mm, not %.3g: scale the mesh to millimetres",
        kLeastFloatLength, kMostFloatLength, r);
    throw std::invalid_argument(text);
  }
}

}  // namespace

void require_packed_entries(std::size_t entries) {
  if (entries <= kMostPackedEntries) return;
  throw std::invalid_argument("a kernel reads tables of up to " + std::to_string(kMostPackedEntries) +
                              " entries, not of " + std::to_string(entries) + ": choose a coarser precision");
}

template <PackedValue Value>
PackedTable<CubeGnomonic, Value> packed_table(const RadialTable<CubeGnomonic>& filled) {
  const InverseDepthTable<CubeGnomonic> table(filled);
  require_packed_entries(table.scheme().size());
  const std::size_t n = table.scheme().divisions();
  const auto& numbers = table.values();
  const Rows rows{{numbers.begin(), numbers.end()}, n + 1};
  PackedTable<CubeGnomonic, Value> lanes;
  lanes.divisions = n;
  store(rows, lanes);
  const auto start_of = [n](std::size_t cell) {
    const std::size_t row = cell / n;  // row of cells, counted over all faces
    return (row + row / n) * (n + 1) + cell % n;
  };
  mask(rows, table.rim_cells(), table.scheme().cells(), start_of, lanes);
  return lanes;
}

template <PackedValue Value>
PackedTable<Rsid, Value> packed_table(const RadialTable<Rsid>& table) {
  if constexpr (!PackedTable<Rsid, Value>::kDouble) require_float_radii(table.radii());
  const std::size_t columns = table.scheme().columns();
  require_packed_entries(table.scheme().size() + table.scheme().rows());
  Rows rows{{}, columns + 1};
  const auto radii = table.radii();
  for (std::size_t first = 0; first < radii.size(); first += columns) {
    const auto row = radii.subspan(first, columns);
    rows.numbers.insert(rows.numbers.end(), row.begin(), row.end());
    rows.numbers.push_back(row.front());
  }
  PackedTable<Rsid, Value> lanes;
  lanes.divisions = table.scheme().rows() - 1;
  store(rows, lanes);
  const auto start_of = [columns](std::size_t cell) {
    return cell / columns * (columns + 1) + cell % columns;
  };
  mask(rows, table.rim_cells(), table.scheme().cells(), start_of, lanes);
  return lanes;
}

template PackedTable<CubeGnomonic, float> packed_table(const RadialTable<CubeGnomonic>&);
template PackedTable<CubeGnomonic, std::uint16_t> packed_table(const RadialTable<CubeGnomonic>&);
template PackedTable<Rsid, double> packed_table(const RadialTable<Rsid>&);
template PackedTable<Rsid, float> packed_table(const RadialTable<Rsid>&);
template PackedTable<Rsid, std::uint16_t> packed_table(const RadialTable<Rsid>&);

}  // namespace impinge
