// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Many poses of a joint, from a grid or a file: a CSV, or a motion of OpenSim or OpenSense.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/pose.hpp"
#include "hip/motion.hpp"

namespace impinge {

/// What the numbers of a row mean. The first three kinds have angles in degrees and a shift of the ball in
/// mm, 0 where the row has none. The others have a matrix (3 x 4), row by row, x' = R x + t, mm.
enum class PoseKind {
  hip,  // flexion, abduction, internal_rotation: joint_rotation(), the order of Wu et al. 2002 for the hip
        // (about their Z, X and Y); tx, ty, tz along the axes of the meshes. Also OpenSim's hip_flexion_r,
        // hip_adduction_r, hip_rotation_r, or _l by the side
  shoulder,  // plane_of_elevation, elevation, axial_rotation: shoulder_rotation(); tx, ty, tz as above
  steps,  // rot_x, rot_y, rot_z, trans_x, trans_y, trans_z of BlenderROMFinder, whose axes are taken as those
          // of the meshes, through the centre of rotation: R = R_z R_y R_x, each about the axis that the one
          // before turned, and then a shift along the turned axes, R t
  meshes,  // a matrix in the frame of the meshes
  centre,  // about the centre of rotation, axes of the meshes
  joint    // about the centre of rotation; x right, y anterior, z superior
};

/// A column of a list.
struct PoseColumn {
  std::string name;  // as it was given; a column without a name is not repeated in answers
  int number =
      -1;  // the pose's number that it gives, from 0, in the order above; below 0 for frames and times
  double sign = 1.0;  // sign of that number
};

/// One pose a row.
struct PoseList {
  PoseKind kind = PoseKind::hip;
  std::vector<PoseColumn> columns;  // the last twelve are a matrix where there is one
  std::vector<double> values;       // of all rows, one row after the other; NaN where the file has none

  std::size_t width() const { return columns.size(); }
  std::size_t size() const { return columns.empty() ? 0 : values.size() / width(); }
  /// Does the row have all numbers of its pose? A camera that lost its markers leaves rows without.
  bool tracked(std::size_t row) const;
  /// Do its angles need the side of the body?
  bool needs_side() const;
  /// Are its angles counted from the pose of the scan, even if there are landmarks?
  bool from_scan() const;
  /// Can the ball leave its place, by a shift or by a matrix in the frame of the meshes?
  bool shifts() const;
  /// The pose of a row, about the point and in the axes that `kind` says, mm. `side` must be given where it
  /// is needed.
  Pose pose(std::size_t row, std::optional<Side> side) const;
};

/// The columns with these names (in any case) and their kind: one of the first three. Without names there are
/// no columns and the kind is `hip`. Throws std::invalid_argument, one line, for other names, names of two
/// kinds, and a number that is given twice.
PoseList named_poses(const std::vector<std::string>& names);

/// Turns "Internal Rotation" into "internal_rotation".
std::string plain_name(std::string_view name);

/// All combinations of a grid such as "flexion=0..120/1,internal_rotation=0..40/10,abduction=5,tx=-2..2/1":
/// each name has FIRST..LAST/STEP or one number; all names are of one kind (named_poses()). The last name
/// varies fastest. Throws std::invalid_argument, one line, for anything else, an angle beyond 180 degrees, a
/// last number that the steps do not meet, or more than ten million poses.
PoseList parse_pose_grid(std::string_view text);

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
