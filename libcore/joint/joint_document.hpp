// SPDX-License-Identifier: GPL-3.0-or-later
// What a document says of the joint that a question was asked of.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "files/fields.hpp"
#include "joint/session.hpp"

namespace impinge {

/// The faces of a whole bone that were taken as the surface of the joint (hip/whole_bone.hpp).
struct TakenDocument {
  std::size_t faces = 0;
  std::size_t of = 0;
  double within_mm = 0.0;

  static constexpr auto fields() {
    using Taken = TakenDocument;
    return std::tuple{
        Field{"faces", "1", "taken as the surface of the joint; the rest counts as bone", &Taken::faces},
        Field{"of", "1", "faces of the whole bone", &Taken::of},
        Field{"within_mm", "mm", "from the centre they are taken", &Taken::within_mm}};
  }
};

/// One bone, as it was given (mesh/validation.hpp, mesh/star_shape.hpp).
struct BoneDocument {
  std::string mesh;
  std::vector<std::string> parts;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t boundary_edges = 0;
  std::size_t non_manifold_edges = 0;
  std::size_t degenerate_faces = 0;
  std::size_t duplicate_faces = 0;
  std::size_t flipped_faces = 0;
  std::size_t components = 0;
  bool star_shaped = false;
  double directions_covered = 0.0;
  double directions_met_more_than_once = 0.0;
  std::optional<TakenDocument> taken;

  static constexpr auto fields() {
    using Bone = BoneDocument;
    return std::tuple{
        Field{"mesh", "", "its file, or what it is called", &Bone::mesh},
        Field{"parts", "", "files of bone beside it", &Bone::parts},
        Field{"vertices", "1", "of the mesh as given", &Bone::vertices},
        Field{"faces", "1", "of the mesh as given", &Bone::faces},
        Field{"boundary_edges", "1", "edges of one face", &Bone::boundary_edges},
        Field{"non_manifold_edges", "1", "edges of more than two faces", &Bone::non_manifold_edges},
        Field{"degenerate_faces", "1", "faces without area", &Bone::degenerate_faces},
        Field{"duplicate_faces", "1", "faces that are there twice", &Bone::duplicate_faces},
        Field{"flipped_faces", "1", "faces wound against their neighbours", &Bone::flipped_faces},
        Field{"components", "1", "pieces that do not hang together", &Bone::components},
        Field{"star_shaped", "", "does every ray from the centre meet it once at most?", &Bone::star_shaped},
        Field{"directions_covered", "1", "share of all directions in which it is met",
              &Bone::directions_covered},
        Field{"directions_met_more_than_once", "1", "share of all directions",
              &Bone::directions_met_more_than_once},
        Field{"taken", "", "of a whole bone, what was taken as the surface of the joint", &Bone::taken}};
  }
};

struct CentreDocument {
  Vec3 position = Vec3::Zero();
  std::string_view source;
  std::optional<double> radius_mm;
  std::optional<double> residual_rms_mm;
  std::optional<std::size_t> vertices_used;

  static constexpr auto fields() {
    using Centre = CentreDocument;
    return std::tuple{
        Field{"position", "mm", "x, y, z in the frame of the meshes", &Centre::position},
        Field{"source", "", "fitted or given", &Centre::source},
        Field{"radius_mm", "mm", "of the fitted sphere", &Centre::radius_mm},
        Field{"residual_rms_mm", "mm", "of the vertices that it was fitted to", &Centre::residual_rms_mm},
        Field{"vertices_used", "1", "by the fit", &Centre::vertices_used}};
  }
};

/// Of frames from landmarks (hip/landmarks.hpp).
struct LandmarksDocument {
  double pelvic_tilt_deg = 0.0;
  std::optional<double> scanned_flexion_deg;
  std::optional<double> scanned_abduction_deg;
  std::optional<double> scanned_internal_rotation_deg;

  static constexpr auto fields() {
    using Found = LandmarksDocument;
    return std::tuple{
        Field{"pelvic_tilt_deg", "deg", "of the anterior pelvic plane from upright; forward is positive",
              &Found::pelvic_tilt_deg},
        Field{"scanned_flexion_deg", "deg", "of the femur in the scan", &Found::scanned_flexion_deg},
        Field{"scanned_abduction_deg", "deg", "of the femur in the scan", &Found::scanned_abduction_deg},
        Field{"scanned_internal_rotation_deg", "deg", "of the femur in the scan",
              &Found::scanned_internal_rotation_deg}};
  }
};

struct CartilageDocument {
  std::size_t points = 0;
  double thinnest_mm = 0.0;
  double thickest_mm = 0.0;

  static constexpr auto fields() {
    using Map = CartilageDocument;
    return std::tuple{Field{"points", "1", "of the map", &Map::points},
                      Field{"thinnest_mm", "mm", "both layers together", &Map::thinnest_mm},
                      Field{"thickest_mm", "mm", "both layers together", &Map::thickest_mm}};
  }
};

struct JointDocument {
  BoneDocument ball;
  BoneDocument socket;
  CentreDocument centre;
  std::optional<Side> side;
  std::string axes;
  std::optional<LandmarksDocument> landmarks;
  std::optional<CartilageDocument> cartilage_map;
  double overlap_mm = 0.0;
  std::vector<std::string> warnings;

  static constexpr auto fields() {
    using Said = JointDocument;
    return std::tuple{
        Field{"ball", "", "the bone with the ball", &Said::ball},
        Field{"socket", "", "the bone with the socket", &Said::socket},
        Field{"centre", "", "of rotation", &Said::centre},
        Field{"side", "", "of the body", &Said::side},
        Field{"axes", "", "where +x, +y and +z of the meshes point", &Said::axes},
        Field{"landmarks", "", "what they say; null without", &Said::landmarks},
        Field{"cartilage_map", "", "null where the thickness is one number", &Said::cartilage_map},
        Field{"overlap_mm", "mm", "of the surfaces along a ray that is no contact", &Said::overlap_mm},
        Field{"warnings", "", "what may be wrong with what was given, one line each", &Said::warnings}};
  }
};

/// What the meshes are called; the parts as their files are.
struct JointNames {
  std::string ball = "ball";
  std::string socket = "socket";
  std::vector<std::string> ball_parts{};
  std::vector<std::string> socket_parts{};
};

JointDocument describe(const SessionJoint& joint, const JointNames& names);

}  // namespace impinge
