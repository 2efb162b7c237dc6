// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>

#include "gap/simd/exact_cells.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gap/simd/scan_exact.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "gap/simd/exact-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace {

class ExactScan {
 public:
  ExactScan(const ExactCells& cells, const RawScan<float>& scan) : cells_(cells), scan_(scan), cube_(cells) {}

  void run() const {
    Chunk chunk{};
    for (std::size_t begin = 0; begin < scan_.count; begin += kChunk) {
      const std::size_t count = std::min(kChunk, scan_.count - begin);
      load(begin, count, chunk);
      const std::uint64_t met = move(count, chunk);
      if (met == 0) {
        std::fill_n(scan_.gap + begin, count, std::numeric_limits<float>::quiet_NaN());
        continue;
      }
      const std::size_t doubtful = look_up_all(met, chunk);
      finish(count, met, chunk);
      for (std::size_t j = 0; j < doubtful; ++j) answer_exactly(chunk.doubt[j], chunk);
      std::memcpy(scan_.gap + begin, chunk.gap, count * sizeof(float));
    }
  }

 private:
  using D = hn::ScalableTag<float>;

  // Loads a chunk. The last one is filled up with points at the centre.
  void load(std::size_t begin, std::size_t count, Chunk& chunk) const {
    std::memcpy(chunk.x, scan_.x + begin, count * sizeof(float));
    std::memcpy(chunk.y, scan_.y + begin, count * sizeof(float));
    std::memcpy(chunk.z, scan_.z + begin, count * sizeof(float));
    for (std::size_t i = count; i < kChunk; ++i) chunk.x[i] = chunk.y[i] = chunk.z[i] = 0.0F;
  }

  // Moves the vertices. Returns a bit for each that comes into a cell in which a face may be met; the others
  // have no gap.
  HWY_ATTR std::uint64_t move(std::size_t count, Chunk& chunk) const {
    const D d;
    const std::uint32_t* const none = cells_.none.data();
    std::uint64_t missed = 0;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
      const Point<D> v{hn::Load(d, chunk.x + i), hn::Load(d, chunk.y + i), hn::Load(d, chunk.z + i)};
      const Point<D> p = transformed(d, scan_.transform, v);
      const auto entry = cube_.place(d, p).entry;
      hn::Store(p.x, d, chunk.x + i);
      hn::Store(p.y, d, chunk.y + i);
      hn::Store(p.z, d, chunk.z + i);
      hn::Store(length(p), d, chunk.size + i);
      hn::Store(entry, Whole<D>(), chunk.cell + i);
      std::uint64_t bits = 0;  // little-endian, as all instruction sets of vectors here are
      hn::StoreMaskBits(d, has_none(d, none, entry), reinterpret_cast<std::uint8_t*>(&bits));
      missed |= bits << i;
    }
    return ~missed & (kAll >> (kChunk - count));
  }

  // Looks up the vertices; returns how many are in doubt. Only cells that need more memory take a branch of
  // their own.
  HWY_ATTR std::size_t look_up_all(std::uint64_t met, Chunk& chunk) const {
    std::size_t others = 0;
    const auto visit = [&](std::size_t i) HWY_ATTR {
      const ExactCell& cell = cell_of(i, chunk);
      look_up(cell, i, chunk);
      chunk.others[others] = i;
      others += cell.first > 0 ? 1U : 0U;
    };
    if (met == kAll) {  // the usual case of a closed surface, by the shorter loop
      for (std::size_t i = 0; i < kChunk; ++i) hwy::Prefetch(&cell_of(i, chunk));
      for (std::size_t i = 0; i < kChunk; ++i) visit(i);
    } else {
      for (std::uint64_t left = met; left != 0; left &= left - 1)
        hwy::Prefetch(&cell_of(first_of(left), chunk));
      for (std::uint64_t left = met; left != 0; left &= left - 1) visit(first_of(left));
    }
    std::size_t wide = 0;
    std::size_t rough = 0;
    for (std::size_t j = 0; j < others; ++j) {
      const std::size_t i = chunk.others[j];
      const ExactCell& cell = cell_of(i, chunk);
      cell.count > 0 ? prefetch(cells_.blocks[cell.first - 1]) : prefetch(cells_.wide[cell.first - 1]);
      chunk.wide[wide] = i;
      wide += cell.count > 0 ? 0U : 1U;
      chunk.rough[rough] = i;
      rough += cell.count > 0 ? 1U : 0U;
    }
    for (std::size_t j = 0; j < wide; ++j) {
      const std::size_t i = chunk.wide[j];
      look_up(cells_.wide[cell_of(i, chunk).first - 1], i, chunk);
    }
    std::size_t doubtful = 0;
    for (std::size_t j = 0; j < rough; ++j) {
      const std::size_t i = chunk.rough[j];
      chunk.doubt[doubtful] = i;
      doubtful += look_up_blocks(cells_, cell_of(i, chunk), i, chunk) ? 1U : 0U;
    }
    return doubtful;
  }

  template <class T>
  static void prefetch(const T& what) {
    const auto* const bytes = reinterpret_cast<const char*>(&what);
    for (std::size_t line = 0; line < sizeof(T); line += 64) hwy::Prefetch(bytes + line);
  }

  static constexpr std::uint64_t kAll = ~std::uint64_t{0};  // vertices of a chunk
  static std::size_t first_of(std::uint64_t bits) { return static_cast<std::size_t>(std::countr_zero(bits)); }
  const ExactCell& cell_of(std::size_t i, const Chunk& chunk) const {
    return cells_.cells[static_cast<std::size_t>(chunk.cell[i])];
  }

  HWY_ATTR void finish(std::size_t count, std::uint64_t met, Chunk& chunk) const {
    const D d;
    const auto one = hn::Set(d, 1.0F);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
      hn::Vec<D> s0, s1, s2, s3;
      hn::LoadInterleaved4(d, chunk.s + kPlanes * i, s0, s1, s2, s3);
      const auto best = hn::Max(hn::Max(s0, s1), hn::Max(s2, s3));
      const auto s = hn::Abs(best);  // s of a face that is met is above 0
      const auto size = hn::Load(d, chunk.size + i);
      const auto gap = hn::Mul(hn::Mul(hn::Set(d, scan_.sign), size), hn::Div(hn::Sub(one, s), s));
      const std::uint64_t bits = met >> i;
      const auto looked_up = hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bits));
      const auto hit = hn::And(hn::Gt(best, hn::Set(d, kNoFace)), hn::Gt(size, hn::Zero(d)));
      hn::Store(hn::IfThenElse(hn::And(looked_up, hit), gap, no_gap(d)), d, chunk.gap + i);
    }
  }

  void answer_exactly(std::size_t i, Chunk& chunk) const {
    if (chunk.size[i] > 0.0F) chunk.gap[i] = in_doubt(i, chunk);
  }

  float in_doubt(std::size_t i, const Chunk& chunk) const {
    const Vec3 x(chunk.x[i], chunk.y[i], chunk.z[i]);
    const Surface scanned = scan_.sign > 0.0F ? Surface::ball : Surface::socket;
    return static_cast<float>(exact_gap(cells_, static_cast<std::size_t>(chunk.cell[i]), x, scanned));
  }

  const ExactCells& cells_;
  const RawScan<float>& scan_;
  CubeLanes cube_;
};

void scan_exact(const ExactCells& cells, const RawScan<float>& scan) { ExactScan(cells, scan).run(); }

}  // namespace
}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace impinge {
namespace {

HWY_EXPORT(scan_exact);

}  // namespace

void scan_gaps(const ExactCells& cells, const PackedVertices<float>& vertices, const Pose& pose,
               Surface scanned, std::span<float> gap) {
  HWY_DYNAMIC_DISPATCH(scan_exact)(cells, raw_scan(vertices, pose, scanned, gap));
}

}  // namespace impinge
#endif
