// SPDX-License-Identifier: GPL-3.0-or-later
// Describes in a document the joint about which a question was asked.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "files/fields.hpp"
#include "joint/session.hpp"

namespace impinge {

/// The faces of a whole bone that were taken as the surface of the joint (hip/whole_bone.hpp).
template <>
inline constexpr std::tuple fields_of<TakenFaces>{
    Field{"faces", "1", "taken as the surface of the joint; the rest counts as bone", &TakenFaces::faces},
    Field{"of", "1", "faces of the whole bone", &TakenFaces::of},
    Field{"within_mm", "mm", "distance from the centre up to which faces are taken", &TakenFaces::within_mm}};

/// Frames from landmarks (hip/landmarks.hpp).
template <>
inline constexpr std::tuple fields_of<AnatomicalFrames>{
    Field{"pelvic_tilt_deg", "deg", "of the anterior pelvic plane from upright; forward is positive",
          &AnatomicalFrames::pelvic_tilt_deg},
    Field{"scanned_flexion_deg", "deg", "of the femur in the scan",
          via(&AnatomicalFrames::scanned, &Motion::flexion)},
    Field{"scanned_abduction_deg", "deg", "of the femur in the scan",
          via(&AnatomicalFrames::scanned, &Motion::abduction)},
    Field{"scanned_internal_rotation_deg", "deg", "of the femur in the scan",
          via(&AnatomicalFrames::scanned, &Motion::internal_rotation)}};

template <>
inline constexpr std::tuple fields_of<CartilageMap>{
    Field{"points", "1", "of the map", [](const CartilageMap& map) { return map.thickness.size(); }},
    Field{"thinnest_mm", "mm", "both layers together",
          [](const CartilageMap& map) {
            return *std::min_element(map.thickness.begin(), map.thickness.end());
          }},
    Field{"thickest_mm", "mm", "both layers together", [](const CartilageMap& map) {
            return *std::max_element(map.thickness.begin(), map.thickness.end());
          }}};

/// One bone, as it was given.
struct BoneDocument : MeshReport, StarShapeReport {
  std::string mesh;
  std::vector<std::string> parts;
  std::optional<TakenFaces> taken;

  static constexpr std::tuple fields{
      Field{"mesh", "", "its file, or what it is called", &BoneDocument::mesh},
      Field{"parts", "", "files of bone beside it", &BoneDocument::parts},
      Field{"vertices", "1", "of the mesh as given", &BoneDocument::vertices},
      Field{"faces", "1", "of the mesh as given", &BoneDocument::faces},
      Field{"boundary_edges", "1", "edges of one face", &BoneDocument::boundary_edges},
      Field{"non_manifold_edges", "1", "edges of more than two faces", &BoneDocument::non_manifold_edges},
      Field{"degenerate_faces", "1", "faces without area", &BoneDocument::degenerate_faces},
      Field{"duplicate_faces", "1", "faces that are there twice", &BoneDocument::duplicate_faces},
      Field{"flipped_faces", "1", "faces wound against their neighbours", &BoneDocument::flipped_faces},
      Field{"components", "1", "pieces that do not hang together", &BoneDocument::components},
      Field{"star_shaped", "", "does every ray from the centre meet it once at most?",
            &BoneDocument::star_shaped},
      Field{"directions_covered", "1", "share of all directions in which it is met", &BoneDocument::covered},
      Field{"directions_met_more_than_once", "1", "share of all directions", &BoneDocument::violating},
      Field{"taken", "", "of a whole bone, what was taken as the surface of the joint",
            &BoneDocument::taken}};
};

struct CentreDocument {
  Vec3 position = Vec3::Zero();
  std::optional<SphereFit> fit;

  static constexpr std::tuple fields{
      Field{"position", "mm", "x, y, z in the frame of the meshes", &CentreDocument::position},
      Field{"source", "", "fitted or given",
            [](const auto& centre) { return std::string_view(centre.fit ? "fitted" : "given"); }},
      Field{"radius_mm", "mm", "of the fitted sphere", via(&CentreDocument::fit, &SphereFit::radius)},
      Field{"residual_rms_mm", "mm", "of the vertices that it was fitted to",
            via(&CentreDocument::fit, &SphereFit::rms)},
      Field{"vertices_used", "1", "by the fit", via(&CentreDocument::fit, &SphereFit::points)}};
};

struct JointDocument {
  BoneDocument ball;
  BoneDocument socket;
  CentreDocument centre;
  const SessionJoint* joint;

  static constexpr std::tuple fields{
      Field{"ball", "", "the bone with the ball", &JointDocument::ball},
      Field{"socket", "", "the bone with the socket", &JointDocument::socket},
      Field{"centre", "", "of rotation", &JointDocument::centre},
      Field{"side", "", "of the body", via(&JointDocument::joint, &SessionJoint::side)},
      Field{"axes", "", "where +x, +y and +z of the meshes point",
            via(&JointDocument::joint, &SessionJoint::joint, &Joint::axes)},
      Field{"landmarks", "", "what they say; null without",
            via(&JointDocument::joint, &SessionJoint::joint, &Joint::frames)},
      Field{"cartilage_map", "", "null where the thickness is one number",
            via(&JointDocument::joint, &SessionJoint::joint, &Joint::cartilage)},
      Field{"overlap_mm", "mm", "of the surfaces along a ray that is no contact",
            via(&JointDocument::joint, &SessionJoint::joint, &Joint::overlap_mm)},
      Field{"warnings", "", "what may be wrong with what was given, one line each",
            via(&JointDocument::joint, &SessionJoint::joint, &Joint::warnings)}};
};

/// Names of the meshes; parts are named as their files.
struct JointNames {
  std::string ball = "ball";
  std::string socket = "socket";
  std::vector<std::string> ball_parts{};
  std::vector<std::string> socket_parts{};
};

/// Describes a joint. The result refers to `joint`, which must outlive it.
inline JointDocument describe(const SessionJoint& joint, const JointNames& names) {
  const auto bone = [](const JointPart& of, const std::string& mesh, const std::vector<std::string>& parts) {
    return BoneDocument{of.validation, of.star_shape, mesh, parts, of.taken};
  };
  const Joint& read = joint.joint;
  return {bone(read.ball, names.ball, names.ball_parts),
          bone(read.socket, names.socket, names.socket_parts),
          {read.centre, read.fit},
          &joint};
}

}  // namespace impinge
