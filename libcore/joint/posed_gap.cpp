// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/posed_gap.hpp"

#include <algorithm>

#include "gap/measured_gap.hpp"

namespace impinge {

std::optional<PosedGap> posed_gap(const CulledJoint& joint, const BallSocketPair& meshes, const Pose& pose) {
  const std::optional<LeastGap> least = joint.least_gap(pose);
  if (!least) return std::nullopt;
  const Surface scanned = least->at.scanned;
  const Vec3& x = mesh_of(meshes, scanned).vertices[least->at.vertex];
  const CertifiedGap ends = measured_gap(scanned, joint.faces(other(scanned)), to_other(scanned, pose, x));
  return PosedGap{*least, std::max(ends.high - least->gap_mm, least->gap_mm - ends.low),
                  scanned == Surface::ball ? to_socket(pose, x) : x};
}

}  // namespace impinge
