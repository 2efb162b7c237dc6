// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/poses.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "files/file_error.hpp"
#include "hip/pose_travel.hpp"
#include "joint/document.hpp"

namespace impinge {

void PosesRequest::check() const {
  if (poses.has_value() == path.has_value())
    throw std::invalid_argument(
        "poses: they are asked for by a file, or by a path of angles; give one of poses and path");
  if (path) in_field("path", [&] { parse_pose_grid(*path); });
}

void add_row(std::string_view touch, const std::optional<SmallestOfPoses>& gap, PosesAnswer& all) {
  ++all.number_of_poses;
  if (touch == "untracked") ++all.untracked;
  if (all.touching && touch == "yes") ++*all.touching;
  if (all.unknown && touch.empty()) ++*all.unknown;
  if (!gap || (all.smallest_gap && gap->gap_mm >= all.smallest_gap->gap_mm)) return;
  all.smallest_gap = gap;
  all.smallest_gap->pose = all.number_of_poses;
}

void add_row(const PoseRow& row, PosesAnswer& all) {
  std::optional<SmallestOfPoses> found;
  if (const auto& gap = row.smallest)
    found = {0, gap->gap_mm, std::string(name(gap->surface)), gap->vertex, gap->clock()};
  add_row(row.touch(), found, all);
}

PoseList list_of(const PosesRequest& request, const SessionJoint& joint) {
  const bool from_neutral = joint.joint.from_neutral();
  if (request.path) {
    PoseList grid = parse_pose_grid(*request.path);
    if (grid.needs_side() && !joint.side)
      throw std::invalid_argument("side: abduction and rotation need to know it; give left or right");
    if (grid.from_scan() && from_neutral)
      throw std::invalid_argument(
          "path: its turns begin at the pose of the scan, and landmarks of the femur at neutral; give "
          "flexion, "
          "abduction and rotation, or leave the landmarks out");
    return grid;
  }
  const std::filesystem::path& file = request.poses.value();
  PoseList list = read_poses(file, joint.side);
  if (list.needs_side() && !joint.side)
    throw FileError(file, "has angles that turn opposite ways on the two sides",
                    "say which with --side left or right");
  if (list.from_scan() && from_neutral)
    throw FileError(file, "its poses begin at that of the scan, and landmarks of the femur at neutral",
                    "give angles, or leave the landmarks out");
  return list;
}

Pose pose_in(const SessionJoint& joint, const PoseList& list, std::size_t row) {
  Pose own = list.pose(row, joint.side);
  if (list.kind == PoseKind::meshes) return pose_about(joint.joint.centre, own.rotation, own.translation);
  if (list.from_scan()) return own;
  return {joint.axes.transpose() * own.rotation * joint.axes, own.translation};
}

// Does the joint move, but no angle by more than pi, as where a recording is in radians?
static bool may_be_radians(const PoseList& list) {
  constexpr std::size_t kFewest = 10;  // rows of a recording
  constexpr double kMoves = 0.5;
  if (list.size() < kFewest || list.kind > PoseKind::steps) return false;
  double largest = 0.0;
  for (std::size_t k = 0; k < list.values.size(); ++k) {
    const int number = list.columns[k % list.width()].number;
    const double angle = std::abs(list.values[k]);
    if (number >= 0 && number < 3 && angle > largest) largest = angle;
  }
  return largest > kMoves && largest <= kPi;
}

std::string doubt_of(const PosesRequest& request, const SessionJoint& joint, const PoseList& list) {
  if (request.poses && may_be_radians(list))
    return request.poses->string() +
           ": no angle is above pi, as if they were in radians; they are read as degrees, check them";
  if (!list.shifts()) return {};
  const auto pose_at = [&](std::size_t row) {
    return list.tracked(row) ? pose_in(joint, list, row) : Pose();
  };
  const std::string doubt = doubtful_travel(joint.joint, list.size(), pose_at, 1);
  return doubt.empty() ? doubt : (request.path ? "path" : request.poses->string()) + ": " + doubt;
}

Pose pose_about(const Vec3& centre, const Eigen::Matrix3d& rotation, const Vec3& translation) {
  return {rotation, rotation * centre + translation - centre};
}

PoseSeries::PoseSeries(const SessionJoint& joint, const PosesRequest& asked)
    : joint_(joint), asked_(asked), meshes_(joint.joint.main()), culled_(meshes_) {
  if (asked.asks(PosesOutput::touch)) bodies_.emplace(meshes_, joint.joint.beside());
  if (asked.asks(PosesOutput::areas))
    cells_.emplace(packed_joint(exact_cells(meshes_.ball, facing_layer(Surface::ball)),
                                exact_cells(meshes_.socket, facing_layer(Surface::socket)), meshes_.ball,
                                meshes_.socket));
}

PoseAreas PoseSeries::areas(const Pose& pose) const {
  std::vector<float> ball(cells_->ball.size());
  std::vector<float> socket(cells_->socket.size());
  scan_joint(*cells_, pose, ball, socket);
  const auto up_to = [](double gap_mm, const std::vector<float>& gaps, const SessionPart& of) {
    double area = 0.0;
    for (std::size_t i = 0; i < gaps.size(); ++i)
      area += of.used[i] && gaps[i] <= static_cast<float>(gap_mm) ? of.area[i] : 0.0;
    return area;
  };
  const double touching = asked_.cartilage_mm;
  return {up_to(0.0, ball, joint_.ball), up_to(0.0, socket, joint_.socket),
          up_to(touching, ball, joint_.ball), up_to(touching, socket, joint_.socket)};
}

PoseRow PoseSeries::answer(const Pose& pose) const {
  PoseRow row;
  if (bodies_) row.verdict = bodies_->verdict(pose);
  if (cells_) row.areas = areas(pose);
  if (asked_.asks(PosesOutput::gap)) row.smallest = smallest_gap(joint_, culled_, pose);
  return row;
}

}  // namespace impinge
