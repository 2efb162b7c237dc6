// SPDX-License-Identifier: GPL-3.0-or-later
// The two surfaces of a joint about its centre of rotation, and what is wrong with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "joint/anatomy.hpp"
#include "joint/cartilage_map.hpp"
#include "joint/sphere_fit.hpp"
#include "mesh/star_shape.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/validation.hpp"

namespace impinge {

struct JointPart {
  TriangleMesh mesh;  // centre frame, mm
  MeshReport validation;
  StarShapeReport star_shape;
};

struct Joint {
  JointPart ball;
  JointPart socket;
  Vec3 centre = Vec3::Zero();             // mm, input frame
  std::optional<SphereFit> fit;           // if the centre was fitted
  std::optional<CartilageMap> cartilage;  // centre frame; none where it is as thick everywhere
  std::vector<std::string> warnings;
};

// A mesh in the input frame, mm, and what messages call it.
struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

// How the program that asks says things, so that a message tells what to do there.
struct JointWording {
  std::string centre = "with --centre X,Y,Z";  // how a centre is given
  std::string meshes = "the files of --ball and --socket";
  std::string side = "--side and --axes";
};

struct JointInput {
  NamedMesh ball;
  NamedMesh socket;
  std::optional<Vec3> centre;  // mm, input frame; fitted to the ball if not given
  std::optional<Side> side;
  std::string axes = "RAS";
  JointWording wording;
};

// Examines both meshes about the centre. std::runtime_error, one line with the name of the mesh and what to
// do, where no sphere fits the ball, the centre is not inside the ball, the socket is not round it, the two
// have changed places (arrangement.hpp), or one of them is in another unit of length (length_unit.hpp). A
// joint of a size that none has in mm gets a warning, and so does a socket on the lateral side of the ball,
// as if left and right were mixed up.
Joint assemble_joint(JointInput input);

}  // namespace impinge
