// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/gap_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gap/simd/scan_cube.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "gap/simd/cube-inl.hpp"
#include "gap/simd/scan-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace {

void scan_float(const PackedTable<CubeGnomonic, float>& table, const RawScan<float>& scan) {
  scan_lanes(CubeLanes(table), raw_table(table), scan);
}
void scan_uint16(const PackedTable<CubeGnomonic, std::uint16_t>& table, const RawScan<float>& scan) {
  scan_lanes(CubeLanes(table), raw_table(table), scan);
}

}  // namespace
}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace impinge {
namespace {

HWY_EXPORT(scan_float);
HWY_EXPORT(scan_uint16);

}  // namespace

void scan_gaps(const PackedTable<CubeGnomonic, float>& table, const PackedVertices<float>& vertices,
               const Pose& pose, Surface scanned, std::span<float> gap) {
  HWY_DYNAMIC_DISPATCH(scan_float)(table, raw_scan(vertices, pose, scanned, gap));
}

void scan_gaps(const PackedTable<CubeGnomonic, std::uint16_t>& table, const PackedVertices<float>& vertices,
               const Pose& pose, Surface scanned, std::span<float> gap) {
  HWY_DYNAMIC_DISPATCH(scan_uint16)(table, raw_scan(vertices, pose, scanned, gap));
}

}  // namespace impinge
#endif
