// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/joint_document.hpp"

#include <algorithm>

namespace impinge {
namespace {

BoneDocument bone_of(const JointPart& part, const std::string& name, const std::vector<std::string>& parts) {
  const MeshReport& mesh = part.validation;
  BoneDocument found{.mesh = name,
                     .parts = parts,
                     .vertices = mesh.vertices,
                     .faces = mesh.faces,
                     .boundary_edges = mesh.boundary_edges,
                     .non_manifold_edges = mesh.non_manifold_edges,
                     .degenerate_faces = mesh.degenerate_faces,
                     .duplicate_faces = mesh.duplicate_faces,
                     .flipped_faces = mesh.flipped_faces,
                     .components = mesh.components,
                     .star_shaped = part.star_shape.star_shaped,
                     .directions_covered = part.star_shape.covered,
                     .directions_met_more_than_once = part.star_shape.violating,
                     .taken = {}};
  if (part.taken) found.taken = {part.taken->faces, part.taken->of, part.taken->within_mm};
  return found;
}

CentreDocument centre_of(const Joint& joint) {
  CentreDocument centre{.position = joint.centre,
                        .source = joint.fit ? "fitted" : "given",
                        .radius_mm = {},
                        .residual_rms_mm = {},
                        .vertices_used = {}};
  if (!joint.fit) return centre;
  centre.radius_mm = joint.fit->radius;
  centre.residual_rms_mm = joint.fit->rms;
  centre.vertices_used = joint.fit->points;
  return centre;
}

LandmarksDocument landmarks_of(const AnatomicalFrames& frames) {
  LandmarksDocument found{.pelvic_tilt_deg = frames.pelvic_tilt_deg,
                          .scanned_flexion_deg = {},
                          .scanned_abduction_deg = {},
                          .scanned_internal_rotation_deg = {}};
  if (!frames.scanned) return found;
  found.scanned_flexion_deg = frames.scanned->flexion;
  found.scanned_abduction_deg = frames.scanned->abduction;
  found.scanned_internal_rotation_deg = frames.scanned->internal_rotation;
  return found;
}

}  // namespace

JointDocument describe(const SessionJoint& joint, const JointNames& names) {
  const Joint& read = joint.joint;
  JointDocument said{.ball = bone_of(read.ball, names.ball, names.ball_parts),
                     .socket = bone_of(read.socket, names.socket, names.socket_parts),
                     .centre = centre_of(read),
                     .side = joint.side,
                     .axes = read.axes,
                     .landmarks = {},
                     .cartilage_map = {},
                     .overlap_mm = read.overlap_mm,
                     .warnings = read.warnings};
  if (read.frames) said.landmarks = landmarks_of(*read.frames);
  if (read.cartilage) {
    const auto [least, most] =
        std::minmax_element(read.cartilage->thickness.begin(), read.cartilage->thickness.end());
    said.cartilage_map = {read.cartilage->thickness.size(), *least, *most};
  }
  return said;
}

}  // namespace impinge
