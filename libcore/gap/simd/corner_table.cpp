// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/corner_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace impinge {
namespace {

using FloatRows = PackedTable<CubeGnomonic, float>;

bool has_answer(const FloatRows& table, std::size_t entry) {
  return table.none.empty() || (table.none[entry / 32] >> (entry % 32) & 1U) == 0U;
}

// Calls visit(entry) for each that a cell begins at.
template <class Visit>
void for_each_cell(std::size_t divisions, const Visit& visit) {
  const std::size_t side = divisions + 1;
  for (std::size_t face = 0; face < 6; ++face)
    for (std::size_t row = 0; row < divisions; ++row)
      for (std::size_t column = 0; column < divisions; ++column) visit((face * side + row) * side + column);
}

// Of the corners of the cells that answer.
struct Range {
  float least = std::numeric_limits<float>::infinity();
  float most = 0.0F;
};

Range range_of(const FloatRows& table) {
  Range range;
  for_each_cell(table.divisions, [&](std::size_t entry) {
    if (!has_answer(table, entry)) return;
    for (const std::size_t corner : {entry, entry + 1, entry + table.stride, entry + table.stride + 1}) {
      range.least = std::min(range.least, table.values[corner]);
      range.most = std::max(range.most, table.values[corner]);
    }
  });
  return range.most > 0.0F ? range : Range{1.0F, 1.0F};  // where no cell answers
}

}  // namespace

CornerTable corner_table(const FloatRows& table) {
  const Range range = range_of(table);
  CornerTable corners;
  corners.divisions = table.divisions;
  corners.smallest = range.least;
  corners.step = (range.most - range.least) / static_cast<float>(CornerTable::kMostCode);
  corners.words.reserve(table.values.size());
  const double scale = corners.step > 0.0F ? 1.0 / static_cast<double>(corners.step) : 0.0;
  const auto code = [&](float number) {
    const double steps = scale * (static_cast<double>(number) - static_cast<double>(corners.smallest));
    return static_cast<std::uint32_t>(
        std::clamp(std::round(steps), 0.0, static_cast<double>(CornerTable::kMostCode)));
  };
  const std::size_t face = table.stride * table.stride;
  for (std::size_t e = 0; e < table.values.size(); ++e) {
    const bool last_row = e % face >= face - table.stride;
    const std::uint32_t below = last_row ? 0U : code(table.values[e + table.stride]);
    corners.words.push_back(code(table.values[e]) | below << 16U);
  }
  for_each_cell(table.divisions, [&](std::size_t entry) {
    if (!has_answer(table, entry)) corners.words[entry] |= CornerTable::kNone;
  });
  return corners;
}

}  // namespace impinge
