// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of the femur in anatomical terms.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include <Eigen/Core>

#include "files/fields.hpp"
#include "hip/anatomy.hpp"

namespace impinge {

/// Angles in degrees, zero in the pose of the scan.
struct Motion {
  double flexion = 0.0;            // of the femur forward; extension is negative
  double abduction = 0.0;          // of the femur away from the midline; adduction is negative
  double internal_rotation = 0.0;  // of the femur's front towards the midline; external rotation is negative

  static constexpr std::tuple fields{
      Field{"flexion", "deg", "of the femur forward; extension is negative", &Motion::flexion},
      Field{"abduction", "deg", "away from the midline; adduction is negative", &Motion::abduction},
      Field{"internal_rotation", "deg", "of the front towards the midline; external is negative",
            &Motion::internal_rotation}};
};
/// The pose that all angles are counted from.
inline bool is_rest(const Motion& pose) {
  return pose.flexion == 0.0 && pose.abduction == 0.0 && pose.internal_rotation == 0.0;
}

/// One of the six motions: an angle of Motion, and which way it counts.
struct MotionName {
  std::string_view name;  // as options and files have it
  double Motion::*angle;  // the member that it changes
  double sign;            // +1 or -1
};

/// flexion, extension, abduction, adduction, internal_rotation, external_rotation.
std::span<const MotionName> motion_names();

/// The motion of that name. Throws std::invalid_argument, one line with all names, for any other.
const MotionName& motion_name(std::string_view name);

/// Reads "flexion=90,internal_rotation=10", or "90,0,10" for flexion, abduction and internal rotation: names
/// of motion_names(), degrees from -180 to 180, each of the three axes at most once. Throws
/// std::invalid_argument, one line, for anything else.
Motion parse_motion(std::string_view text);

/// Rotation of the ball in the joint frame. The axes follow the joint coordinate system for the hip (Grood
/// and Suntay 1983, Wu et al. 2002): flexion about the transverse axis of the pelvis, rotation about the long
/// axis of the femur, abduction about the axis between, so R = R_flexion R_abduction R_rotation. Abduction
/// and rotation turn opposite ways on the two sides; without a side both must be 0. Throws
/// std::invalid_argument if they are not.
Eigen::Matrix3d joint_rotation(const Motion& motion, std::optional<Side> side);

/// Angles of a humerus, degrees, after Wu et al. 2005 (ISB recommendation for the shoulder,
/// doi:10.1016/j.jbiomech.2004.05.042).
struct ShoulderAngles {
  double plane_of_elevation = 0.0;  // 0 in abduction, 90 in forward flexion
  double elevation = 0.0;           // from hanging down; Wu et al. count it negative
  double axial_rotation = 0.0;      // internal rotation is positive
};

/// Rotation of the ball in the joint frame, R = R_Y(plane) R_X(-elevation) R_Y(axial). X, Y and Z are the
/// axes of Wu et al. (anterior, superior, right), our y, z and x. Mirrored on the left side.
Eigen::Matrix3d shoulder_rotation(const ShoulderAngles& angles, Side side);

/// Rotation of the ball while one angle grows and the others stay: R(a) = outer R(axis, a) inner, a in
/// radians, R(0) = joint_rotation(start).
struct JointTurn {
  /// Rotation by the angles that are applied after the growing one.
  Eigen::Matrix3d outer = Eigen::Matrix3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  // unit vector
  /// Rotation by the growing angle's start value and the angles that are applied before it.
  Eigen::Matrix3d inner = Eigen::Matrix3d::Identity();
  /// Rotation that the ball's mesh has from its scan, by landmarks of the femur. It matters to other centres
  /// alone, about which it would have shifted the ball.
  Eigen::Matrix3d rest = Eigen::Matrix3d::Identity();
};
/// The turn that begins at `start`. Throws std::invalid_argument as joint_rotation() does.
JointTurn joint_turn(const Motion& start, const MotionName& growing, std::optional<Side> side);

/// Largest size of each angle of a motion, degrees from the pose of the scan.
inline constexpr double kLargestAngle = 180.0;

/// How far an angle may grow from `start` until its size is kLargestAngle, degrees. Throws
/// std::invalid_argument if nothing is left.
double largest_growth(const Motion& start, const MotionName& growing);

/// Motions from one to another in equal steps, both ends included: as few steps as possible, none of which
/// changes an angle by more than step_deg (above 0).
std::vector<Motion> motion_path(const Motion& from, const Motion& to, double step_deg);

}  // namespace impinge
