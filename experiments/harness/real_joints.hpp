// SPDX-License-Identifier: GPL-3.0-or-later
// A user's real ball-and-socket joints, found by joint/joint_folder.hpp, with their meshes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/driver.hpp"
#include "hip/anatomy.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// A joint, as its folder describes it.
struct RealJoint {
  std::string subject;           // name of its folder
  BallSocketPair meshes;         // in the centre frame, mm
  Vec3 centre;                   // of rotation, in the input frame, mm
  bool described = false;        // does the description give the centre?
  std::optional<double> radius;  // of the head, from the description, mm
  std::optional<Side> side;      // from the description
  std::string axes = "RAS";      // where +x, +y and +z of the meshes point, as agreed_axes_of() finds it
};

// The joints of a folder, in the order of their names, without what lies beside them. Leaves out folders
// without a mesh, and says so in `progress`. Throws std::runtime_error for a file that cannot be used, or if
// no joint is left.
std::vector<RealJoint> read_real_joints(const std::filesystem::path& folder, Progress& progress);

// Both meshes in the joint frame (x right, y anterior, z superior) about the centre.
BallSocketPair in_joint_frame(const RealJoint& joint);

}  // namespace impinge::lab
