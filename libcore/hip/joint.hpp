// SPDX-License-Identifier: GPL-3.0-or-later
// The two surfaces of a joint about its centre of rotation, and warnings about what is wrong with them.
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
#include "mesh/ball_socket_pair.hpp"
#include "mesh/mesh_parts.hpp"
#include "mesh/star_shape.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/validation.hpp"

namespace impinge {

/// Which faces of a whole bone (hip/whole_bone.hpp) became the surface of the joint.
struct TakenFaces {
  std::size_t faces = 0;             // number of faces taken
  std::size_t of = 0;                // number of faces of the bone
  double within_mm = 0.0;            // all taken faces are this close to the centre
  std::vector<std::uint32_t> given;  // for each face of the bone in the mesh, its index as it was given
};

/// One surface of a joint, and what was found out about it.
struct JointPart {
  TriangleMesh main() const { return main_surface(mesh, parts); }

  TriangleMesh mesh;                  // centre frame, mm
  std::vector<MeshPart> parts;        // of the mesh, behind its main surface
  MeshReport validation;              // what is wrong with the mesh, as it was given
  StarShapeReport star_shape;         // of the main surface about the centre; `edge_on` counts the whole mesh
  std::optional<TakenFaces> taken{};  // the faces of a whole bone that are the main surface
};

struct Joint {
  /// Is there bone beside the main surfaces?
  bool has_parts() const { return !ball.parts.empty() || !socket.parts.empty(); }
  /// The main surfaces.
  BallSocketPair main() const { return {ball.main(), socket.main()}; }
  /// The bone beside them.
  BoneParts beside() const { return bone_parts({ball.mesh, ball.parts}, {socket.mesh, socket.parts}); }

  JointPart ball;                          // about the centre
  JointPart socket;                        // about the centre
  Vec3 centre = Vec3::Zero();              // mm, input frame
  std::optional<SphereFit> fit;            // if the centre was fitted
  std::optional<CartilageMap> cartilage;   // centre frame; none: one thickness everywhere
  double overlap_mm = 0.0;                 // by which the ball was made smaller; see JointInput
  std::string axes = "RAS";                // where +x, +y and +z of the meshes point (hip/anatomy.hpp)
  std::optional<AnatomicalFrames> frames;  // from landmarks; see use_frames()
  /// Do angles count from the neutral pose of a femur's landmarks? Else from the pose of the scan.
  bool from_neutral() const { return frames && frames->femur; }
  std::vector<std::string> warnings;  // one line each; those that make the joint itself doubtful first
  std::size_t doubts = 0;  // number of warnings that make the joint doubtful: its unit, side or place
};

/// A mesh in the input frame, mm, and what messages call it.
struct NamedMesh {
  std::string name;                       // such as that of its file
  TriangleMesh mesh;                      // mm, input frame
  std::vector<MeshPart> parts{};          // of the mesh, behind its main surface
  std::vector<std::string> part_names{};  // what messages call each part; `name` where there is none
};

/// How the calling program names its inputs, so that messages tell its user what to do.
struct JointWording {
  std::string centre = "with --centre X,Y,Z";               // how a centre is given
  std::string meshes = "the files of --ball and --socket";  // how the two meshes are given
  /// How side and axes are given. Axes come first: to change the side where the axes are wrong would swap
  /// front and back.
  std::string side = "--axes first (3D Slicer and DICOM have LPS), then --side";
  std::string keep = "--keep largest";  // how all but the largest piece of a mesh are left out
};

/// The inputs of assemble_joint().
struct JointInput {
  NamedMesh ball;              // may hold more than the ball
  NamedMesh socket;            // in the same frame
  std::optional<Vec3> centre;  // mm, input frame; fitted to the ball if not given
  std::optional<Side> side;    // of the body; unknown if not given
  std::string axes = "RAS";    // where +x, +y and +z of the meshes point (hip/anatomy.hpp)
  JointWording wording;        // of messages
  /// How deep the surfaces may overlap along a ray before this counts as contact, mm. After all checks the
  /// ball with its parts is made smaller by this length along each ray.
  double overlap_mm = 0.0;
};

/// Puts both meshes into the centre frame and examines them. Of a whole bone (whole_bone.hpp) the faces of
/// the joint become the main surface, in their given order, and the rest becomes its first part. The mesh
/// stays as it is where no such faces are found or where the sphere that fits the ball does not hold the
/// given centre. Throws std::runtime_error, one line with the name of the mesh and what to do, if one mesh is
/// given for both, no sphere fits the ball, the centre is outside the ball, no ray from the centre meets the
/// socket, the two are swapped (arrangement.hpp), or one of them is in another unit of length
/// (length_unit.hpp). It warns of a size that no human joint has in mm, a socket lateral to the ball
/// (left and right mixed up) or far from it, a ball that is only a cap, a given centre far from the centre of
/// the fitted sphere, meshes of several pieces, and faulty faces. All but the last two are checked on the
/// main surfaces alone.
Joint assemble_joint(JointInput input);

/// The joint without its parts.
Joint without_parts(Joint joint);

/// The joint with its socket's main surface made whole again, as it was given.
Joint with_whole_socket(Joint joint);

/// Throws std::runtime_error, one line that begins with `ball`, the name of its mesh, if no joint has the
/// radius of its fitted sphere in mm (wrong_unit() in length_unit.hpp). A page that asks for the unit instead
/// leaves this out.
void require_mm(const Joint& joint, const std::string& ball);

/// Throws std::runtime_error, one line, if parts of bone were given beside the joint. `what` names the
/// question, which takes only the main surfaces into account.
void require_no_parts(const Joint& joint, const std::string& what);

/// Makes the pelvic frame the joint frame. If `frames` has a femur, the ball's mesh is turned to be aligned
/// with the pelvis, so that all angles are 0 there.
void use_frames(Joint& joint, const AnatomicalFrames& frames);

}  // namespace impinge
