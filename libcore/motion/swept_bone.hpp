// SPDX-License-Identifier: GPL-3.0-or-later
// What the bone of the socket sweeps through, in the frame of the ball, on the way of required motions, with
// all that is within the clearance of it along its ray: along u the union of [S_in - c, S_out + c](R u) over
// the poses R.
//
// Over a cap of directions. For every part of a leg, with R and rho its cap of poses, nothing is swept but
// what may be bone over the cap of rho + angle about R axis; and what is bone in the pose R alone along every
// ray of the cap of `angle` is swept. A part is halved until it is narrower than the cap itself, or the
// second holds the first already.
#pragma once

#include <vector>

#include "motion/bone_over_cap.hpp"
#include "motion/required_motion.hpp"

namespace impinge {

class SweptBone {
 public:
  /// socket in the joint frame about the centre, closed, mm; the clearance c too.
  SweptBone(const TriangleMesh& socket, std::vector<RequiredLeg> legs, double clearance_mm);

  /// Radii that are swept up to `farthest`, mm.
  SpansOverCap over(const DirectionCap& cap, double farthest) const;

 private:
  BoneOverCap bone_;
  std::vector<RequiredLeg> legs_;
  double clearance_;
};

}  // namespace impinge
