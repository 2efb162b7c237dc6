// SPDX-License-Identifier: GPL-3.0-or-later
// Where on a cube map a point is. Included once for each instruction set, hence no #pragma once.
#if defined(IMPINGE_CUBE_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_CUBE_LANES
#undef IMPINGE_CUBE_LANES
#else
#define IMPINGE_CUBE_LANES
#endif

#include <hwy/highway.h>

#include "kernels/scan_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {

// See sphere/cube.hpp: the face is that of the largest coordinate, the first of equals; along its row runs
// the first of the other two.
class CubeLanes {
 public:
  template <class Table>
  explicit CubeLanes(const Table& table) : cells_(static_cast<float>(table.divisions)) {}

  template <class D>
  HWY_INLINE Place<D> place(D d, const Point<D>& p) const {
    const auto one = hn::Set(d, 1.0F);
    const auto cells = hn::Set(d, cells_);
    const auto size_x = hn::Abs(p.x);
    const auto size_y = hn::Abs(p.y);
    const auto size_z = hn::Abs(p.z);
    const auto on_x = hn::And(hn::Ge(size_x, size_y), hn::Ge(size_x, size_z));
    const auto on_z = hn::AndNot(on_x, hn::Lt(size_y, size_z));
    const auto depth = hn::IfThenElse(on_x, p.x, hn::IfThenElse(on_z, p.z, p.y));
    const auto inverse = hn::Div(one, hn::Abs(depth));
    const auto half = hn::Mul(hn::Set(d, 0.5F), cells);
    const auto a = hn::Mul(hn::IfThenElse(on_x, p.y, p.x), inverse);
    const auto b = hn::Mul(hn::IfThenElse(on_z, p.y, p.z), inverse);
    const Line<D> along_row = line_below(d, hn::Mul(hn::Add(a, one), half), cells);
    const Line<D> along_column = line_below(d, hn::Mul(hn::Add(b, one), half), cells);
    const auto axis =
        hn::IfThenElseZero(hn::Not(on_x), hn::IfThenElse(on_z, hn::Set(d, 4.0F), hn::Set(d, 2.0F)));
    const auto face = hn::Add(axis, hn::IfThenElseZero(hn::Lt(depth, hn::Zero(d)), one));
    return {hn::Add(hn::Mul(face, hn::Add(cells, one)), along_column.below), along_row, along_column};
  }

  // |P| / q of sphere/inverse_depth_table.hpp, |P| = length / depth.
  template <class D>
  HWY_INLINE hn::Vec<D> radius(D /*d*/, const Point<D>& p, hn::Vec<D> length, hn::Vec<D> q) const {
    const auto depth = hn::Max(hn::Abs(p.x), hn::Max(hn::Abs(p.y), hn::Abs(p.z)));
    return hn::Div(length, hn::Mul(depth, q));
  }

 private:
  float cells_;
};

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
