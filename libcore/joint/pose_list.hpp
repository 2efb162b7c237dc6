// SPDX-License-Identifier: GPL-3.0-or-later
// Many poses of a joint, from a file or a grid of angles.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hip/motion.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// A column of angles, or of times, which move nothing.
struct PoseColumn {
  std::string name;                    // as it was given
  const MotionName* motion = nullptr;  // null for a time
};

/// One pose a row: either angles in degrees, or a matrix (3 x 4) as twelve numbers, row by row.
struct PoseList {
  std::vector<PoseColumn> columns;  // empty for matrices
  std::vector<double> values;       // of all rows, one row after the other; NaN where the file has none

  std::size_t width() const { return columns.empty() ? 12 : columns.size(); }
  std::size_t size() const { return values.size() / width(); }
  /// Has the row all of its numbers? A camera that lost its markers leaves rows without.
  bool tracked(std::size_t row) const;
  /// Does it have angles that need the side of the body (abduction, rotation)?
  bool needs_side() const;
  /// The motion that the angles of a row make; not for matrices.
  Motion motion(std::size_t row) const;
  /// Of a list of matrices: x' = rotation x + translation, input frame, mm.
  Eigen::Matrix3d rotation(std::size_t row) const;
  Vec3 translation(std::size_t row) const;
};

/// Every combination of the angles (degrees) in "flexion=0..120/1,internal_rotation=0..40/10,abduction=5":
/// FIRST..LAST/STEP, or one angle. The last motion named varies fastest. std::invalid_argument, one line, for
/// anything else, a last angle that the steps do not meet, or more than ten million poses.
PoseList parse_pose_grid(std::string_view text);

/// Reads poses; the file's extension decides how:
///   * .mot or .sto: a motion of OpenSim with inDegrees in its head, and columns hip_flexion_r,
///     hip_adduction_r, hip_rotation_r (or _l, by `side`), or their states as
///     /jointset/.../hip_flexion_r/value; other columns are of other joints. OpenSim's hip (gait2392) turns
///     by flexion about z (right), adduction about x (forward) and rotation about y (up), each in the frame
///     that the one before turned, adduction and rotation mirrored on the left side: these are the turns of
///     joint_rotation(), adduction being negative abduction. Its angles are 0 in the model's pose, ours in
///     the pose of the scan;
///   * anything else: a CSV. With a header of the names of motions (hip/motion.hpp) its rows are angles in
///     degrees. Rows of 12 or 16 numbers, with a header or without, are matrices, row by row, x' = M x, frame
///     of the input, mm. Each becomes the nearest rotation, from which no number may be off by more than
///     kLargestSkew (gap/nearest_rotation.hpp). A header holds text and no number.
/// A row with a field that is empty or NaN is kept, as one that is not tracked; a byte order mark is no part
/// of a file. FileError names the line.
PoseList read_poses(const std::filesystem::path& file, std::optional<Side> side);

}  // namespace impinge
