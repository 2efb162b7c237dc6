// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/pose_series.hpp"

namespace impinge {

PoseSeries::PoseSeries(const Joint& joint, const SeriesOutputs& outputs)
    : outputs_(outputs),
      meshes_{main_surface(joint.ball.mesh, joint.ball.parts),
              main_surface(joint.socket.mesh, joint.socket.parts)},
      joint_(meshes_) {
  if (outputs.touch) {
    bodies_.emplace(meshes_,
                    bone_parts({joint.ball.mesh, joint.ball.parts}, {joint.socket.mesh, joint.socket.parts}));
  }
  if (!outputs.areas) return;
  scans_.emplace_back(meshes_.ball, meshes_.socket, facing_layer(Surface::socket));
  scans_.emplace_back(meshes_.socket, meshes_.ball, facing_layer(Surface::ball));
}

PoseSeries::Scan::Scan(const TriangleMesh& scanned, const TriangleMesh& facing, Layer layer)
    : cells(exact_cells(facing, layer)),
      vertices(packed_vertices<float>(scanned.vertices)),
      areas(vertex_areas(scanned)) {}

SeriesArea PoseSeries::Scan::area(const Pose& pose, Surface of, double cartilage_mm) const {
  std::vector<float> gap(vertices.size());
  scan_gaps(cells, vertices, pose, of, gap);
  const auto touching = static_cast<float>(cartilage_mm);
  SeriesArea found;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    found.cartilage += gap[i] <= touching ? areas[i] : 0.0;
    found.bone += gap[i] <= 0.0F ? areas[i] : 0.0;
  }
  return found;
}

SeriesAnswer PoseSeries::answer(const Pose& pose) const {
  SeriesAnswer answer;
  if (bodies_) answer.touch = bodies_->verdict(pose);
  if (outputs_.areas) {
    answer.areas = {scans_[0].area(pose, Surface::ball, outputs_.cartilage_mm),
                    scans_[1].area(pose, Surface::socket, outputs_.cartilage_mm)};
  }
  if (outputs_.smallest_gap) answer.smallest = posed_gap(joint_, meshes_, pose);
  return answer;
}

Pose pose_about(const Vec3& centre, const Eigen::Matrix3d& rotation, const Vec3& translation) {
  return {rotation, rotation * centre + translation - centre};
}

}  // namespace impinge
