// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/floor_scan.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/scan_floor.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "gap/simd/scan-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::lab::HWY_NAMESPACE {
namespace {

using namespace impinge::HWY_NAMESPACE;

// Reads one entry per vertex, on a square with `side` entries per side, at the place given by x and y. So
// entries of neighbouring vertices are as near to each other as the vertices are.
void floor_lanes(const FloorTable& table, const RawScan<float>& scan) {
  using D = hn::ScalableTag<float>;
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  const auto last = hn::Set(d, static_cast<float>(table.side - 1));
  const auto middle = hn::Mul(hn::Set(d, 0.5F), last);
  const auto scale = hn::Div(middle, hn::Set(d, table.reach));
  for (std::size_t i = 0; i + lanes <= scan.count; i += lanes) {
    const Point<D> v{hn::LoadU(d, scan.x + i), hn::LoadU(d, scan.y + i), hn::LoadU(d, scan.z + i)};
    const Point<D> p = transformed(d, scan.transform, v);
    const auto column = hn::Min(hn::Max(hn::Add(hn::Mul(p.x, scale), middle), hn::Zero(d)), last);
    const auto row = hn::Min(hn::Max(hn::Add(hn::Mul(p.y, scale), middle), hn::Zero(d)), last);
    const Whole<D> whole;
    const auto rows =
        hn::Mul(hn::ConvertTo(whole, row), hn::Set(whole, static_cast<std::int32_t>(table.side)));
    const auto entry = hn::Add(rows, hn::ConvertTo(whole, column));
    const auto value = hn::GatherIndex(d, table.values.data(), entry);
    hn::StoreU(hn::Mul(hn::Set(d, scan.sign), hn::Sub(value, length(p))), d, scan.gap + i);
  }
}

}  // namespace
}  // namespace impinge::lab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace impinge::lab {
namespace {

HWY_EXPORT(floor_lanes);

}  // namespace

void floor_scan(const FloorTable& table, const PackedVertices<float>& vertices, const Pose& pose,
                Surface scanned, std::span<float> out) {
  HWY_DYNAMIC_DISPATCH(floor_lanes)(table, raw_scan(vertices, pose, scanned, out));
}

}  // namespace impinge::lab
#endif
