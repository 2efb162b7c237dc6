// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel for all schemes: a scheme says where on the grid of its table a point is. Included once for each
// instruction set, hence no #pragma once.
#if defined(IMPINGE_SCAN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_SCAN_INL
#undef IMPINGE_SCAN_INL
#else
#define IMPINGE_SCAN_INL
#endif

#include <limits>

#include <hwy/highway.h>

#include "gap/simd/cells-inl.hpp"
#include "gap/simd/raw_scan.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct Point {
  hn::Vec<D> x;
  hn::Vec<D> y;
  hn::Vec<D> z;
};

// The place of a point on the grid: the entry at which its cell begins, and how far into the cell it is, from
// 0 to 1.
template <class D>
struct Place {
  hn::Vec<Whole<D>> entry;
  hn::Vec<D> across;  // along the row
  hn::Vec<D> down;    // to the next row
};

template <class D>
HWY_INLINE Point<D> transformed(D d, const PackedTransform<hn::TFromD<D>>& by, const Point<D>& v) {
  const auto coordinate = [&](std::size_t k) HWY_ATTR {
    const auto& r = by.rotation[k];
    const auto xy = hn::Add(hn::Mul(hn::Set(d, r[0]), v.x), hn::Mul(hn::Set(d, r[1]), v.y));
    return hn::Add(hn::Add(xy, hn::Mul(hn::Set(d, r[2]), v.z)), hn::Set(d, by.translation[k]));
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

template <class D>
HWY_INLINE hn::Vec<D> length(const Point<D>& p) {
  return hn::Sqrt(hn::Add(hn::Add(hn::Mul(p.x, p.x), hn::Mul(p.y, p.y)), hn::Mul(p.z, p.z)));
}

template <class D>
HWY_INLINE hn::Vec<D> no_gap(D d) {
  return hn::Set(d, std::numeric_limits<hn::TFromD<D>>::quiet_NaN());
}

// r - |x|; NaN for a point at the centre, which has no direction.
template <class D>
HWY_INLINE hn::Vec<D> radial_gap(D d, const Point<D>& p, hn::Vec<D> radius) {
  const auto size = length(p);
  return hn::IfThenElse(hn::Gt(size, hn::Zero(d)), hn::Sub(radius, size), no_gap(d));
}

// The number of a table at a place, and whether there is none.
template <class D>
struct Found {
  hn::Vec<D> number;
  hn::Mask<D> none;
};

// A table in the form that the loop over the vertices reads.
template <class T, class Value, class Word>
struct RawTable {
  const Value* values;
  const Word* none;  // null if all cells have an answer
  std::size_t stride;
  T smallest;
  T step;
};

template <class S, class Value>
auto raw_table(const PackedTable<S, Value>& table) {
  using T = typename PackedTable<S, Value>::Real;
  using Word = typename PackedTable<S, Value>::Word;
  return RawTable<T, Value, Word>{table.values.data(), table.none.empty() ? nullptr : table.none.data(),
                                  table.stride, static_cast<T>(table.smallest), static_cast<T>(table.step)};
}

// The number that a stored one stands for.
template <class D, class Value, class Word>
HWY_INLINE hn::Vec<D> decoded(D d, const RawTable<hn::TFromD<D>, Value, Word>& table, hn::Vec<D> stored) {
  if constexpr (sizeof(Value) != 2) {
    return stored;
  } else {
    return hn::Add(hn::Set(d, table.smallest), hn::Mul(hn::Set(d, table.step), stored));
  }
}

template <class D, class Table, class Place>
HWY_INLINE Found<D> look_up(D d, const Table& table, const Place& place) {
  const auto stored = between(d, table.values, table.stride, place.entry, place.across, place.down);
  const auto none = table.none == nullptr ? hn::Lt(stored, stored) : has_none(d, table.none, place.entry);
  return {decoded(d, table, stored), none};
}

// Gaps of the vertices in one vector. The scheme gives the place of a point, look_up() the number that the
// raw table has there, and the scheme the gap that this number means.
template <class Scheme, class D, class Table>
HWY_INLINE hn::Vec<D> gaps(D d, const Scheme& scheme, const Table& table, hn::TFromD<D> sign,
                           const Point<D>& p) {
  const auto place = scheme.place(d, p);
  const Found<D> found = look_up(d, table, place);
  const auto gap = hn::Mul(hn::Set(d, sign), scheme.gap(d, p, place, found.number));
  return hn::IfThenElse(found.none, no_gap(d), gap);
}

// gap = answer(vertices), one vector at a time; the last vector is filled up with points at the centre.
// `answer` must hold copies: what it reads by reference could be the gaps that are written.
template <class T, class Answer>
HWY_INLINE void for_each_vector(const RawScan<T>& scan, const Answer& answer) {
  using D = hn::ScalableTag<T>;
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  const T* const x = scan.x;
  const T* const y = scan.y;
  const T* const z = scan.z;
  T* const gap = scan.gap;
  const std::size_t whole = scan.count - scan.count % lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    hn::StoreU(answer(Point<D>{hn::LoadU(d, x + i), hn::LoadU(d, y + i), hn::LoadU(d, z + i)}), d, gap + i);
  if (whole == scan.count) return;
  const std::size_t bytes = (scan.count - whole) * sizeof(T);
  T rest[4][hn::MaxLanes(D())] = {};
  std::memcpy(rest[0], x + whole, bytes);
  std::memcpy(rest[1], y + whole, bytes);
  std::memcpy(rest[2], z + whole, bytes);
  const Point<D> last{hn::LoadU(d, rest[0]), hn::LoadU(d, rest[1]), hn::LoadU(d, rest[2])};
  hn::StoreU(answer(last), d, rest[3]);
  std::memcpy(gap + whole, rest[3], bytes);
}

// Takes copies, so that what the loop reads cannot change as gaps are written.
template <class Scheme, class Table, class T>
void scan_lanes(const Scheme scheme, const Table table, const RawScan<T>& scan) {
  using D = hn::ScalableTag<T>;
  const D d;
  const PackedTransform<T> transform = scan.transform;
  const T sign = scan.sign;
  for_each_vector(scan, [&](const Point<D>& v)
                            HWY_ATTR { return gaps(d, scheme, table, sign, transformed(d, transform, v)); });
}

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
