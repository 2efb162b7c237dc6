// SPDX-License-Identifier: GPL-3.0-or-later
// Faces through a face of the cube, a vector of them: their windows and planes, in double. Included once for
// each instruction set, hence no #pragma once.
#if defined(IMPINGE_TILE_PLANES) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_TILE_PLANES
#undef IMPINGE_TILE_PLANES
#else
#define IMPINGE_TILE_PLANES
#endif

#include <cstddef>

#include <hwy/highway.h>

#include "table/fill/tile_triangle.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using Wide = hn::Vec<Doubles>;
using Flags = hn::Mask<Doubles>;

// Entries along a side of the window.
struct Lines {
  Wide first, count;
};

// As many faces as a vector has lanes.
struct SomeFaces {
  Wide x[3], y[3], q[3];  // of the corners
  Wide extent;            // of x and y together
  Wide side, q_x, q_y;    // as SeenPlane
  Lines columns, rows;    // of the window
};

HWY_INLINE Wide least(const Wide* v) { return hn::Min(hn::Min(v[0], v[1]), v[2]); }
HWY_INLINE Wide most(const Wide* v) { return hn::Max(hn::Max(v[0], v[1]), v[2]); }

HWY_INLINE void load(const CornerBatch& batch, std::size_t first, SomeFaces& faces) {
  const Doubles d;
  for (std::size_t k = 0; k < 3; ++k) {
    faces.x[k] = hn::LoadU(d, batch.x[k].data() + first);
    faces.y[k] = hn::LoadU(d, batch.y[k].data() + first);
    faces.q[k] = hn::LoadU(d, batch.q[k].data() + first);
  }
}

// What a tile sees along one side of the window that CubeView has for the corners.
HWY_INLINE Lines lines_of(const Wide* places, std::size_t first_of_tile, std::size_t seen_of_tile) {
  const Doubles d;
  const auto from = static_cast<double>(first_of_tile);
  const auto last = from + static_cast<double>(seen_of_tile) - 1.0;
  const Wide reach = hn::Set(d, CubeView::kLeastReach);
  const Wide one = hn::Set(d, 1.0);
  const Wide begin = hn::Max(hn::Ceil(hn::Sub(least(places), reach)), hn::Set(d, from));
  const Wide end = hn::Min(hn::Floor(hn::Add(hn::Add(most(places), reach), one)), hn::Set(d, last + 1.0));
  return {begin, hn::Max(hn::Sub(end, begin), hn::Zero(d))};
}

// As plane_of(): says which of them are clear.
HWY_INLINE Flags find_planes(double error, SomeFaces& f) {
  const Doubles d;
  const Wide x1 = hn::Sub(f.x[1], f.x[0]), y1 = hn::Sub(f.y[1], f.y[0]), q1 = hn::Sub(f.q[1], f.q[0]);
  const Wide x2 = hn::Sub(f.x[2], f.x[0]), y2 = hn::Sub(f.y[2], f.y[0]), q2 = hn::Sub(f.q[2], f.q[0]);
  const Wide part = hn::Mul(x1, y2);
  const Wide other = hn::Mul(x2, y1);
  const Wide area = hn::Sub(part, other);
  f.extent = hn::Sub(hn::Add(hn::Sub(most(f.x), least(f.x)), most(f.y)), least(f.y));
  f.side = hn::CopySign(hn::Set(d, 1.0), area);
  f.q_x = hn::Div(hn::Sub(hn::Mul(q1, y2), hn::Mul(q2, y1)), area);
  f.q_y = hn::Div(hn::Sub(hn::Mul(x1, q2), hn::Mul(x2, q1)), area);
  const Wide parts = hn::Add(hn::Abs(part), hn::Abs(other));
  const Wide lost = hn::Mul(hn::Set(d, 16.0 * error), hn::Add(f.extent, hn::Set(d, error)));
  return hn::And(hn::Gt(hn::Mul(hn::Abs(area), hn::Set(d, kMostThin)), parts), hn::Gt(hn::Abs(area), lost));
}

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
