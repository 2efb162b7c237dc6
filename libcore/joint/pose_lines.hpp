// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of pose files share; not for other code.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "files/delimited.hpp"
#include "joint/pose_list.hpp"

namespace impinge {

/// A matrix 3 x 4: x' = R x + t.
using PoseMatrix = Eigen::Matrix<double, 3, 4>;

/// The lines of a file of poses; refusals name the line.
class PoseLines : public NumberedLines {
 public:
  PoseLines(const std::filesystem::path& file, std::string_view bytes) : NumberedLines(bytes), file_(file) {}

  /// Throws FileError with the number of this line.
  [[noreturn]] void refuse(const std::string& reason) const;
  /// Throws FileError without a line number.
  [[noreturn]] void refuse_file(const std::string& reason) const;
  /// A finite number, NaN for a missing one; refuses any other word.
  double number(std::string_view word, char separator) const;
  /// Refuses a line whose number of words is not the number of names.
  void require_words(std::size_t words, std::size_t names) const;
  /// The rotation of a quaternion w, x, y, z; none where a number is missing.
  std::optional<Eigen::Matrix3d> turn_of_quaternion(const double* wxyz) const;
  /// Refuses a list in which no row is tracked.
  void require_pose(const PoseList& list) const;

 private:
  const std::filesystem::path& file_;
};

/// Is the word empty or NaN, as programs write what was not tracked?
bool is_missing(std::string_view word);

/// Adds the twelve columns of a matrix, without names.
void add_matrix_columns(PoseList& list);

/// Adds a matrix to the values of a row; NaN where there is none.
void add_matrix(const std::optional<PoseMatrix>& matrix, PoseList& list);

PoseList read_pose_csv(PoseLines lines);
PoseList read_opensim(PoseLines lines, std::optional<Side> side);

}  // namespace impinge
