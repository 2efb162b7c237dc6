// SPDX-License-Identifier: GPL-3.0-or-later
// Real ball-and-socket joints that a user brings, as joint/joint_folder.hpp finds them, with their meshes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/driver.hpp"
#include "hip/anatomy.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// One joint, as its folder describes it.
struct RealJoint {
  std::string subject;           // name of its folder
  BallSocketPair meshes;         // in the centre frame, mm
  Vec3 centre;                   // of rotation, in the input frame, mm
  bool described = false;        // is the centre that of the description?
  std::optional<double> radius;  // of the head, from the description, mm
  std::optional<Side> side;      // from the description
  std::string axes = "RAS";      // where +x, +y and +z of the meshes point (hip/anatomy.hpp)
};

// The joints of a folder, in the order of their names. A folder that lacks a mesh is left out, and `progress`
// says so. Throws std::runtime_error for a file that cannot be used, or if no joint is left.
std::vector<RealJoint> read_real_joints(const std::filesystem::path& folder, Progress& progress);

// Both meshes in the joint frame (x right, y anterior, z superior) about the centre.
BallSocketPair in_joint_frame(const RealJoint& joint);

}  // namespace impinge::lab
