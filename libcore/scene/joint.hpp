// SPDX-License-Identifier: GPL-3.0-or-later
// The two surfaces of a joint about its centre of rotation, and what is wrong with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "joint/cartilage_map.hpp"
#include "joint/sphere_fit.hpp"
#include "mesh/star_shape.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/validation.hpp"
#include "scene/options.hpp"

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

// Reads and examines both meshes. FileError for a file that cannot be used; std::runtime_error, one line
// with the file and what to do, where the centre is not inside the ball, the socket is not round it, the two
// have changed places (arrangement.hpp), or one of them is in another unit of length (length_unit.hpp). A
// joint of a size that none has in mm gets a warning, and so does a socket on the lateral side of the ball,
// as if left and right were mixed up.
Joint load_joint(const SceneOptions& options);

}  // namespace impinge
