// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/fill/raster_tile.hpp"

#include <bit>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "table/fill/raster_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

// No more lanes than a canvas has room for beyond its last column.
using Floats = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<Floats>;

// One of the triangles of a batch.
struct One {
  const TileTriangles& all;
  std::size_t k;

  std::size_t first_column() const { return static_cast<std::size_t>(all.first_column[k]); }
  std::size_t first_row() const { return static_cast<std::size_t>(all.first_row[k]); }
  std::size_t columns() const { return static_cast<std::size_t>(all.columns[k]); }
  std::size_t rows() const { return static_cast<std::size_t>(all.rows[k]); }
};

// Which of the lanes in doubt, those of entries from (column, row) of the triangle on, the face covers.
HWY_NOINLINE hn::Mask<Floats> decided(Floats d, hn::Mask<Floats> doubtful, const One& one, std::size_t column,
                                      std::size_t row, const ExactTest& exact) {
  HWY_ALIGN float covered[hn::MaxLanes(Floats())];
  hn::Store(hn::IfThenElseZero(doubtful, hn::Set(d, 1.0F)), d, covered);
  for (std::size_t k = 0; k < hn::Lanes(d); ++k) {
    const bool asked = covered[k] > 0.0F && column + k < one.columns();
    if (!asked || !exact.covers(exact.context, one.all.faces[one.k], one.first_column() + column + k,
                                one.first_row() + row))
      covered[k] = 0.0F;
  }
  return hn::Gt(hn::Load(d, covered), hn::Zero(d));
}

// The columns from `column` on of a triangle, as many as a vector has lanes.
template <bool nearest>
HWY_INLINE void draw_columns(Floats d, const One& one, std::size_t column, const ExactTest& exact,
                             float* canvas) {
  const TileTriangles& all = one.all;
  const std::size_t k = one.k;
  const Lanes i = hn::Iota(d, static_cast<float>(column));
  const auto along = [&](float first, float step)
                         HWY_ATTR { return hn::Add(hn::Set(d, first), hn::Mul(hn::Set(d, step), i)); };
  const Lanes e0 = along(all.edge[0][k], all.edge_x[0][k]);
  const Lanes e1 = along(all.edge[1][k], all.edge_x[1][k]);
  const Lanes e2 = along(all.edge[2][k], all.edge_x[2][k]);
  const Lanes q0 = along(all.q[k], all.q_x[k]);
  const Lanes y0 = hn::Set(d, all.edge_y[0][k]);
  const Lanes y1 = hn::Set(d, all.edge_y[1][k]);
  const Lanes y2 = hn::Set(d, all.edge_y[2][k]);
  const Lanes q_y = hn::Set(d, all.q_y[k]);
  const Lanes doubt = hn::Set(d, all.doubt[k]);
  const std::size_t rows = one.rows();
  for (std::size_t row = 0; row < rows; ++row) {
    const Lanes j = hn::Set(d, static_cast<float>(row));
    const Lanes least = hn::Min(hn::Min(hn::Add(e0, hn::Mul(y0, j)), hn::Add(e1, hn::Mul(y1, j))),
                                hn::Add(e2, hn::Mul(y2, j)));
    auto inside = hn::Gt(least, doubt);
    const auto doubtful = hn::Le(hn::Abs(least), doubt);
    if (HWY_UNLIKELY(!hn::AllFalse(d, doubtful)))
      inside = hn::Or(inside, decided(d, doubtful, one, column, row, exact));
    const Lanes q = hn::Add(q0, hn::Mul(q_y, j));
    const Lanes kept = hn::LoadU(d, canvas);
    const Lanes chosen = nearest ? hn::Max(kept, q) : hn::Min(kept, q);
    hn::StoreU(hn::IfThenElse(inside, chosen, kept), d, canvas);
    canvas += TileCanvas::kStride;
  }
}

template <bool nearest>
HWY_INLINE void draw_layer(const TileTriangles& triangles, const ExactTest& exact, TileCanvas& canvas) {
  const Floats d;
  for (std::uint64_t left = triangles.clear; left != 0; left &= left - 1) {
    const One one{triangles, static_cast<std::size_t>(std::countr_zero(left))};
    float* const first = canvas.q.data() + one.first_row() * TileCanvas::kStride + one.first_column();
    const std::size_t columns = one.columns();
    for (std::size_t column = 0; column < columns; column += hn::Lanes(d))
      draw_columns<nearest>(d, one, column, exact, first + column);
  }
}

void draw_nearest(const TileTriangles& triangles, const ExactTest& exact, TileCanvas& canvas) {
  draw_layer<true>(triangles, exact, canvas);
}
void draw_farthest(const TileTriangles& triangles, const ExactTest& exact, TileCanvas& canvas) {
  draw_layer<false>(triangles, exact, canvas);
}

}  // namespace
}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace impinge {
namespace {

HWY_EXPORT(draw_nearest);
HWY_EXPORT(draw_farthest);

}  // namespace

float no_depth(Layer layer) {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  return layer == Layer::nearest ? -kInfinite : kInfinite;
}

void draw(const TileTriangles& triangles, Layer layer, const ExactTest& exact, TileCanvas& canvas) {
  if (layer == Layer::nearest) {
    HWY_DYNAMIC_DISPATCH(draw_nearest)(triangles, exact, canvas);
  } else {
    HWY_DYNAMIC_DISPATCH(draw_farthest)(triangles, exact, canvas);
  }
}

}  // namespace impinge
#endif
