// SPDX-License-Identifier: GPL-3.0-or-later
// The entries of a cube map in square tiles, each of which a core fills in its first cache.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace impinge {

/// Entries of a face of the cube from (first_column, first_row) on. It keeps `columns` x `rows` of them. It
/// also sees the next column and row, where there are any: those entries are corners of its cells too.
struct CubeTile {
  std::size_t face = 0;          // of the cube
  std::size_t first_column = 0;  // of its entries
  std::size_t first_row = 0;     // of its entries
  std::size_t columns = 0;       // that it keeps
  std::size_t rows = 0;          // that it keeps
  std::size_t seen_columns = 0;  // those that it keeps, and one more unless it is the last of the face
  std::size_t seen_rows = 0;
};

/// A part of the grid of a face: columns and rows from the first to the last, both included.
struct GridWindow {
  long first_column = 0;  // may be less than 0
  long last_column = -1;  // may be beyond the grid
  long first_row = 0;
  long last_row = -1;

  bool empty() const { return first_column > last_column || first_row > last_row; }  // holds no entry
};

/// Divides the faces of a cube map into tiles. No tile is empty: a side has more than kMostSeen - 1 entries
/// for each of its tiles but one.
class CubeTiling {
 public:
  /// Entries that a tile sees along a side: a row of them has one bit each in 64.
  static constexpr std::size_t kMostSeen = 64;

  /// Of a cube map with so many cells along an edge.
  explicit CubeTiling(std::size_t divisions)
      : side_(divisions + 1),
        per_side_((side_ + kMostSeen - 2) / (kMostSeen - 1)),
        size_((side_ + per_side_ - 1) / per_side_),
        inverse_size_((std::uint64_t{1} << kShift) / size_ + 1) {}

  std::size_t size() const { return 6 * per_side_ * per_side_; }  // tiles of all six faces

  /// Tile number `tile`, below size().
  CubeTile operator[](std::size_t tile) const {
    const std::size_t row = tile / per_side_;  // of tiles, over all faces
    CubeTile one;
    one.face = row / per_side_;
    one.first_column = tile % per_side_ * size_;
    one.first_row = row % per_side_ * size_;
    one.columns = kept(one.first_column);
    one.rows = kept(one.first_row);
    one.seen_columns = std::min(size_ + 1, side_ - one.first_column);
    one.seen_rows = std::min(size_ + 1, side_ - one.first_row);
    return one;
  }

  /// Calls visit(tile) for those that see an entry of the window, which is on the grid.
  template <class Visit>
  void for_each_seeing(std::size_t face, const GridWindow& window, Visit&& visit) const {
    if (window.empty()) return;
    const std::size_t last_column = keeping(static_cast<std::size_t>(window.last_column));
    const std::size_t last_row = keeping(static_cast<std::size_t>(window.last_row));
    for (std::size_t j = first_seeing(window.first_row); j <= last_row; ++j)
      for (std::size_t i = first_seeing(window.first_column); i <= last_column; ++i)
        visit((face * per_side_ + j) * per_side_ + i);
  }

 private:
  std::size_t kept(std::size_t first) const { return std::min(size_, side_ - first); }
  /// The tile before the one that keeps a line sees its first one.
  std::size_t first_seeing(long line) const {
    return keeping(static_cast<std::size_t>(std::max(line - 1, 0L)));
  }
  /// line / size_ of lines below 2^24: the inverse is too large by less than 2^-40.
  std::size_t keeping(std::size_t line) const {
    return static_cast<std::size_t>(line * inverse_size_ >> kShift);
  }

  std::size_t side_;
  std::size_t per_side_;
  std::size_t size_;
  static constexpr unsigned kShift = 40;
  std::uint64_t inverse_size_;  // 2^kShift / size_, rounded up
};

}  // namespace impinge
