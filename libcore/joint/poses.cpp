// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/poses.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

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

bool PosesRequest::asks(PosesOutput output) const {
  return std::find(outputs.begin(), outputs.end(), output) != outputs.end();
}

void add_row(const PoseRow& row, PosesAnswer& all) {
  ++all.number_of_poses;
  if (!row.tracked) ++all.untracked;
  if (all.touching && row.touch() == "yes") ++*all.touching;
  const auto& gap = row.smallest;
  if (gap && (!all.smallest_gap || gap->gap_mm < all.smallest_gap->gap_mm))
    all.smallest_gap = {all.number_of_poses, gap->gap_mm, std::string(name(gap->surface)), gap->vertex,
                        gap->clock()};
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
  Pose own = list.pose(row, joint.side);
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

Pose pose_about(const Vec3& centre, const Eigen::Matrix3d& rotation, const Vec3& translation) {
  return {rotation, rotation * centre + translation - centre};
}

PoseSeries::PoseSeries(const SessionJoint& joint, const PosesRequest& asked)
    : joint_(joint),
      asked_(asked),
      meshes_{main_surface(joint.joint.ball.mesh, joint.joint.ball.parts),
              main_surface(joint.joint.socket.mesh, joint.joint.socket.parts)},
      culled_(meshes_) {
  const auto& [ball, socket] = std::tie(joint.joint.ball, joint.joint.socket);
  if (asked.asks(PosesOutput::touch))
    bodies_.emplace(meshes_, bone_parts({ball.mesh, ball.parts}, {socket.mesh, socket.parts}));
  if (!asked.asks(PosesOutput::areas)) return;
  scans_.emplace_back(meshes_.ball, meshes_.socket, facing_layer(Surface::socket));
  scans_.emplace_back(meshes_.socket, meshes_.ball, facing_layer(Surface::ball));
}

PoseSeries::Scan::Scan(const TriangleMesh& scanned, const TriangleMesh& facing, Layer layer)
    : cells(exact_cells(facing, layer)),
      vertices(packed_vertices<float>(scanned.vertices)),
      areas(vertex_areas(scanned)) {}

void PoseSeries::add_areas(const Pose& pose, Surface of, double& bone, double& cartilage) const {
  const Scan& scan = scans_[of == Surface::ball ? 0 : 1];
  std::vector<float> gap(scan.vertices.size());
  scan_gaps(scan.cells, scan.vertices, pose, of, gap);
  const auto touching = static_cast<float>(asked_.cartilage_mm);
  for (std::size_t i = 0; i < gap.size(); ++i) {
    cartilage += gap[i] <= touching ? scan.areas[i] : 0.0;
    bone += gap[i] <= 0.0F ? scan.areas[i] : 0.0;
  }
}

PoseRow PoseSeries::answer(const Pose& pose) const {
  PoseRow row;
  if (bodies_) row.verdict = bodies_->verdict(pose);
  if (!scans_.empty()) {
    PoseAreas& areas = row.areas.emplace();
    add_areas(pose, Surface::ball, areas.bone_ball_mm2, areas.cartilage_ball_mm2);
    add_areas(pose, Surface::socket, areas.bone_socket_mm2, areas.cartilage_socket_mm2);
  }
  if (asked_.asks(PosesOutput::gap)) row.smallest = smallest_gap(joint_, culled_, meshes_, pose);
  return row;
}

}  // namespace impinge
