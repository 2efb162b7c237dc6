// SPDX-License-Identifier: GPL-3.0-or-later
// A scan as it is handed over to the code of an instruction set: pointers and numbers alone.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>

#include "kernels/gap_kernels.hpp"

namespace impinge {

template <class Real>
struct RawScan {
  const Real* x;
  const Real* y;
  const Real* z;
  std::size_t count;
  LaneTransform<Real> transform;
  Real sign;  // gap = sign (radius - length)
  Real* gap;
};

template <class Real>
RawScan<Real> raw_scan(const LaneScan<Real>& scan, std::span<Real> gap) {
  assert(gap.size() == scan.vertices.size());
  return {scan.vertices.x.data(),
          scan.vertices.y.data(),
          scan.vertices.z.data(),
          scan.vertices.size(),
          lane_transform<Real>(scan.pose, scan.scan),
          scan.scan == Scan::ball ? Real{1} : Real{-1},
          gap.data()};
}

}  // namespace impinge
