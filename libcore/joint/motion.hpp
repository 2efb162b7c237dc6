// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of the femur in anatomical terms.
#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Core>

#include "joint/anatomy.hpp"

namespace impinge {

// Angles in degrees, zero in the pose of the scan.
struct Motion {
  double flexion = 0.0;            // of the femur forward; extension is negative
  double abduction = 0.0;          // of the femur away from the midline; adduction is negative
  double internal_rotation = 0.0;  // of the femur's front towards the midline; external rotation is negative
};

// Reads "flexion=90,internal_rotation=10". Names: flexion, extension, abduction, adduction,
// internal_rotation, external_rotation; an angle is given once for each of the three axes.
// std::invalid_argument, one line, otherwise.
Motion parse_motion(std::string_view text);

// Rotation of the ball in the joint frame. The axes follow the joint coordinate system for the hip (Grood and
// Suntay 1983, Wu et al. 2002): flexion about the transverse axis of the pelvis, rotation about the long axis
// of the femur, abduction about the axis between, so R = R_flexion R_abduction R_rotation. Abduction and
// rotation turn opposite ways on the two sides; without a side they must be 0, else std::invalid_argument.
Eigen::Matrix3d joint_rotation(const Motion& motion, std::optional<Side> side);

}  // namespace impinge
