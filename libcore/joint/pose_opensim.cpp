// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "joint/pose_lines.hpp"

namespace impinge {
namespace {

// What the file says before endheader.
struct OpenSimHead {
  std::optional<double> degrees;  // degrees in one unit of its angles
  bool quaternions = false;
};

OpenSimHead read_head(PoseLines& lines) {
  OpenSimHead head;
  while (lines.next() && lines.line() != "endheader") {
    if (lines.line() == "inDegrees=yes") head.degrees = 1.0;
    if (lines.line() == "inDegrees=no") head.degrees = 1.0 / kDegree;
    if (lines.line() == "DataType=Quaternion") head.quaternions = true;
  }
  if (lines.line() != "endheader") lines.refuse_file("has no line endheader");
  if (!head.degrees && !head.quaternions)
    lines.refuse_file(
        "says neither inDegrees=yes nor inDegrees=no before endheader; add the line that is true");
  return head;
}

// Words between blanks and tabs, any number of them.
std::vector<std::string_view> blank_words(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t from = 0; (from = line.find_first_not_of(" \t", from)) != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", from), line.size());
    words.push_back(line.substr(from, end - from));
    from = end;
  }
  return words;
}

// "hip_flexion_r" from "/jointset/hip_r/hip_flexion_r/value".
std::string_view coordinate(std::string_view label) {
  if (!label.ends_with("/value")) return label;
  label.remove_suffix(std::string_view("/value").size());
  return label.substr(label.rfind('/') + 1);
}

// The labels of the columns.
class Labels {
 public:
  explicit Labels(PoseLines& lines) : lines_(lines) {
    lines.next();
    labels_ = blank_words(lines.line());
  }
  std::optional<std::size_t> find(std::string_view name) const {
    const auto at = std::find_if(labels_.begin(), labels_.end(),
                                 [&](std::string_view label) { return coordinate(label) == name; });
    return at == labels_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - labels_.begin()));
  }
  std::size_t at(std::string_view name) const {
    const std::optional<std::size_t> found = find(name);
    if (!found) lines_.refuse("there is no column " + std::string(name));
    return *found;
  }
  // The words of the next row; empty after the last.
  std::vector<std::string_view> next_row() const {
    if (!lines_.next()) return {};
    std::vector<std::string_view> words = blank_words(lines_.line());
    lines_.require_words(words.size(), labels_.size());
    return words;
  }

 private:
  PoseLines& lines_;
  std::vector<std::string_view> labels_;
};

PoseList read_angles(PoseLines& lines, double unit, const std::string& suffix) {
  const Labels labels(lines);
  PoseList list;
  list.columns = {{"time"},
                  {"hip_flexion" + suffix, 0},
                  {"hip_adduction" + suffix, 1, -1.0},
                  {"hip_rotation" + suffix, 2}};
  std::vector<std::size_t> from;  // for each column of the list, its column in the file
  for (const PoseColumn& column : list.columns) from.push_back(labels.at(column.name));
  for (std::vector<std::string_view> words; !(words = labels.next_row()).empty();) {
    for (std::size_t k = 0; k < from.size(); ++k) {
      const double value = lines.number(words[from[k]], ',') * (k == 0 ? 1.0 : unit);
      if (k > 0 && std::abs(value) > kLargestAngle)
        lines.refuse("an angle of " + list.columns[k].name + " is not within 180 degrees of 0");
      list.values.push_back(value);
    }
  }
  return list;
}

// The rotation in a field w,x,y,z.
std::optional<Eigen::Matrix3d> turn_of_field(const PoseLines& lines, std::string_view field) {
  const std::vector<std::string_view> words = delimited_words(field, ',');
  if (is_missing(field)) return std::nullopt;
  std::array<double, 4> numbers{};
  if (words.size() != numbers.size()) lines.refuse("'" + std::string(field) + "' is no quaternion w,x,y,z");
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = lines.number(words[k], ',');
  return lines.turn_of_quaternion(numbers.data());
}

PoseList read_quaternions(PoseLines& lines, const std::string& suffix) {
  const Labels labels(lines);
  const bool sensors = labels.find("pelvis_imu") || labels.find("femur" + suffix + "_imu");
  const std::string imu = sensors ? "_imu" : "";
  const std::size_t time = labels.at("time");
  const std::size_t at_pelvis = labels.at("pelvis" + imu);
  const std::size_t at_femur = labels.at("femur" + suffix + imu);
  PoseList list{.kind = PoseKind::joint, .columns = {{"time"}}, .values = {}};
  add_matrix_columns(list);
  // Our axes, x right, y anterior, z superior, are OpenSim's z, x and y.
  const Eigen::Matrix3d ours{{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  std::optional<std::array<Eigen::Matrix3d, 2>> first;  // turns back to the axes of pelvis and femur
  if (!sensors) first = {Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity()};
  for (std::vector<std::string_view> words; !(words = labels.next_row()).empty();) {
    list.values.push_back(lines.number(words[time], ','));
    const std::optional<Eigen::Matrix3d> pelvis = turn_of_field(lines, words[at_pelvis]);
    const std::optional<Eigen::Matrix3d> femur = turn_of_field(lines, words[at_femur]);
    std::optional<PoseMatrix> matrix;
    if (pelvis && femur) {
      if (!first) first = {pelvis->transpose(), femur->transpose()};
      matrix = PoseMatrix::Zero();
      matrix->leftCols<3>() =
          ours * (*pelvis * (*first)[0]).transpose() * (*femur * (*first)[1]) * ours.transpose();
    }
    add_matrix(matrix, list);
  }
  return list;
}

}  // namespace

PoseList read_opensim(PoseLines lines, std::optional<Side> side) {
  if (!side) lines.refuse_file("is a motion of OpenSim, which has two hips; say which with --side");
  const std::string suffix = *side == Side::left ? "_l" : "_r";
  const OpenSimHead head = read_head(lines);
  PoseList list =
      head.quaternions ? read_quaternions(lines, suffix) : read_angles(lines, *head.degrees, suffix);
  lines.require_pose(list);
  return list;
}

}  // namespace impinge
