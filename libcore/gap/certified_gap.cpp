// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/certified_gap.hpp"

namespace impinge {
namespace {

template <class Impinged>
std::size_t resolve(std::span<CertifiedGap> gaps, const Impinged& impinged) {
  std::size_t resolved = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i].verdict != Verdict::undecided) continue;
    gaps[i].verdict = impinged(i) ? Verdict::impinged : Verdict::clear;
    ++resolved;
  }
  return resolved;
}

}  // namespace

VerdictCount count_verdicts(std::span<const CertifiedGap> gaps) {
  VerdictCount count;
  for (const CertifiedGap& gap : gaps) {
    count.clear += gap.verdict == Verdict::clear ? 1U : 0U;
    count.impinged += gap.verdict == Verdict::impinged ? 1U : 0U;
    count.undecided += gap.verdict == Verdict::undecided ? 1U : 0U;
  }
  return count;
}

std::size_t resolve_ball(const TriangleMesh& socket, const FaceIndex& index, std::span<const Vec3> vertices,
                         const Pose& pose, std::span<CertifiedGap> gaps) {
  return resolve(gaps,
                 [&](std::size_t i) { return on_or_beyond(socket, index, to_socket(pose, vertices[i])); });
}

std::size_t resolve_socket(const TriangleMesh& ball, const FaceIndex& index, std::span<const Vec3> vertices,
                           const Pose& pose, std::span<CertifiedGap> gaps) {
  return resolve(gaps, [&](std::size_t i) { return on_or_within(ball, index, to_ball(pose, vertices[i])); });
}

}  // namespace impinge
