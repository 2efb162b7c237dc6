// SPDX-License-Identifier: GPL-3.0-or-later
// Radiographic inclination and anteversion of a socket (Murray 1993, "The definition and measurement of
// acetabular orientation", J Bone Joint Surg Br 75-B), in the joint frame (hip/anatomy.hpp).
#pragma once

#include "hip/anatomy.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// Degrees. The axis points out of the opening.
struct CupAngles {
  double inclination_deg = 0.0;  // from straight down to the axis as the coronal plane sees it, laterally
  double anteversion_deg = 0.0;  // of the axis from the coronal plane, forward
};

/// Those of an axis, unit vector.
CupAngles cup_angles(const Vec3& opening, Side side);

/// Turns a socket that looks straight down to these angles: by the anteversion about the transverse axis
/// first, then by the inclination about the axis that runs forward.
Eigen::Matrix3d cup_rotation(const CupAngles& angles, Side side);

/// Turns the pelvis by that about the transverse axis, degrees: back where it is positive, which opens the
/// socket forward.
Eigen::Matrix3d pelvic_tilt(double backwards_deg);

}  // namespace impinge
