// SPDX-License-Identifier: GPL-3.0-or-later
// The radii, in the frame of the ball, that the bone of the socket sweeps through during required motions,
// with a clearance c along each ray: along u the union of [S_in - c, S_out + c](R u) over the poses R, bone
// being from S_in to S_out.
//
// Over a cap of directions. For every part of a leg, with R and rho its cap of poses, nothing is swept but
// what may be bone over the cap of rho + angle about R axis; and what is bone in the pose R alone along every
// ray of the cap of `angle` is swept. A part is halved until it is narrower than the cap itself, or the
// second holds the first already. Theorem 18 (sweep).
#pragma once

#include <vector>

#include "change/required_motion.hpp"
#include "rotations/bone_over_cap.hpp"

namespace impinge {

class SweptBone {
 public:
  /// socket in the joint frame about the centre, closed, mm; clearance_mm is c. Throws as BoneOverCap.
  SweptBone(const TriangleMesh& socket, std::vector<RequiredLeg> legs, double clearance_mm);

  /// Radii that are swept up to `farthest`, mm.
  SpansOverCap over(const DirectionCap& cap, double farthest) const;

 private:
  BoneOverCap bone_;
  std::vector<RequiredLeg> legs_;
  double clearance_;
};

}  // namespace impinge
