// SPDX-License-Identifier: GPL-3.0-or-later
// Radiographic inclination and anteversion of a socket (Murray 1993, "The definition and measurement of
// acetabular orientation", J Bone Joint Surg Br 75-B), in the joint frame (hip/anatomy.hpp).
#pragma once

#include "hip/anatomy.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// Degrees. The axis points out of the opening.
struct CupAngles {
  double inclination_deg = 0.0;  // from straight down to the axis projected on the coronal plane; lateral +
  double anteversion_deg = 0.0;  // from the coronal plane to the axis; forward +
};

/// The angles of an opening axis (unit vector).
CupAngles cup_angles(const Vec3& opening, Side side);

/// Rotation that gives these angles to a socket that opens straight down: first by the anteversion about the
/// transverse axis, then by the inclination about the anterior axis.
Eigen::Matrix3d cup_rotation(const CupAngles& angles, Side side);

/// Rotation of the pelvis about the transverse axis, degrees: positive tilts it backwards, which opens the
/// socket forward.
Eigen::Matrix3d pelvic_tilt(double backwards_deg);

}  // namespace impinge
