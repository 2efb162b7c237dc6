// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/certified_gap.hpp"

namespace impinge {
VerdictCount count_verdicts(std::span<const CertifiedGap> gaps) {
  VerdictCount count;
  for (const CertifiedGap& gap : gaps) count.add(gap.verdict);
  return count;
}

std::size_t resolve(Surface of, const TriangleMesh& met, const FaceIndex& index,
                    std::span<const Vec3> vertices, const Pose& pose, std::span<CertifiedGap> gaps) {
  std::size_t resolved = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i].verdict != Verdict::undecided) continue;
    const bool impinged = exactly_impinged(of, met, index, to_other(of, pose, vertices[i]));
    gaps[i].verdict = impinged ? Verdict::impinged : Verdict::clear;
    ++resolved;
  }
  return resolved;
}

}  // namespace impinge
