// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/poses.hpp"

#include <algorithm>
#include <stdexcept>

#include "files/file_error.hpp"
#include "hip/pose_travel.hpp"
#include "joint/document.hpp"
#include "joint/pose_answer.hpp"

namespace impinge {
namespace {

bool asks(const PosesRequest& request, PosesOutput output) {
  return std::find(request.outputs.begin(), request.outputs.end(), output) != request.outputs.end();
}

}  // namespace

void PosesRequest::check() const {
  if (poses.has_value() == path.has_value())
    throw std::invalid_argument(
        "poses: they are asked for by a file, or by a path of angles; give one of poses and path");
  if (path) in_field("path", [&] { parse_pose_grid(*path); });
}

PoseList list_of(const PosesRequest& request, const SessionJoint& joint) {
  if (request.path) {
    PoseList grid = parse_pose_grid(*request.path);
    if (grid.needs_side() && !joint.side)
      throw std::invalid_argument("side: abduction and rotation need to know it; give left or right");
    return grid;
  }
  const std::filesystem::path& file = request.poses.value();
  PoseList list = read_poses(file, joint.side);
  if (list.needs_side() && !joint.side)
    throw FileError(file, "has angles that turn opposite ways on the two sides",
                    "say which with --side left or right");
  if (list.from_scan() && joint.joint.frames && joint.joint.frames->femur)
    throw FileError(file, "its poses begin at that of the scan, and landmarks of the femur at neutral",
                    "give angles, or leave the landmarks out");
  return list;
}

Pose pose_in(const SessionJoint& joint, const PoseList& list, std::size_t row) {
  const Pose own = list.pose(row, joint.side);
  if (list.kind == PoseKind::meshes) return pose_about(joint.joint.centre, own.rotation, own.translation);
  if (list.from_scan()) return own;
  return {joint.axes.transpose() * own.rotation * joint.axes, own.translation};
}

std::string doubt_of(const PosesRequest& request, const SessionJoint& joint, const PoseList& list) {
  if (!list.shifts()) return {};
  const auto pose_at = [&](std::size_t row) {
    return list.tracked(row) ? pose_in(joint, list, row) : Pose();
  };
  const std::string doubt = doubtful_travel(joint.joint, list.size(), pose_at, 1);
  return doubt.empty() ? doubt : (request.path ? "path" : request.poses->string()) + ": " + doubt;
}

SeriesOutputs outputs_of(const PosesRequest& request) {
  return {.touch = asks(request, PosesOutput::touch),
          .smallest_gap = asks(request, PosesOutput::gap),
          .areas = asks(request, PosesOutput::areas),
          .cartilage_mm = request.cartilage_mm};
}

PoseRow row_of(const SessionJoint& joint, const PoseList& list, std::size_t row, const SeriesAnswer& answer) {
  PoseRow made{.pose = row + 1,
               .touch = list.tracked(row) ? "" : "untracked",
               .certified = {},
               .smallest_gap_mm = {},
               .surface = {},
               .vertex = {},
               .clock = {},
               .bound_mm = {}};
  if (answer.touch) {
    const BodyPairs::Verdict& touch = *answer.touch;
    if (touch.contact != Contact::unknown) made.touch = word_of(touch.contact);
    made.certified =
        touch.contact == Contact::no || (touch.contact == Contact::yes && touch.rule != ContactRule::radii);
  }
  if (!answer.smallest) return made;
  const PosedGap& smallest = *answer.smallest;
  made.smallest_gap_mm = smallest.least.gap_mm;
  made.surface = smallest.least.at.scanned;
  made.vertex = smallest.least.at.vertex;
  if (joint.dial) made.clock = clock_text(joint.dial->hours(joint.axes * smallest.place));
  made.bound_mm = smallest.bound_mm;
  return made;
}

}  // namespace impinge
