// SPDX-License-Identifier: GPL-3.0-or-later
#include <span>

#include "sphere/stored_values.hpp"
#include "table/packed_table.hpp"

namespace impinge {
namespace {

constexpr std::size_t kBehind = 4;  // entries that a gather may reach beyond the last

std::vector<std::uint64_t> rim_bits(const CellMask& rim, std::size_t cells) {
  std::vector<std::uint64_t> bits;
  if (rim.empty()) return bits;
  bits.resize(cells / 64 + 1);
  for (std::size_t cell = 0; cell < cells; ++cell)
    bits[cell / 64] |= std::uint64_t{rim.contains(cell) ? 1U : 0U} << (cell % 64);
  return bits;
}

}  // namespace

template <PackedValue Value>
PackedTable<Usid, Value> packed_table(const RadialTable<Usid>& table) {
  require_packed_entries(table.scheme().size());
  const std::span<const double> radii = table.radii();
  PackedTable<Usid, Value> lanes;
  lanes.divisions = table.scheme().helix_turns();
  lanes.values.reserve(radii.size() + kBehind);
  if constexpr (std::same_as<Value, std::uint16_t>) {
    const Uint16Values coded(radii);
    lanes.smallest = coded.smallest();
    lanes.step = coded.step();
    for (std::size_t e = 0; e < coded.size(); ++e) lanes.values.push_back(coded.code(e));
  } else {
    if constexpr (std::same_as<Value, float>) static_cast<void>(FloatValues(radii));  // for its checks
    for (const double radius : radii) lanes.values.push_back(static_cast<Value>(radius));
  }
  lanes.values.resize(radii.size() + kBehind, Value{0});
  lanes.none = rim_bits(table.rim_cells(), table.scheme().cells());
  return lanes;
}

template PackedTable<Usid, double> packed_table(const RadialTable<Usid>&);
template PackedTable<Usid, float> packed_table(const RadialTable<Usid>&);
template PackedTable<Usid, std::uint16_t> packed_table(const RadialTable<Usid>&);

}  // namespace impinge
