// SPDX-License-Identifier: GPL-3.0-or-later
// Tests a vertex against the faces of its cell (exact_cells.hpp). Included once for each instruction set,
// hence no #pragma once.
#if defined(IMPINGE_EXACT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_EXACT_INL
#undef IMPINGE_EXACT_INL
#else
#define IMPINGE_EXACT_INL
#endif

#include <array>
#include <limits>

#include <hwy/highway.h>

#include "gap/simd/cube-inl.hpp"
#include "gap/simd/exact_cells.hpp"
#include "gap/simd/scan-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {

// Stands for no face; hn::MaxOfLanes() never gives less where lanes are emulated.
inline constexpr float kNoFace = std::numeric_limits<float>::lowest();

// How many vertices are worked on together: moved, then looked up one by one, then turned into gaps. As many
// as a word has bits.
inline constexpr std::size_t kChunk = 64;
inline constexpr std::size_t kPlanes = ExactCell::kPlanes;

struct Chunk {
  HWY_ALIGN float x[kChunk];
  HWY_ALIGN float y[kChunk];
  HWY_ALIGN float z[kChunk];
  HWY_ALIGN float size[kChunk];
  HWY_ALIGN float s[kPlanes * kChunk];  // of the planes of a smooth cell, or of the face that is met
  HWY_ALIGN float gap[kChunk];
  HWY_ALIGN std::int32_t cell[kChunk];
  std::size_t others[kChunk];  // vertices in cells that need more memory
  std::size_t wide[kChunk];    // of these, the vertices in smooth cells
  std::size_t rough[kChunk];   // of these, the vertices in other cells
  std::size_t doubt[kChunk];
};

template <class D>
HWY_INLINE hn::Vec<D> along(D d, const float* x, const float* y, const float* z, const Point<D>& p) {
  const auto xy = hn::Add(hn::Mul(hn::LoadU(d, x), p.x), hn::Mul(hn::LoadU(d, y), p.y));
  return hn::Add(xy, hn::Mul(hn::LoadU(d, z), p.z));
}

template <class D>
HWY_INLINE Point<D> vertex(D d, const Chunk& chunk, std::size_t i) {
  return {hn::Set(d, chunk.x[i]), hn::Set(d, chunk.y[i]), hn::Set(d, chunk.z[i])};
}

HWY_INLINE void look_up(const ExactCell& cell, std::size_t i, Chunk& chunk) {
  const hn::CappedTag<float, kPlanes> d;
  const auto p = vertex(d, chunk, i);
  const auto& [x, y, z] = cell.plane;
  for (std::size_t k = 0; k < kPlanes; k += hn::Lanes(d))
    hn::Store(along(d, &x[k], &y[k], &z[k], p), d, chunk.s + kPlanes * i + k);
}

// For each of the first four planes the larger s of it and of the plane four places on.
HWY_INLINE void look_up(const WidePlanes& planes, std::size_t i, Chunk& chunk) {
  const hn::CappedTag<float, kPlanes> d;
  const auto p = vertex(d, chunk, i);
  const auto& [x, y, z] = planes.plane;
  for (std::size_t k = 0; k < kPlanes; k += hn::Lanes(d)) {
    const auto s = along(d, &x[k], &y[k], &z[k], p);
    const auto other = along(d, &x[k + kPlanes], &y[k + kPlanes], &z[k + kPlanes], p);
    hn::Store(hn::Max(s, other), d, chunk.s + kPlanes * i + k);
  }
}

// Tests all faces of a cell that is not smooth. Returns whether the vertex is in doubt.
HWY_INLINE bool look_up_blocks(const ExactCells& cells, const ExactCell& cell, std::size_t i, Chunk& chunk) {
  const hn::CappedTag<float, FaceBlock::kFaces> d;
  const auto p = vertex(d, chunk, i);
  const auto doubtful = hn::Set(d, 5.0F * 0x1p-24F * chunk.size[i]);
  const auto none = hn::Set(d, kNoFace);
  auto best = none;
  auto closest = hn::Neg(none);     // least distance to the plane of an edge
  auto least_size = hn::Neg(none);  // least |s| of the faces that are met; 0 for one that is too steep
  for (std::uint32_t at = 0; at < cell.count; ++at) {
    const FaceBlock& block = cells.blocks[cell.first - 1 + at];
    const auto row = [&](const std::array<FaceBlock::Row, 3>& rows, std::size_t k)
                         HWY_ATTR { return along(d, &rows[0][k], &rows[1][k], &rows[2][k], p); };
    for (std::size_t k = 0; k < FaceBlock::kFaces; k += hn::Lanes(d)) {
      const auto least =
          hn::Min(row(block.edge[0], k), hn::Min(row(block.edge[1], k), row(block.edge[2], k)));
      const auto s = hn::IfThenElse(hn::Gt(least, doubtful), row(block.plane, k), none);
      closest = hn::Min(closest, hn::Abs(least));
      least_size = hn::Min(least_size, hn::Abs(s));
      best = hn::Max(best, s);
    }
  }
  const float hit = hn::GetLane(hn::MaxOfLanes(d, best));
  for (std::size_t k = 0; k < kPlanes; ++k) chunk.s[kPlanes * i + k] = hit;
  return !hn::AllFalse(d, hn::Or(hn::Le(closest, doubtful), hn::Eq(least_size, hn::Zero(d))));
}

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
