// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolates the numbers of a table at a place on its grid. Included once for each instruction set (see
// Highway's foreach_target.h), hence no #pragma once.
#if defined(IMPINGE_CELLS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_CELLS_INL
#undef IMPINGE_CELLS_INL
#else
#define IMPINGE_CELLS_INL
#endif

#include <bit>
#include <cstring>

#include <hwy/highway.h>

#include "table/packed_table.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
using Whole = hn::RebindToSigned<D>;
template <class D>
using Bits = hn::RebindToUnsigned<D>;

// Adding this rounds a number of up to 2^22 to the nearest whole one: the bits of the sum are that number
// more than kWholeBits.
inline constexpr float kWhole = 0x1.8p23F;
inline constexpr std::uint32_t kWholeBits = 0x4B400000U;

// The grid line below a place, a whole number, and how far into the cell the place is, from 0 to 1.
template <class D>
struct Line {
  hn::Vec<D> below;
  hn::Vec<D> share;
};

// The line below a place. A place outside of [0, count] is moved to its end, and NaN to 0, so that no index
// is wild.
template <class D>
HWY_INLINE Line<D> line_below(D d, hn::Vec<D> place, hn::Vec<D> count) {
  const auto from = hn::IfThenElseZero(hn::Gt(place, hn::Zero(d)), place);
  const auto inside = hn::Min(from, count);
  const auto below = hn::Min(hn::Floor(inside), hn::Sub(count, hn::Set(d, hn::TFromD<D>{1})));
  return {below, hn::Sub(inside, below)};
}

// row * stride + column, exactly: floats are converted to whole numbers first, as their 24 bits are too few.
template <class D>
HWY_INLINE hn::Vec<Whole<D>> first_entry(D d, hn::Vec<D> row, hn::Vec<D> column, std::size_t stride) {
  using T = hn::TFromD<D>;
  const Whole<D> whole;
  if constexpr (sizeof(T) == 4) {
    const auto rows = hn::Mul(hn::ConvertTo(whole, row), hn::Set(whole, static_cast<std::int32_t>(stride)));
    return hn::Add(rows, hn::ConvertTo(whole, column));
  } else {
    return hn::ConvertTo(whole, hn::Add(hn::Mul(row, hn::Set(d, static_cast<T>(stride))), column));
  }
}

// Two neighbouring entries of a row for each lane.
template <class D>
struct Pair {
  hn::Vec<D> left;
  hn::Vec<D> right;
};

template <class D, class T>
HWY_INLINE Pair<D> load_pair(D d, const T* values, hn::Vec<Whole<D>> entry) {
  return {hn::GatherIndex(d, values, entry), hn::GatherIndex(d, values + 1, entry)};
}

// Loads both entries as 32 bits that need not be aligned. On sets whose gathers ask for alignment, lane by
// lane.
template <class D>
HWY_INLINE Pair<D> load_pair(D d, const std::uint16_t* values, hn::Vec<Whole<D>> entry) {
  const Whole<D> whole;
#if HWY_TARGET <= HWY_AVX2
  const auto both =
      hn::GatherOffset(whole, reinterpret_cast<const std::int32_t*>(values), hn::ShiftLeft<1>(entry));
#else
  HWY_ALIGN std::int32_t at[hn::MaxLanes(Whole<D>())];
  hn::Store(entry, whole, at);
  for (std::int32_t& lane : at) std::memcpy(&lane, values + lane, sizeof lane);
  const auto both = hn::Load(whole, at);
#endif
  const auto low = hn::And(both, hn::Set(whole, 0xFFFF));
  const auto high = hn::BitCast(whole, hn::ShiftRight<16>(hn::BitCast(Bits<D>(), both)));
  constexpr bool little = std::endian::native == std::endian::little;
  return {hn::ConvertTo(d, little ? low : high), hn::ConvertTo(d, little ? high : low)};
}

// Bilinear interpolation between the four corners of a cell.
template <class D, class Value>
HWY_INLINE hn::Vec<D> between(D d, const Value* values, std::size_t stride, hn::Vec<Whole<D>> entry,
                              hn::Vec<D> across, hn::Vec<D> down) {
  const Pair<D> near = load_pair(d, values, entry);
  const Pair<D> far = load_pair(d, values + stride, entry);
  const auto upper = hn::Add(near.left, hn::Mul(across, hn::Sub(near.right, near.left)));
  const auto lower = hn::Add(far.left, hn::Mul(across, hn::Sub(far.right, far.left)));
  return hn::Add(upper, hn::Mul(down, hn::Sub(lower, upper)));
}

// Do the cells that begin at these entries have no answer?
template <class D, class Word>
HWY_INLINE hn::Mask<D> has_none(D d, const Word* none, hn::Vec<Whole<D>> entry) {
  constexpr int kShift = sizeof(Word) == 4 ? 5 : 6;
  const Bits<D> bits;
  const auto at = hn::BitCast(bits, entry);
  const auto word = hn::GatherIndex(bits, none, hn::ShiftRight<kShift>(entry));
  const auto within = hn::And(at, hn::Set(bits, Word{(1U << kShift) - 1U}));
  const auto bit = hn::And(hn::Shr(word, within), hn::Set(bits, Word{1}));
  return hn::RebindMask(d, hn::Ne(bit, hn::Zero(bits)));
}

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
