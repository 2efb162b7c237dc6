// SPDX-License-Identifier: GPL-3.0-or-later
// What a table of corners holds at a place. Included once for each instruction set, hence no #pragma once.
#if defined(IMPINGE_CORNER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_CORNER_INL
#undef IMPINGE_CORNER_INL
#else
#define IMPINGE_CORNER_INL
#endif

#include <bit>

#include <hwy/highway.h>

#include "gap/simd/corner_table.hpp"
#include "gap/simd/scan-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {

// As the loop over the vertices reads it.
struct RawCorners {
  const std::uint32_t* words;
  float smallest;
  float step;  // of the 2^14th part of a code
};

inline RawCorners raw_table(const CornerTable& table) {
  return {table.words.data(), table.smallest, table.step * 0x1p-14F};
}

// The word that a cell begins at and the one after it.
template <class D>
struct Words {
  hn::Vec<Bits<D>> left;
  hn::Vec<Bits<D>> right;
};

// Eight bytes from each of these places on, counted in words; they need not be aligned. Highway's gathers ask
// for places of 64 bits.
#if HWY_TARGET == HWY_AVX3
HWY_INLINE hn::Vec512<std::int64_t> eight_bytes(const std::uint32_t* words, hn::Vec256<std::int32_t> entry) {
  return hn::Vec512<std::int64_t>{_mm512_i32gather_epi64(entry.raw, words, 4)};
}
#elif HWY_TARGET == HWY_AVX2
HWY_INLINE hn::Vec256<std::int64_t> eight_bytes(const std::uint32_t* words, hn::Vec128<std::int32_t> entry) {
  return hn::Vec256<std::int64_t>{
      _mm256_i32gather_epi64(reinterpret_cast<const long long*>(words), entry.raw, 4)};
}
#endif

template <class D>
HWY_INLINE Words<D> load_words(D /*d*/, const std::uint32_t* words, hn::Vec<Whole<D>> entry) {
  const Bits<D> bits;
#if HWY_TARGET <= HWY_AVX2
  const hn::Half<Whole<D>> half;
  const auto low = hn::BitCast(bits, eight_bytes(words, hn::LowerHalf(half, entry)));
  const auto high = hn::BitCast(bits, eight_bytes(words, hn::UpperHalf(half, entry)));
  return {hn::ConcatEven(bits, high, low), hn::ConcatOdd(bits, high, low)};
#else
  constexpr std::size_t kLanes = hn::MaxLanes(Whole<D>());
  HWY_ALIGN std::int32_t at[kLanes];
  HWY_ALIGN std::uint32_t left[kLanes];
  HWY_ALIGN std::uint32_t right[kLanes];
  hn::Store(entry, Whole<D>(), at);
  for (std::size_t k = 0; k < kLanes; ++k) {
    left[k] = words[at[k]];
    right[k] = words[at[k] + 1];
  }
  return {hn::Load(bits, left), hn::Load(bits, right)};
#endif
}

// upper (2^14 - w) + lower w, exact, of the codes in each word; `weights` has the factors in the same halves.
template <class D>
HWY_INLINE hn::Vec<D> weighted(D d, hn::Vec<Bits<D>> words, hn::Vec<Bits<D>> weights) {
  const Whole<D> whole;
#if HWY_TARGET <= HWY_SSE4
  const hn::Repartition<std::int16_t, D> halves;
  auto none = hn::Zero(whole);
  const auto sum = hn::ReorderWidenMulAccumulate(whole, hn::BitCast(halves, words),
                                                 hn::BitCast(halves, weights), hn::Zero(whole), none);
#else
  const auto low = hn::Set(Bits<D>(), 0xFFFFU);
  const auto upper = hn::Mul(hn::And(words, low), hn::And(weights, low));
  const auto lower = hn::Mul(hn::ShiftRight<16>(words), hn::ShiftRight<16>(weights));
  const auto sum = hn::BitCast(whole, hn::Add(upper, lower));
#endif
  return hn::ConvertTo(d, sum);
}

template <class D, class Place>
HWY_INLINE Found<D> look_up(D d, const RawCorners& table, const Place& place) {
  const Bits<D> bits;
  const Words<D> words = load_words(d, table.words, place.entry);
  const auto whole = hn::Add(hn::Mul(place.down, hn::Set(d, 16384.0F)), hn::Set(d, kWhole));
  const auto w = hn::BitCast(bits, whole);
  const auto weights =
      hn::Add(hn::Sub(hn::ShiftLeft<16>(w), w), hn::Set(bits, 16384U - (kWholeBits * 0xFFFFU)));
  const auto left = weighted(d, words.left, weights);
  const auto right = weighted(d, hn::And(words.right, hn::Set(bits, ~CornerTable::kNone)), weights);
  const auto code = hn::Add(left, hn::Mul(place.across, hn::Sub(right, left)));
  const auto number = hn::Add(hn::Set(d, table.smallest), hn::Mul(hn::Set(d, table.step), code));
  return {number, hn::RebindMask(d, hn::TestBit(words.left, hn::Set(bits, CornerTable::kNone)))};
}

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
