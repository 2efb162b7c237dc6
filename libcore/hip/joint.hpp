// SPDX-License-Identifier: GPL-3.0-or-later
// The two surfaces of a joint about its centre of rotation, and what is wrong with them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hip/anatomy.hpp"
#include "hip/cartilage_map.hpp"
#include "hip/landmarks.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/mesh_parts.hpp"
#include "mesh/star_shape.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/validation.hpp"

namespace impinge {

/// What was taken of a whole bone (hip/whole_bone.hpp) as the surface of the joint.
struct TakenFaces {
  std::size_t faces = 0;             // taken
  std::size_t of = 0;                // faces of the bone
  double within_mm = 0.0;            // of the centre
  std::vector<std::uint32_t> given;  // place of each face of the bone as it is in the mesh, as it was given
};

/// One surface of a joint, and what was found out about it.
struct JointPart {
  TriangleMesh mesh;            // centre frame, mm
  std::vector<MeshPart> parts;  // of the mesh, behind its main surface
  MeshReport validation;        // what is wrong with the mesh, as it was given
  StarShapeReport star_shape;   // is the main surface star-shaped about the centre? `edge_on` is of the mesh
  std::optional<TakenFaces> taken{};  // if the mesh is a whole bone: the main surface is these of its faces
};

struct Joint {
  /// Is there bone beside it?
  bool has_parts() const { return !ball.parts.empty() || !socket.parts.empty(); }

  JointPart ball;                          // about the centre
  JointPart socket;                        // about the centre
  Vec3 centre = Vec3::Zero();              // mm, input frame
  std::optional<SphereFit> fit;            // if the centre was fitted
  std::optional<CartilageMap> cartilage;   // centre frame; none: one thickness everywhere
  double overlap_mm = 0.0;                 // by which the ball was made smaller; see JointInput
  std::string axes = "RAS";                // where +x, +y and +z of the meshes point (hip/anatomy.hpp)
  std::optional<AnatomicalFrames> frames;  // from landmarks; see use_frames()
  std::vector<std::string> warnings;       // one line each; those that make the joint itself doubtful first
  std::size_t doubts = 0;                  // number of these: a doubtful unit, side or place
};

/// A mesh in the input frame, mm, and what messages call it.
struct NamedMesh {
  std::string name;                       // such as that of its file
  TriangleMesh mesh;                      // mm, input frame
  std::vector<MeshPart> parts{};          // of the mesh, behind its main surface
  std::vector<std::string> part_names{};  // what messages call each part; `name` where there is none
};

/// What the calling program names its inputs, so that messages tell its user what to do.
struct JointWording {
  std::string centre = "with --centre X,Y,Z";               // how a centre is given
  std::string meshes = "the files of --ball and --socket";  // how the two meshes are given
  /// How side and axes are given. Axes come first: to change the side where the axes are wrong would swap
  /// front and back.
  std::string side = "--axes first (3D Slicer and DICOM have LPS), then --side";
  std::string keep = "--keep largest";  // how all but the largest piece of a mesh are left out
};

/// What a joint is put together from.
struct JointInput {
  NamedMesh ball;              // may hold more than the ball
  NamedMesh socket;            // in the same frame
  std::optional<Vec3> centre;  // mm, input frame; fitted to the ball if not given
  std::optional<Side> side;    // of the body; unknown if not given
  std::string axes = "RAS";    // where +x, +y and +z of the meshes point (hip/anatomy.hpp)
  JointWording wording;        // of messages
  /// How deep the surfaces may overlap along a ray before it is contact: the ball, parts and all, is taken so
  /// much smaller along each ray, after all checks.
  double overlap_mm = 0.0;
};

/// Puts both meshes into the centre frame and examines them. Of a whole bone the faces of the joint become
/// the main surface, in the order that they had, and the rest its first part (whole_bone.hpp), unless it has
/// none or a centre that is given lies outside of the sphere that fits the ball. std::runtime_error, one line
/// with the name of the mesh and what to do, if one mesh is given for both, no sphere fits the ball, the
/// centre is outside of the ball, no ray from the centre meets the socket, the two are swapped
/// (arrangement.hpp), or one of them is in another unit of length (length_unit.hpp). Warnings are given for a
/// size that no human joint has in mm, a socket lateral to the ball (left and right mixed up) or far from it,
/// a ball that is only a cap, a centre that is given far from that of the sphere that fits, meshes of several
/// pieces, and faulty faces. All but the last two are checked on the main surfaces alone.
Joint assemble_joint(JointInput input);

/// The joint without its parts of bone.
Joint without_parts(Joint joint);

/// The joint with the socket's main surface as whole as it was given.
Joint with_whole_socket(Joint joint);

/// std::runtime_error, one line, if the joint has parts of bone that were given beside it; `what` names the
/// question that takes only the main surfaces into account.
void require_no_parts(const Joint& joint, const std::string& what);

/// Makes the pelvic frame the joint frame. If `frames` has a femur, the ball's mesh is turned to be aligned
/// with the pelvis, so that all angles are 0 there.
void use_frames(Joint& joint, const AnatomicalFrames& frames);

}  // namespace impinge
