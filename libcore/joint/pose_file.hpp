// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reads poses from a file: a CSV, or a motion of OpenSim or OpenSense.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "joint/pose_list.hpp"

namespace impinge {

/// Reads poses; the file's extension says whether it is from OpenSim. A row with an empty or NaN field is
/// kept as not tracked. Throws FileError with the number of the line.
///
/// A CSV has commas, semicolons or tabs between its words (with the latter two a decimal comma is read), with
/// or without quotes. Its header has names in any case and no number; rows that are matrices of 12 or 16
/// numbers need none. Columns `frame` and `time` are kept, `Valid_pose` is not read. The others are one of:
///   * angles and shifts of one of the first three kinds of PoseKind;
///   * qw, qx, qy, qz: a quaternion, w first. With tx, ty, tz (mm) it is x' = R x + t in the frame of the
///     meshes; without, R turns about the centre of rotation, in the axes of the meshes;
///   * 12 or 16 columns of other names: a matrix, row by row, x' = M x, in the frame of the meshes, mm;
///   * quaternions or matrices of both bones in a room, x_room = M x, named ball_qw, ..., socket_qw, ...;
///     also femur_ or humerus_, and pelvis_, acetabulum_, scapula_ or glenoid_. The pose is inverse(socket)
///     times ball; for quaternions without tx, ty, tz this holds for the turns alone.
/// Each matrix becomes the nearest rotation, from which no number may be off by more than kLargestSkew,
/// and each quaternion has the length 1 to within kLargestLengthError (gap/nearest_rotation.hpp).
///
/// A .mot or .sto is a motion of OpenSim. With inDegrees in its head it has columns hip_flexion_r,
/// hip_adduction_r, hip_rotation_r (or _l, by the side), or states such as /jointset/.../hip_flexion_r/value;
/// columns of other joints are ignored. OpenSim's hip (gait2392) turns by flexion about z (right), adduction
/// about x (forward) and rotation about y (up), each in the frame that the one before turned; adduction and
/// rotation are mirrored on the left side. These are the turns of joint_rotation(), with adduction as
/// negative abduction. OpenSim's angles are 0 in the model's pose, ours in the pose of the scan.
///
/// With DataType=Quaternion in its head it comes from OpenSense: quaternions w,x,y,z in the frame of the
/// ground (x forward, y up, z right), of sensors pelvis_imu and femur_r_imu (or _l_), or of bodies pelvis and
/// femur_r. Sensors sit on their bones in any direction. As in OpenSense, the first row that has both is the
/// neutral pose, in which the person faces along x. (Data of sensors whose z is up must be turned before, as
/// OpenSense's sensor_to_opensim_rotations does.) Bodies are neutral where their axes are parallel.
PoseList read_poses(const std::filesystem::path& file, std::optional<Side> side);

/// Reads poses from the bytes of a file.
PoseList parse_poses(const std::filesystem::path& file, std::string_view bytes, std::optional<Side> side);

}  // namespace impinge
