// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the place of a point on a cube map. Included once for each instruction set, hence no #pragma once.
#if defined(IMPINGE_CUBE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_CUBE_INL
#undef IMPINGE_CUBE_INL
#else
#define IMPINGE_CUBE_INL
#endif

#include <hwy/highway.h>

#include "gap/simd/scan-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {

// A place on the grid; the length of the point is secant * depth.
template <class D>
struct CubePlace {
  hn::Vec<Whole<D>> entry;
  hn::Vec<D> across;
  hn::Vec<D> down;
  hn::Vec<D> secant;
  hn::Vec<D> depth;
};

// See sphere/cube.hpp: the face belongs to the largest coordinate, the first of equals; the first of the
// other two runs along its rows. A face has `divisions` cells, and one entry more, along each side.
class CubeLanes {
 public:
  template <class Table>
  explicit CubeLanes(const Table& table)
      : half_(0.5F * static_cast<float>(table.divisions)),
        row_(static_cast<std::uint32_t>(table.divisions + 1)),
        face_(row_ * row_) {}

  template <class D>
  HWY_INLINE CubePlace<D> place(D d, const Point<D>& p) const {
    const auto one = hn::Set(d, 1.0F);
    const auto size_x = hn::Abs(p.x);
    const auto size_y = hn::Abs(p.y);
    const auto size_z = hn::Abs(p.z);
    const auto size_yz = hn::Max(size_y, size_z);
    const auto on_x = hn::Ge(size_x, size_yz);
    const auto z_first = hn::Lt(size_y, size_z);
    const auto depth = hn::Max(size_x, size_yz);
    const auto inverse = hn::Div(one, depth);
    const auto a = hn::Mul(hn::IfThenElse(on_x, p.y, p.x), inverse);
    const auto b = hn::Mul(hn::IfThenElse(on_x, p.z, hn::IfThenElse(z_first, p.y, p.z)), inverse);
    const auto secant = hn::Sqrt(hn::Add(hn::Add(one, hn::Mul(a, a)), hn::Mul(b, b)));
    const CellLine<D> column = cell_line(d, a);
    const CellLine<D> row = cell_line(d, b);
    const auto side = hn::IfThenElse(on_x, p.x, hn::IfThenElse(z_first, p.z, p.y));
    const Bits<D> bits;
    const auto entry = hn::Add(hn::Add(hn::Mul(row.bits, hn::Set(bits, row_)), column.bits),
                               face_entry(d, side, on_x, z_first));
    return {hn::BitCast(Whole<D>(), hn::Min(entry, hn::Set(bits, last_cell()))), column.share, row.share,
            secant, depth};
  }

  // r - |x| from an inverse depth q, see sphere/stored_table.hpp. NaN at the centre, where a and b are.
  template <class D>
  HWY_INLINE hn::Vec<D> gap(D d, const Point<D>& /*p*/, const CubePlace<D>& place, hn::Vec<D> q) const {
    return hn::Mul(place.secant, hn::Sub(hn::Div(hn::Set(d, 1.0F), q), place.depth));
  }

 private:
  // The line below a place, as its number plus kWholeBits, and the share of the cell.
  template <class D>
  struct CellLine {
    hn::Vec<Bits<D>> bits;
    hn::Vec<D> share;
  };

  // The line below a coordinate a in [-1, 1], or up to 3 u beyond. The place less half a cell is rounded, so
  // that a place on a line may go to either cell beside it. The grid is made smaller by 8 u of itself, so
  // that no place is beyond its first or last cell.
  template <class D>
  HWY_INLINE CellLine<D> cell_line(D d, hn::Vec<D> a) const {
    const auto whole = hn::Set(d, kWhole);
    const auto middle = hn::Add(hn::Mul(a, hn::Set(d, half_ * (1.0F - 0x1p-21F))), hn::Set(d, half_ - 0.5F));
    const auto sum = hn::Add(middle, whole);
    const auto past_middle = hn::Sub(middle, hn::Sub(sum, whole));
    return {hn::BitCast(Bits<D>(), sum), hn::Add(past_middle, hn::Set(d, 0.5F))};
  }

  // First entry of the face, less the kWholeBits in the bits of row and column.
  template <class D>
  HWY_INLINE hn::Vec<Bits<D>> face_entry(D d, hn::Vec<D> side, hn::Mask<D> on_x, hn::Mask<D> z_first) const {
    const Bits<D> bits;
    const std::uint32_t excess = kWholeBits * (row_ + 1U);
    const auto first = [&](std::uint32_t face)
                           HWY_ATTR { return hn::BitCast(d, hn::Set(bits, face * face_ - excess)); };
    const auto axis = hn::IfThenElse(on_x, first(0), hn::IfThenElse(z_first, first(4), first(2)));
    const auto back = hn::IfThenElseZero(hn::Lt(side, hn::Zero(d)), hn::BitCast(d, hn::Set(bits, face_)));
    return hn::Add(hn::BitCast(bits, axis), hn::BitCast(bits, back));
  }

  // Keeps a place that is NaN from reading beyond the table.
  std::uint32_t last_cell() const { return 6 * face_ - row_ - 2; }

  float half_;
  std::uint32_t row_;   // entries
  std::uint32_t face_;  // entries
};

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
