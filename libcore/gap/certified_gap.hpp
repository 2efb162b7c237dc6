// SPDX-License-Identifier: GPL-3.0-or-later
// The two scans with a certificate: every vertex is `clear`, `impinged` or `undecided`, and the first two are
// proven.
//
//   ball vertex x against the socket:    gap in [low - |x|, high - |x|]
//   socket vertex x against the ball:    gap in [|x| - high, |x| - low]
//
// with [low, high] the range of the surface about the direction of x (table/cell_range.hpp). A vertex is
// clear if the interval is above zero or there is no surface in its direction, which is never a hit; impinged
// if the interval is at or below zero and there surely is a surface; undecided otherwise. So a rim next to a
// vertex cannot make it impinged, but it does not keep it from being clear. Undecided vertices are resolved
// exactly, on demand, by the few faces near them (gap/exact_side.hpp).
//
// The ranges hold all layers of a surface and exceed it by kRangeSlack, which covers the rounding of |x|.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>

#include "gap/exact_side.hpp"
#include "gap/pose.hpp"
#include "table/cell_range.hpp"

namespace impinge {

// What is proven about a vertex, or a pose: clear, impinged, or neither.
enum class Verdict { clear, impinged, undecided };

// low and high in mm, of the gap if there is one: a surface may be missing unless the cover is `whole`, and
// the interval is empty (low > high) where it is `none`.
struct CertifiedGap {
  double low = 0.0;                  // the least that the gap can be
  double high = 0.0;                 // the most that it can be
  Cover cover = Cover::none;         // whether there is a surface in the vertex' direction
  Verdict verdict = Verdict::clear;  // follows from the three
};

// What the ends of a gap and the cover prove.
inline Verdict verdict_of(double low, double high, Cover cover) {
  if (cover == Cover::none || low > 0.0) return Verdict::clear;
  return cover == Cover::whole && high <= 0.0 ? Verdict::impinged : Verdict::undecided;
}

// These ends of a gap, with their verdict.
inline CertifiedGap certified(double low, double high, Cover cover) {
  return {low, high, cover, verdict_of(low, high, cover)};
}

// Gap of a ball vertex, in the socket frame. The centre itself, which has no direction, is undecided.
template <SamplingScheme S>
CertifiedGap ball_vertex_gap(const RangeTable<S>& socket, const Vec3& x) {
  const double length = x.norm();
  if (length == 0.0) return {0.0, std::numeric_limits<double>::infinity(), Cover::part, Verdict::undecided};
  const auto [range, cover] = socket.at(x);
  return certified(range.low - length, range.high - length, cover);
}

// Gap of a socket vertex, in the ball frame.
template <SamplingScheme S>
CertifiedGap socket_vertex_gap(const RangeTable<S>& ball, const Vec3& x) {
  const double length = x.norm();
  if (length == 0.0) return {-std::numeric_limits<double>::infinity(), 0.0, Cover::part, Verdict::undecided};
  const auto [range, cover] = ball.at(x);
  return certified(length - range.high, length - range.low, cover);
}

// First scan: ball vertices (ball frame, mm) against the ranges of the socket.
template <SamplingScheme S>
void certify_ball(const RangeTable<S>& socket, std::span<const Vec3> vertices, const Pose& pose,
                  std::span<CertifiedGap> gaps) {
  assert(gaps.size() == vertices.size());
  for (std::size_t i = 0; i < gaps.size(); ++i)
    gaps[i] = ball_vertex_gap(socket, to_socket(pose, vertices[i]));
}

// Second scan: socket vertices (socket frame, mm) against the ranges of the ball.
template <SamplingScheme S>
void certify_socket(const RangeTable<S>& ball, std::span<const Vec3> vertices, const Pose& pose,
                    std::span<CertifiedGap> gaps) {
  assert(gaps.size() == vertices.size());
  for (std::size_t i = 0; i < gaps.size(); ++i) gaps[i] = socket_vertex_gap(ball, to_ball(pose, vertices[i]));
}

// How many vertices have each verdict.
struct VerdictCount {
  std::size_t clear = 0;      // proven to have no gap of 0 or less
  std::size_t impinged = 0;   // proven to have one
  std::size_t undecided = 0;  // neither

  // Adds those of another scan.
  VerdictCount& operator+=(const VerdictCount& other) {
    clear += other.clear;
    impinged += other.impinged;
    undecided += other.undecided;
    return *this;
  }

  // Of all of them together: one impinged vertex is enough, all must be clear.
  Verdict pose() const {
    if (impinged > 0) return Verdict::impinged;
    return undecided > 0 ? Verdict::undecided : Verdict::clear;
  }
};

VerdictCount count_verdicts(std::span<const CertifiedGap> gaps);  // of the vertices of one scan

// Gives every undecided vertex of the first scan (ball vertices, against the socket's mesh) its exact
// verdict; intervals stay. Returns how many there were.
std::size_t resolve_ball(const TriangleMesh& socket, const FaceIndex& index, std::span<const Vec3> vertices,
                         const Pose& pose, std::span<CertifiedGap> gaps);

// The same for the second scan (socket vertices, against the ball's mesh).
std::size_t resolve_socket(const TriangleMesh& ball, const FaceIndex& index, std::span<const Vec3> vertices,
                           const Pose& pose, std::span<CertifiedGap> gaps);

}  // namespace impinge
