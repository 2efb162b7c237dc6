// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "files/file_bytes.hpp"
#include "files/file_error.hpp"
#include "files/formatted.hpp"
#include "gap/nearest_rotation.hpp"
#include "joint/pose_lines.hpp"

namespace impinge {
namespace {

constexpr const char* kPosesAdvice =
    "give a CSV with a header of motions (as flexion,internal_rotation) and degrees below it, of quaternions "
    "qw,qx,qy,qz, or of matrices of 12 or 16 numbers a line (of two bones: ball_qw, ..., socket_qw, ...), or "
    "a motion of OpenSim (.mot, .sto)";

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void PoseLines::refuse(const std::string& reason) const {
  refuse_file("line " + std::to_string(NumberedLines::number()) + ": " + reason);
}

void PoseLines::refuse_file(const std::string& reason) const { throw FileError(file_, reason, kPosesAdvice); }

double PoseLines::number(std::string_view word, char separator) const {
  if (is_missing(word)) return kMissing;
  const std::optional<double> value = delimited_number(word, separator);
  if (!value) refuse("'" + std::string(word) + "' is no number");
  return *value;
}

void PoseLines::require_words(std::size_t words, std::size_t names) const {
  if (words != names) refuse(std::to_string(words) + " numbers below " + std::to_string(names) + " names");
}

std::optional<Eigen::Matrix3d> PoseLines::turn_of_quaternion(const double* wxyz) const {
  const Eigen::Quaterniond given(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  const double length = given.norm();
  if (std::isnan(length)) return std::nullopt;
  if (length == 0.0)
    refuse("a quaternion of length 0 is no turn; leave its fields empty where nothing was tracked");
  if (std::abs(length - 1.0) > kLargestLengthError)
    refuse(formatted("a quaternion has the length %.3g, which is not 1; its order is w,x,y,z", length));
  return given.normalized().toRotationMatrix();
}

void PoseLines::require_pose(const PoseList& list) const {
  for (std::size_t row = 0; row < list.size(); ++row)
    if (list.tracked(row)) return;
  refuse_file(list.values.empty() ? "holds no pose" : "has a number missing in every row");
}

bool is_missing(std::string_view word) {
  if (word.starts_with('-')) word.remove_prefix(1);
  return word.empty() || (word.size() == 3 && plain_name(word) == "nan");
}

void add_matrix_columns(PoseList& list) {
  for (int k = 0; k < 12; ++k) list.columns.push_back({"", k});
}

void add_matrix(const std::optional<PoseMatrix>& matrix, PoseList& list) {
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < 4; ++k) list.values.push_back(matrix ? (*matrix)(i, k) : kMissing);
}

PoseList parse_poses(const std::filesystem::path& file, std::string_view bytes, std::optional<Side> side) {
  const std::string kind = plain_name(file.extension().string());
  const PoseLines lines(file, bytes);
  if (kind == ".mot" || kind == ".sto") return read_opensim(lines, side);
  PoseList list = read_pose_csv(lines);
  for (const PoseColumn& column : list.columns) {
    const std::string name = plain_name(column.name);
    if (side && name.starts_with("hip_") && name.ends_with(*side == Side::left ? "_r" : "_l"))
      lines.refuse_file("has " + column.name + ", which is the other hip; check --side");
  }
  return list;
}

PoseList read_poses(const std::filesystem::path& file, std::optional<Side> side) {
  return parse_poses(file, read_bytes(file), side);
}

}  // namespace impinge
