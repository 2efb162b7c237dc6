// SPDX-License-Identifier: GPL-3.0-or-later
// A scan as it is handed over to the code of an instruction set: pointers and numbers alone.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>

#include "kernels/gap_kernels.hpp"

namespace impinge {

/// Memory of the vertices and the gaps, and how the vertices are moved.
template <class Real>
struct RawScan {
  const Real* x;  // of the vertices, `count` each, mm
  const Real* y;
  const Real* z;
  std::size_t count;                // of vertices
  PackedTransform<Real> transform;  // to the frame of the table
  Real sign;                        // gap_sign()
  Real* gap;                        // mm, `count` of them
};

/// Borrows from both; gap has the size of the vertices.
template <class Real>
RawScan<Real> raw_scan(const PackedScan<Real>& scan, std::span<Real> gap) {
  assert(gap.size() == scan.vertices.size());
  return {scan.vertices.x.data(),
          scan.vertices.y.data(),
          scan.vertices.z.data(),
          scan.vertices.size(),
          packed_transform<Real>(scan.pose, scan.scanned),
          gap_sign<Real>(scan.scanned),
          gap.data()};
}

}  // namespace impinge
