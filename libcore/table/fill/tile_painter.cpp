// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/fill/tile_painter.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>

#include "table/fill/tile_rows.hpp"

namespace impinge {

template <PackedValue Value>
void TilePainter<Value>::paint(std::size_t tile, std::span<const std::uint32_t> faces) {
  tile_ = task_.tiling[tile];
  std::fill_n(canvas_.q.begin(), tile_.seen_rows * TileCanvas::kStride, no_depth(task_.layer));
  cone_.reset();
  for (const std::uint32_t face : faces) add(face);
  draw_added();
  store();
}

template <PackedValue Value>
void TilePainter<Value>::add(std::uint32_t face) {
  const CubeView& view = task_.view;
  const Face& own = view.mesh().faces[face];
  if (view.in_front(own, tile_.face)) {
    add(face, {&view.corner(own[0]), &view.corner(own[1]), &view.corner(own[2])});
  } else if (const SeenFace seen = view.seen(own, tile_.face); seen.projected) {
    add(face, {&seen.corners[0], &seen.corners[1], &seen.corners[2]});
  } else {
    draw_exactly(face, window_in(tile_, seen.window));
  }
}

template <PackedValue Value>
void TilePainter<Value>::add(std::uint32_t face, const std::array<const SeenCorner*, 3>& corners) {
  const std::size_t at = corners_.count++;
  corners_.faces[at] = face;
  for (std::size_t k = 0; k < 3; ++k) {
    const SeenCorner& corner = *corners[k];
    corners_.x[k][at] = corner.x;
    corners_.y[k][at] = corner.y;
    corners_.q[k][at] = corner.q;
  }
  if (corners_.count == CornerBatch::kMost) draw_added();
}

template <PackedValue Value>
void TilePainter<Value>::draw_added() {
  const auto test = [](void* self, std::uint32_t face, std::size_t column, std::size_t row) {
    return static_cast<TilePainter*>(self)->covers(face, column, row);
  };
  set_up(corners_, tile_, task_.view.divisions(), triangles_);
  draw(triangles_, task_.layer, {test, this}, canvas_);
  for (std::uint64_t left = triangles_.seen & ~triangles_.clear; left != 0; left &= left - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    const long column = triangles_.first_column[k] + static_cast<long>(tile_.first_column);
    const long row = triangles_.first_row[k] + static_cast<long>(tile_.first_row);
    draw_exactly(corners_.faces[k],
                 {column, column + triangles_.columns[k] - 1, row, row + triangles_.rows[k] - 1});
  }
  corners_.count = 0;
}

template <PackedValue Value>
void TilePainter<Value>::draw_exactly(std::uint32_t face, const GridWindow& window) {
  if (cone(face).edge_on()) return;
  for (long j = window.first_row; j <= window.last_row; ++j) {
    for (long i = window.first_column; i <= window.last_column; ++i) {
      const std::size_t column = static_cast<std::size_t>(i) - tile_.first_column;
      const std::size_t row = static_cast<std::size_t>(j) - tile_.first_row;
      const Vec3 u = task_.scheme.direction(entry(column, row));
      if (!cone(face).contains(u)) continue;
      const auto q = static_cast<float>(1.0 / (cone(face).radius(u) * task_.scheme.depth(u)));
      float& kept = canvas_.q[row * TileCanvas::kStride + column];
      kept = task_.layer == Layer::nearest ? std::max(kept, q) : std::min(kept, q);
    }
  }
}

template <PackedValue Value>
void TilePainter<Value>::store() {
  auto& table = task_.table;
  const StoredSteps steps{static_cast<float>(table.smallest), static_cast<float>(1.0 / table.step)};
  const std::uint64_t seen = ~std::uint64_t{0} >> (64U - tile_.seen_columns);
  const auto empty = [&](std::size_t row) {
    return row < tile_.seen_rows
               ? seen & empty_entries(canvas_.q.data() + row * TileCanvas::kStride, task_.layer)
               : 0U;
  };
  std::uint64_t here = empty(0);
  for (std::size_t row = 0; row < tile_.rows; ++row) {
    store_row(canvas_.q.data() + row * TileCanvas::kStride, tile_.columns, steps,
              table.values.data() + entry(0, row));
    const std::uint64_t below = empty(row + 1);
    const std::uint64_t either = here | below;
    here = below;
    if (row + 1 < tile_.seen_rows) mark_cells(row, (either | either >> 1U) & seen >> 1U);
  }
}

// One bit a cell, from that at the first column on.
template <PackedValue Value>
void TilePainter<Value>::mark_cells(std::size_t row, std::uint64_t cells) {
  if (cells == 0) return;
  auto& table = task_.table;
  std::call_once(task_.mask_made, [&table] { table.none.resize(table.values.size() / 32 + 1, 0U); });
  const std::size_t first = entry(0, row);
  const std::size_t shift = first % 32;
  const std::uint64_t rest = shift == 0 ? 0U : cells >> (64U - shift);
  const std::array words{static_cast<std::uint32_t>(cells << shift),
                         static_cast<std::uint32_t>(cells << shift >> 32U), static_cast<std::uint32_t>(rest)};
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] != 0U)
      std::atomic_ref(table.none[first / 32 + k]).fetch_or(words[k], std::memory_order_relaxed);
  }
}

template <PackedValue Value>
bool TilePainter<Value>::covers(std::uint32_t face, std::size_t column, std::size_t row) {
  return cone(face).contains(task_.scheme.direction(entry(column, row)));
}

template <PackedValue Value>
const TriangleCone& TilePainter<Value>::cone(std::uint32_t face) {
  if (!cone_ || cone_face_ != face) cone_.emplace(cone_of(task_.view.mesh(), task_.view.mesh().faces[face]));
  cone_face_ = face;
  return *cone_;
}

template <PackedValue Value>
std::size_t TilePainter<Value>::entry(std::size_t column, std::size_t row) const {
  const std::size_t side = task_.table.stride;
  return (tile_.face * side + tile_.first_row + row) * side + tile_.first_column + column;
}

template class TilePainter<float>;
template class TilePainter<std::uint16_t>;

}  // namespace impinge
