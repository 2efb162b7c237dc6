// SPDX-License-Identifier: GPL-3.0-or-later
// Which radii, in the frame of the ball, does the bone of the socket sweep through during required motions?
// Bone is thickened by a clearance c at both ends of every ray. Theorem 18 (sweep).
#pragma once

#include <vector>

#include "change/required_motion.hpp"
#include "rotations/bone_over_cap.hpp"

namespace impinge {

class SweptBone {
 public:
  /// socket: closed, in the joint frame about the centre, mm; clearance_mm is c. Throws as BoneOverCap does.
  SweptBone(const TriangleMesh& socket, std::vector<RequiredLeg> legs, double clearance_mm);

  /// Radii up to `farthest` that are swept over the cap, mm: certain along every ray, possible along any. The
  /// cap is in the frame of the ball.
  SpansOverCap over(const DirectionCap& cap, double farthest) const;

 private:
  BoneOverCap bone_;
  std::vector<RequiredLeg> legs_;
  double clearance_;
};

}  // namespace impinge
