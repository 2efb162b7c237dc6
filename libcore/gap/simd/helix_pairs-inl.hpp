// SPDX-License-Identifier: GPL-3.0-or-later
// Loads two neighbouring entries of a helix for each lane, as doubles. Included once for each instruction
// set, hence no #pragma once.
#if defined(IMPINGE_HELIX_PAIRS) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_HELIX_PAIRS
#undef IMPINGE_HELIX_PAIRS
#else
#define IMPINGE_HELIX_PAIRS
#endif

#include <bit>
#include <cstring>
#include <limits>

#include <hwy/highway.h>

#include "gap/simd/cells-inl.hpp"
#include "sphere/stored_values.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {

template <class D>
HWY_INLINE Pair<D> helix_pair(D d, const double* values, hn::Vec<Whole<D>> entry) {
  return load_pair(d, values, entry);
}

// Loads eight bytes from an entry on, which need not be aligned. On sets whose gathers ask for alignment,
// lane by lane.
template <class D, class T>
HWY_INLINE hn::Vec<Bits<D>> eight_bytes(D /*d*/, const T* values, hn::Vec<Whole<D>> entry) {
  const Bits<D> bits;
#if HWY_TARGET <= HWY_AVX2
  constexpr int kShift = sizeof(T) == 4 ? 2 : 1;
  return hn::GatherOffset(bits, reinterpret_cast<const std::uint64_t*>(values), hn::ShiftLeft<kShift>(entry));
#else
  const Whole<D> whole;
  HWY_ALIGN std::int64_t at[hn::MaxLanes(Whole<D>())];
  HWY_ALIGN std::uint64_t read[hn::MaxLanes(Bits<D>())];
  hn::Store(entry, whole, at);
  for (std::size_t k = 0; k < hn::MaxLanes(Whole<D>()); ++k)
    std::memcpy(&read[k], values + at[k], sizeof *read);
  return hn::Load(bits, read);
#endif
}

// The lower 32 bits of each lane as a vector of half the size.
template <class D>
using Narrow = hn::Rebind<std::uint32_t, D>;

template <class D>
HWY_INLINE Pair<D> helix_pair(D d, const float* values, hn::Vec<Whole<D>> entry) {
  static_assert(std::endian::native == std::endian::little);
  const auto both = eight_bytes(d, values, entry);
  const hn::Rebind<float, D> floats;
  const auto low = hn::BitCast(floats, hn::TruncateTo(Narrow<D>(), both));
  const auto high = hn::BitCast(floats, hn::TruncateTo(Narrow<D>(), hn::ShiftRight<32>(both)));
  return {hn::PromoteTo(d, low), hn::PromoteTo(d, high)};
}

// NaN for the code that stands for it.
template <class D>
HWY_INLINE hn::Vec<D> without_none(D d, hn::Vec<Bits<D>> bits) {
  const auto code = hn::And(bits, hn::Set(Bits<D>(), 0xFFFFU));
  const auto none = hn::RebindMask(d, hn::Eq(code, hn::Set(Bits<D>(), Uint16Values::kNone)));
  const auto narrow = hn::BitCast(hn::Rebind<std::int32_t, D>(), hn::TruncateTo(Narrow<D>(), code));
  const auto value = hn::PromoteTo(d, narrow);
  return hn::IfThenElse(none, hn::Set(d, std::numeric_limits<double>::quiet_NaN()), value);
}

template <class D>
HWY_INLINE Pair<D> helix_pair(D d, const std::uint16_t* values, hn::Vec<Whole<D>> entry) {
  static_assert(std::endian::native == std::endian::little);
  const auto both = eight_bytes(d, values, entry);
  return {without_none(d, both), without_none(d, hn::ShiftRight<16>(both))};
}

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
