// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/certified_table.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gap/simd/scan_certified.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "gap/simd/cube-inl.hpp"
#include "gap/simd/scan-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace {

// The gaps of the table; puts the vertices that it does not decide into `undecided`, which has room for all
// of them and a vector more, and returns how many there are.
std::size_t decide(const CertifiedTable& table, const RawScan<float>& scan, float threshold,
                   std::uint32_t* undecided) {
  using D = hn::ScalableTag<float>;
  const D d;
  const Bits<D> bits;
  const CubeLanes cube(table.table);
  const auto raw = raw_table(table.table);
  const std::uint32_t* const open = table.open.data();
  const auto bound = hn::Set(d, static_cast<float>(table.bound_mm));
  const auto a_mm = hn::Set(d, 28.0F * 0x1p-24F);
  const PackedTransform<float> transform = scan.transform;
  const float sign = scan.sign;
  std::size_t count = 0;
  for_each_vector(scan, [&](const Point<D>& v, std::size_t i) HWY_ATTR {
    const Point<D> p = transformed(d, transform, v);
    const auto gap = gaps(d, cube, raw, sign, p);
    const auto off = hn::Abs(hn::Sub(gap, hn::Set(d, threshold)));
    const auto near = hn::Le(off, hn::Add(bound, hn::Mul(a_mm, length(p))));
    const auto sent = hn::Or(near, has_none(d, open, cube.place(d, p).entry));
    if (hn::AllFalse(d, sent)) return gap;
    const auto vertex = hn::Iota(bits, static_cast<std::uint32_t>(i));
    count += hn::CompressStore(vertex, hn::RebindMask(bits, sent), bits, undecided + count);
    return gap;
  });
  while (count > 0 && undecided[count - 1] >= scan.count) --count;  // of those that filled up the last vector
  return count;
}

}  // namespace
}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace impinge {
namespace {

HWY_EXPORT(decide);

constexpr std::size_t kLongestVector = 64;

}  // namespace

void scan_gaps(const CertifiedTable& table, const PackedVertices<float>& vertices, const Pose& pose,
               Surface scanned, CertifiedGaps& found) {
  found.gap.resize(vertices.size());
  found.undecided.resize(vertices.size() + kLongestVector);
  found.undecided.resize(HWY_DYNAMIC_DISPATCH(decide)(table,
                                                      raw_scan(vertices, pose, scanned, std::span(found.gap)),
                                                      found.threshold, found.undecided.data()));
  PackedVertices<float>& asked = found.asked;
  for (auto* axis : {&asked.x, &asked.y, &asked.z}) axis->clear();
  for (const std::uint32_t i : found.undecided) {
    asked.x.push_back(vertices.x[i]);
    asked.y.push_back(vertices.y[i]);
    asked.z.push_back(vertices.z[i]);
  }
  found.answered.resize(asked.size());
  scan_gaps(table.exact, asked, pose, scanned, found.answered);
  for (std::size_t k = 0; k < found.answered.size(); ++k) found.gap[found.undecided[k]] = found.answered[k];
}

}  // namespace impinge
#endif
