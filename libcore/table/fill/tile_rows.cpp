// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/fill/tile_rows.hpp"

#include <cstring>
#include <limits>

#include "table/fill/raster_tile.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "table/fill/tile_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using Floats = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<Floats>;

// Lanes of a mask as bits, lane 0 the lowest.
HWY_INLINE std::uint64_t bits_of(Floats d, hn::Mask<Floats> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return std::uint64_t{bytes[0]} | std::uint64_t{bytes[1]} << 8U;
}

// Entries without a surface, infinite on the canvas, become `harmless`.
template <class Value, class Code>
HWY_INLINE void store_lanes(const float* q, std::size_t count, Value* row, Code&& code) {
  const Floats d;
  HWY_ALIGN Value whole[TileCanvas::kStride];
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) code(d, hn::LoadU(d, q + k), whole + k);
  std::memcpy(row, whole, count * sizeof(Value));
}

void store_codes(const float* q, std::size_t count, const StoredSteps& steps, std::uint16_t* row) {
  store_lanes(q, count, row, [&](Floats d, Lanes value, std::uint16_t* out) HWY_ATTR {
    const hn::Rebind<std::uint16_t, Floats> narrow;
    const hn::RebindToSigned<Floats> whole;
    const Lanes steps_up = hn::Mul(hn::Sub(value, hn::Set(d, steps.smallest)), hn::Set(d, steps.per_step));
    const Lanes within = hn::Min(hn::Max(steps_up, hn::Zero(d)), hn::Set(d, 65534.0F));
    const auto missing = hn::Gt(hn::Abs(value), hn::Set(d, std::numeric_limits<float>::max()));
    const auto codes = hn::NearestInt(hn::IfThenElse(missing, hn::Zero(d), within));
    hn::StoreU(hn::DemoteTo(narrow, hn::BitCast(whole, codes)), narrow, out);
  });
}

void store_floats(const float* q, std::size_t count, float* row) {
  store_lanes(q, count, row, [&](Floats d, Lanes value, float* out) HWY_ATTR {
    const auto missing = hn::Gt(hn::Abs(value), hn::Set(d, std::numeric_limits<float>::max()));
    hn::StoreU(hn::IfThenElse(missing, hn::Set(d, 1.0F), value), d, out);
  });
}

std::uint64_t find_empty(const float* q, float none) {
  const Floats d;
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < CubeTiling::kMostSeen; k += hn::Lanes(d))
    bits |= bits_of(d, hn::Eq(hn::LoadU(d, q + k), hn::Set(d, none))) << k;
  return bits;
}

}  // namespace
}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace impinge {
namespace {

HWY_EXPORT(store_codes);
HWY_EXPORT(store_floats);
HWY_EXPORT(find_empty);

}  // namespace

void store_row(const float* q, std::size_t count, const StoredSteps& steps, std::uint16_t* row) {
  HWY_DYNAMIC_DISPATCH(store_codes)(q, count, steps, row);
}
void store_row(const float* q, std::size_t count, const StoredSteps& /*steps*/, float* row) {
  HWY_DYNAMIC_DISPATCH(store_floats)(q, count, row);
}

std::uint64_t empty_entries(const float* q, Layer layer) {
  return HWY_DYNAMIC_DISPATCH(find_empty)(q, no_depth(layer));
}

}  // namespace impinge
#endif
