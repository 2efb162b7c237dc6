// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/gap_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gap/simd/scan_usid.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "gap/simd/helix-inl.hpp"
#include "gap/simd/scan-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace {

void scan_usid_float(const PackedTable<Usid, float>& table, const RawScan<double>& scan) {
  scan_lanes(HelixLanes(table), raw_table(table), scan);
}
void scan_usid_uint16(const PackedTable<Usid, std::uint16_t>& table, const RawScan<double>& scan) {
  scan_lanes(HelixLanes(table), raw_table(table), scan);
}
void scan_usid_double(const PackedTable<Usid, double>& table, const RawScan<double>& scan) {
  scan_lanes(HelixLanes(table), raw_table(table), scan);
}

}  // namespace
}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace impinge {
namespace {

HWY_EXPORT(scan_usid_float);
HWY_EXPORT(scan_usid_uint16);
HWY_EXPORT(scan_usid_double);

}  // namespace

void scan_gaps(const PackedTable<Usid, float>& table, const PackedVertices<double>& vertices,
               const Pose& pose, Surface scanned, std::span<double> gap) {
  HWY_DYNAMIC_DISPATCH(scan_usid_float)(table, raw_scan(vertices, pose, scanned, gap));
}

void scan_gaps(const PackedTable<Usid, std::uint16_t>& table, const PackedVertices<double>& vertices,
               const Pose& pose, Surface scanned, std::span<double> gap) {
  HWY_DYNAMIC_DISPATCH(scan_usid_uint16)(table, raw_scan(vertices, pose, scanned, gap));
}

void scan_gaps(const PackedTable<Usid, double>& table, const PackedVertices<double>& vertices,
               const Pose& pose, Surface scanned, std::span<double> gap) {
  HWY_DYNAMIC_DISPATCH(scan_usid_double)(table, raw_scan(vertices, pose, scanned, gap));
}

}  // namespace impinge
#endif
