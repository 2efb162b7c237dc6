// SPDX-License-Identifier: GPL-3.0-or-later
// The one kernel, over all schemes: a scheme says where on the grid of its table a point is. Included once
// for each instruction set, hence no #pragma once.
#if defined(IMPINGE_SCAN_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_SCAN_LANES
#undef IMPINGE_SCAN_LANES
#else
#define IMPINGE_SCAN_LANES
#endif

#include <limits>

#include <hwy/highway.h>

#include "kernels/lane_cells-inl.hpp"
#include "kernels/raw_scan.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct Point {
  hn::Vec<D> x;
  hn::Vec<D> y;
  hn::Vec<D> z;
};

// Where a point is on the grid.
template <class D>
struct Place {
  hn::Vec<D> row;  // of the table, the face included
  Line<D> along_row;
  Line<D> along_column;
};

template <class D>
HWY_INLINE Point<D> transformed(D d, const LaneTransform<hn::TFromD<D>>& by, const Point<D>& v) {
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

// What is stored at a place, and where there is nothing.
template <class D>
struct Found {
  hn::Vec<D> stored;
  hn::Mask<D> none;
};

template <class D, class Table>
HWY_INLINE Found<D> look_up(D d, const Table& table, const Place<D>& place) {
  const auto entry = first_entry(d, place.row, place.along_row.below, table.stride);
  const auto stored =
      between(d, table.values.data(), table.stride, entry, place.along_row, place.along_column);
  const auto none = table.none.empty() ? hn::Lt(stored, stored) : has_none(d, table.none.data(), entry);
  return {stored, none};
}

// Gaps of the vertices in one vector. A scheme says where a point is; look_up() of what it says, what is
// there.
template <class Scheme, class D, class Table>
HWY_INLINE hn::Vec<D> gaps(D d, const Scheme& scheme, const Table& table, hn::TFromD<D> sign,
                           const Point<D>& p) {
  using T = hn::TFromD<D>;
  const auto size = length(p);
  const Found<D> found = look_up(d, table, scheme.place(d, p));
  auto stored = found.stored;
  if constexpr (sizeof(*table.values.data()) == 2) {
    stored = hn::Add(hn::Set(d, static_cast<T>(table.smallest)),
                     hn::Mul(hn::Set(d, static_cast<T>(table.step)), stored));
  }
  const auto gap = hn::Mul(hn::Set(d, sign), hn::Sub(scheme.radius(d, p, size, stored), size));
  const auto met = hn::AndNot(found.none, hn::Gt(size, hn::Zero(d)));
  return hn::IfThenElse(met, gap, hn::Set(d, std::numeric_limits<T>::quiet_NaN()));
}

// gap = answer(vertices, place of the first of them), a vector at a time; the last one is filled up with
// points at the centre. Called at one place alone, so that compilers put it into the loop.
template <class T, class Answer>
HWY_INLINE void for_each_vector(const RawScan<T>& scan, const Answer& answer) {
  using D = hn::ScalableTag<T>;
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t whole = scan.count - scan.count % lanes;
  const std::size_t bytes = (scan.count - whole) * sizeof(T);
  T rest[4][hn::MaxLanes(D())] = {};
  if (bytes > 0) {
    std::memcpy(rest[0], scan.x + whole, bytes);
    std::memcpy(rest[1], scan.y + whole, bytes);
    std::memcpy(rest[2], scan.z + whole, bytes);
  }
  for (std::size_t i = 0; i < scan.count; i += lanes) {
    const bool full = i < whole;
    const Point<D> v{hn::LoadU(d, full ? scan.x + i : rest[0]), hn::LoadU(d, full ? scan.y + i : rest[1]),
                     hn::LoadU(d, full ? scan.z + i : rest[2])};
    hn::StoreU(answer(v, i), d, full ? scan.gap + i : rest[3]);
  }
  if (bytes > 0) std::memcpy(scan.gap + whole, rest[3], bytes);
}

template <class Scheme, class T, class Table>
void scan_lanes(const Table& table, const RawScan<T>& scan) {
  using D = hn::ScalableTag<T>;
  const D d;
  const Scheme scheme(table);
  for_each_vector(scan, [&](const Point<D>& v, std::size_t /*i*/) HWY_ATTR {
    return gaps(d, scheme, table, scan.sign, transformed(d, scan.transform, v));
  });
}

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
