// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/pose_series.hpp"

#include <algorithm>

#include "gap/measured_gap.hpp"

namespace impinge {

PoseSeries::PoseSeries(const Joint& joint, const SeriesOutputs& outputs)
    : outputs_(outputs), meshes_{joint.ball.mesh, joint.socket.mesh}, joint_(meshes_) {
  if (outputs.touch) overlay_.emplace(joint_);
}

SeriesAnswer PoseSeries::answer(const Pose& pose) const {
  SeriesAnswer answer;
  if (overlay_) answer.touch = overlay_->impinged(pose);
  if (!outputs_.smallest_gap) return answer;
  const std::optional<LeastGap> least = joint_.least_gap(pose);
  if (!least) return answer;
  const Surface scanned = least->at.scanned;
  const TriangleMesh& mesh = scanned == Surface::ball ? meshes_.ball : meshes_.socket;
  const Vec3& x = mesh.vertices[least->at.vertex];
  const CertifiedGap ends = measured_gap(scanned, joint_.faces(other(scanned)), to_other(scanned, pose, x));
  answer.smallest = SeriesGap{*least, std::max(ends.high - least->gap_mm, least->gap_mm - ends.low),
                              scanned == Surface::ball ? to_socket(pose, x) : x};
  return answer;
}

Pose pose_about(const Vec3& centre, const Eigen::Matrix3d& rotation, const Vec3& translation) {
  return {rotation, rotation * centre + translation - centre};
}

}  // namespace impinge
