// SPDX-License-Identifier: GPL-3.0-or-later
// Many poses of a joint, from a file (joint/pose_file.hpp) or a grid.
#pragma once

#include <cstddef>
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

}  // namespace impinge
