// SPDX-License-Identifier: GPL-3.0-or-later
// A scan in the form that the code of an instruction set takes: pointers and numbers alone.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>

#include "gap/simd/gap_kernels.hpp"

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

/// Borrows the memory of vertices and gaps, which have one size.
template <class Real>
RawScan<Real> raw_scan(const PackedVertices<Real>& vertices, const Pose& pose, Surface scanned,
                       std::span<Real> gap) {
  assert(gap.size() == vertices.size());
  return {vertices.x.data(),
          vertices.y.data(),
          vertices.z.data(),
          vertices.size(),
          packed_transform<Real>(pose, scanned),
          gap_sign<Real>(scanned),
          gap.data()};
}

}  // namespace impinge
