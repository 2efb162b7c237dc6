// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The two scans with a certificate: every vertex is `clear`, `impinged` or `undecided`, and the first two
/// are proven.
///
///   ball vertex x against the socket:    gap in [low - |x|, high - |x|]
///   socket vertex x against the ball:    gap in [|x| - high, |x| - low]
///
/// with [low, high] the range of the surface about the direction of x (table/cell_range.hpp). A vertex is
/// clear if the interval is above zero or there is no surface in its direction, which is never a hit;
/// impinged if the interval is at or below zero and there surely is a surface; undecided otherwise. So a rim
/// next to a vertex cannot make it impinged, but it does not keep it from being clear. Undecided vertices are
/// resolved exactly, on demand, by the few faces near them (gap/exact_side.hpp).
///
/// The ranges hold all layers of a surface and exceed it by kRangeSlack, which covers the rounding of |x|.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>

#include "gap/exact_side.hpp"
#include "table/cell_range.hpp"

namespace impinge {

/// What is proven about a vertex, or a pose: clear, impinged, or neither.
enum class Verdict { clear, impinged, undecided };

/// low and high in mm, of the gap if there is one: a surface may be missing unless the cover is `whole`, and
/// the interval is empty (low > high) where it is `none`.
struct CertifiedGap {
  double low = 0.0;                  // the least that the gap can be
  double high = 0.0;                 // the most that it can be
  Cover cover = Cover::none;         // whether there is a surface in the vertex' direction
  Verdict verdict = Verdict::clear;  // follows from the three
};

/// What the ends of a gap and the cover prove.
inline Verdict verdict_of(double low, double high, Cover cover) {
  if (cover == Cover::none || low > 0.0) return Verdict::clear;
  return cover == Cover::whole && high <= 0.0 ? Verdict::impinged : Verdict::undecided;
}

/// These ends of a gap, with their verdict.
inline CertifiedGap certified(double low, double high, Cover cover) {
  return {low, high, cover, verdict_of(low, high, cover)};
}

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

/// How many vertices have each verdict.
struct VerdictCount {
  std::size_t clear = 0;      // proven to have no gap of 0 or less
  std::size_t impinged = 0;   // proven to have one
  std::size_t undecided = 0;  // neither

  /// One more.
  void add(Verdict verdict) {
    ++(verdict == Verdict::clear ? clear : verdict == Verdict::impinged ? impinged : undecided);
  }

  /// Adds those of another scan.
  VerdictCount& operator+=(const VerdictCount& other) {
    clear += other.clear;
    impinged += other.impinged;
    undecided += other.undecided;
    return *this;
  }

  /// Of all of them together: one impinged vertex is enough, all must be clear.
  Verdict pose() const {
    if (impinged > 0) return Verdict::impinged;
    return undecided > 0 ? Verdict::undecided : Verdict::clear;
  }
};

VerdictCount count_verdicts(std::span<const CertifiedGap> gaps);  // of the vertices of one scan

/// Gives every undecided vertex of that surface its exact verdict against the other's mesh; intervals stay.
/// Returns how many there were.
std::size_t resolve(Surface of, const TriangleMesh& met, const FaceIndex& index,
                    std::span<const Vec3> vertices, const Pose& pose, std::span<CertifiedGap> gaps);

}  // namespace impinge
