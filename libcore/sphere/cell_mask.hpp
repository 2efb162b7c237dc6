// SPDX-License-Identifier: GPL-3.0-or-later
// One bit for each cell of a scheme.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace impinge {

/// Takes no memory until a cell is marked.
class CellMask {
 public:
  /// For a scheme of so many cells, none of them marked.
  explicit CellMask(std::size_t cells) : cells_(cells) {}

  bool empty() const { return bits_.empty(); }  // no cell is marked
  /// Is this cell marked?
  bool contains(std::size_t cell) const {
    return !bits_.empty() && (bits_[cell / 64] >> (cell % 64) & 1U) != 0U;
  }

  /// Memory of the bits: 0, or one bit a cell.
  std::size_t bytes() const { return bits_.size() * sizeof(std::uint64_t); }

  /// Marks a cell below the number of cells.
  void mark(std::size_t cell) {
    if (bits_.empty()) bits_.resize((cells_ + 63) / 64, 0U);
    bits_[cell / 64] |= std::uint64_t{1} << (cell % 64);
  }

 private:
  std::size_t cells_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace impinge
