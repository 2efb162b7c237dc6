// SPDX-License-Identifier: GPL-3.0-or-later
// What is proven about vertices: clear, impinged, or neither.
#pragma once

#include <cstddef>

#include "table/face_cap.hpp"

namespace impinge {

/// What is proven about a vertex, or a pose: clear, impinged, or neither.
enum class Verdict { clear, impinged, undecided };

/// An interval that surely holds the gap of a vertex, if it has one. The other surface may be missing unless
/// the cover is `whole`; if it is `none` the interval is empty (low > high).
struct CertifiedGap {
  double low = 0.0;                  // mm, the least that the gap can be
  double high = 0.0;                 // mm, the most that it can be
  Cover cover = Cover::none;         // whether there is a surface in the direction of the vertex
  Verdict verdict = Verdict::clear;  // verdict_of() these three
};

/// The verdict that the ends of a gap and the cover prove.
inline Verdict verdict_of(double low, double high, Cover cover) {
  if (cover == Cover::none || low > 0.0) return Verdict::clear;
  return cover == Cover::whole && high <= 0.0 ? Verdict::impinged : Verdict::undecided;
}

/// These ends of a gap, with their verdict.
inline CertifiedGap certified(double low, double high, Cover cover) {
  return {low, high, cover, verdict_of(low, high, cover)};
}

/// How many vertices have each verdict.
struct VerdictCount {
  std::size_t clear = 0;      // proven to have no gap of 0 or less
  std::size_t impinged = 0;   // proven to have such a gap
  std::size_t undecided = 0;  // neither

  /// Counts one more vertex.
  void add(Verdict verdict) {
    ++(verdict == Verdict::clear ? clear : verdict == Verdict::impinged ? impinged : undecided);
  }

  /// Adds the counts of another scan.
  VerdictCount& operator+=(const VerdictCount& other) {
    clear += other.clear;
    impinged += other.impinged;
    undecided += other.undecided;
    return *this;
  }

  /// The verdict of the pose: impinged if one vertex is, clear if all are.
  Verdict pose() const {
    if (impinged > 0) return Verdict::impinged;
    return undecided > 0 ? Verdict::undecided : Verdict::clear;
  }
};

}  // namespace impinge
