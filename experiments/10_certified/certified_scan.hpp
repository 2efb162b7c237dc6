// SPDX-License-Identifier: GPL-3.0-or-later
// The two scans with a certificate: every vertex is `clear`, `impinged` or `undecided`, and the first two
// are proven.
//
//   ball vertex x against the socket:    gap in [low - |x|, high - |x|]
//   socket vertex x against the ball:    gap in [|x| - high, |x| - low]
//
// with [low, high] the range of the surface about the direction of x (range_table.hpp). A vertex is clear if
// the interval is above zero or there is no surface in its direction, which is never a hit; impinged if the
// interval is at or below zero and there surely is a surface; undecided otherwise. So a rim next to a vertex
// cannot make it impinged, but it does not keep it from being clear. Undecided vertices are resolved exactly,
// on demand, by the few faces near them (gap/exact_side.hpp).
//
// The ranges hold all layers of a surface and exceed it by kRangeSlack, which covers the rounding of |x|.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>

#include "10_certified/range_table.hpp"
#include "gap/certified_gap.hpp"
#include "gap/exact_side.hpp"

namespace impinge::lab {

/// Of a vertex of that surface, at x in the frame of the other one. The centre itself, which has no
/// direction, is undecided.
template <SamplingScheme S>
CertifiedGap certified_gap(Surface of, const RangeTable<S>& met, const Vec3& x) {
  const double length = x.norm();
  if (length == 0.0) {
    const RadiusRange any = signed_gap(of, {0.0, std::numeric_limits<double>::infinity()}, 0.0);
    return {any.low, any.high, Cover::part, Verdict::undecided};
  }
  const auto [range, cover] = met.at(x);
  const RadiusRange gap = signed_gap(of, range, length);
  return certified(gap.low, gap.high, cover);
}

/// Vertices of that surface (in its own frame, mm) against the ranges of the other one.
template <SamplingScheme S>
void certify(Surface of, const RangeTable<S>& met, std::span<const Vec3> vertices, const Pose& pose,
             std::span<CertifiedGap> gaps) {
  assert(gaps.size() == vertices.size());
  for (std::size_t i = 0; i < gaps.size(); ++i)
    gaps[i] = certified_gap(of, met, to_other(of, pose, vertices[i]));
}

/// Gives every undecided vertex of that surface its exact verdict against the other's faces; intervals stay.
/// Returns how many there were.
inline std::size_t resolve(Surface of, const NearFaces& met, std::span<const Vec3> vertices, const Pose& pose,
                           std::span<CertifiedGap> gaps) {
  std::size_t resolved = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i].verdict != Verdict::undecided) continue;
    const bool impinged = exactly_impinged(of, met, to_other(of, pose, vertices[i]));
    gaps[i].verdict = impinged ? Verdict::impinged : Verdict::clear;
    ++resolved;
  }
  return resolved;
}

}  // namespace impinge::lab
