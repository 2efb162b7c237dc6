// SPDX-License-Identifier: GPL-3.0-or-later
// The two surfaces of a joint about its centre of rotation, and what is wrong with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hip/anatomy.hpp"
#include "hip/cartilage_map.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/star_shape.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/validation.hpp"

namespace impinge {

/// One surface of a joint, and what was found out about it.
struct JointPart {
  TriangleMesh mesh;           // centre frame, mm
  MeshReport validation;       // what is wrong with the mesh
  StarShapeReport star_shape;  // is it star-shaped about the centre?
};

struct Joint {
  JointPart ball;                         // about the centre
  JointPart socket;                       // about the centre
  Vec3 centre = Vec3::Zero();             // mm, input frame
  std::optional<SphereFit> fit;           // if the centre was fitted
  std::optional<CartilageMap> cartilage;  // centre frame; none where it is as thick everywhere
  std::vector<std::string> warnings;      // one line each
};

/// A mesh in the input frame, mm, and what messages call it.
struct NamedMesh {
  std::string name;   // such as that of its file
  TriangleMesh mesh;  // mm, input frame
};

/// How the program that asks says things, so that a message tells what to do there.
struct JointWording {
  std::string centre = "with --centre X,Y,Z";               // how a centre is given
  std::string meshes = "the files of --ball and --socket";  // how the two meshes are given
  std::string side = "--side and --axes";                   // how side and axes are given
};

/// What a joint is put together from.
struct JointInput {
  NamedMesh ball;              // may hold more than the ball
  NamedMesh socket;            // in the same frame
  std::optional<Vec3> centre;  // mm, input frame; fitted to the ball if not given
  std::optional<Side> side;    // of the body; unknown if not given
  std::string axes = "RAS";    // where +x, +y and +z of the meshes point (hip/anatomy.hpp)
  JointWording wording;        // of messages
};

/// Examines both meshes about the centre. std::runtime_error, one line with the name of the mesh and what to
/// do, where one mesh is given for both, no sphere fits the ball, the centre is outside of the ball, the
/// socket is not round it, the two have changed places (arrangement.hpp), or one of them is in another unit
/// of length (length_unit.hpp). A ball that is a cap, one of a size that no human joint has in mm, and a
/// socket on the lateral side of the ball, as if left and right were mixed up, get a warning.
Joint assemble_joint(JointInput input);

}  // namespace impinge
