// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/gap_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gap/simd/scan_rsid.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "gap/simd/angle-inl.hpp"
#include "gap/simd/scan-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace {

// See sphere/schemes/rsid.hpp: rows of phi, columns of theta.
template <class T>
class RsidLanes {
 public:
  template <class Value>
  explicit RsidLanes(const PackedTable<Rsid, Value>& table)
      : rows_(static_cast<T>(table.divisions)),
        columns_(static_cast<T>(2 * table.divisions)),
        stride_(table.stride),
        cells_a_radian_(static_cast<T>(static_cast<double>(table.divisions) / kPi)) {}

  template <class D>
  HWY_INLINE Place<D> place(D d, const Point<D>& p) const {
    const auto scale = hn::Set(d, cells_a_radian_);
    const auto across = hn::Sqrt(hn::Add(hn::Mul(p.x, p.x), hn::Mul(p.y, p.y)));
    const auto half = half_turn_angle(d, p.y, p.x);
    const auto turn = hn::Set(d, static_cast<T>(2.0 * kPi));
    const auto theta = hn::IfThenElse(hn::Lt(p.y, hn::Zero(d)), hn::Sub(turn, half), half);
    const auto phi = half_turn_angle(d, across, p.z);
    const Line<D> along_row = line_below(d, hn::Mul(theta, scale), hn::Set(d, columns_));
    const Line<D> along_column = line_below(d, hn::Mul(phi, scale), hn::Set(d, rows_));
    const auto entry = first_entry(d, along_column.below, along_row.below, stride_);
    return {entry, along_row.share, along_column.share};
  }

  template <class D>
  HWY_INLINE hn::Vec<D> gap(D d, const Point<D>& p, const Place<D>& /*place*/, hn::Vec<D> r) const {
    return radial_gap(d, p, r);
  }

 private:
  T rows_;
  T columns_;
  std::size_t stride_;
  T cells_a_radian_;
};

void scan_rsid_float(const PackedTable<Rsid, float>& table, const RawScan<float>& scan) {
  scan_lanes(RsidLanes<float>(table), raw_table(table), scan);
}
void scan_rsid_uint16(const PackedTable<Rsid, std::uint16_t>& table, const RawScan<float>& scan) {
  scan_lanes(RsidLanes<float>(table), raw_table(table), scan);
}
#if !defined(__wasm__)  // whose vectors hold no doubles in Highway 1.0
void scan_rsid_double(const PackedTable<Rsid, double>& table, const RawScan<double>& scan) {
  scan_lanes(RsidLanes<double>(table), raw_table(table), scan);
}
#endif

}  // namespace
}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace impinge {
namespace {

HWY_EXPORT(scan_rsid_float);
HWY_EXPORT(scan_rsid_uint16);
#if !defined(__wasm__)
HWY_EXPORT(scan_rsid_double);
#endif

}  // namespace

void scan_gaps(const PackedTable<Rsid, float>& table, const PackedVertices<float>& vertices, const Pose& pose,
               Surface scanned, std::span<float> gap) {
  HWY_DYNAMIC_DISPATCH(scan_rsid_float)(table, raw_scan(vertices, pose, scanned, gap));
}

void scan_gaps(const PackedTable<Rsid, std::uint16_t>& table, const PackedVertices<float>& vertices,
               const Pose& pose, Surface scanned, std::span<float> gap) {
  HWY_DYNAMIC_DISPATCH(scan_rsid_uint16)(table, raw_scan(vertices, pose, scanned, gap));
}

#if !defined(__wasm__)
void scan_gaps(const PackedTable<Rsid, double>& table, const PackedVertices<double>& vertices,
               const Pose& pose, Surface scanned, std::span<double> gap) {
  HWY_DYNAMIC_DISPATCH(scan_rsid_double)(table, raw_scan(vertices, pose, scanned, gap));
}
#endif

}  // namespace impinge
#endif
