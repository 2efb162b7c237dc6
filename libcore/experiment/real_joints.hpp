// SPDX-License-Identifier: GPL-3.0-or-later
// Real ball-and-socket joints that a user brings: a folder with one folder a subject, each with
//   femoral_head.ply or humeral_head.ply            the ball
//   acetabulum_facing.ply or glenoid_facing.ply     the socket, its inner surface
//   subject.json                                    with the centre of rotation, "center_of_rotation_mm": [x,
//   y, z]
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/progress.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge {

struct RealJoint {
  std::string subject;    // name of its folder
  BallSocketPair meshes;  // in the centre frame, mm
};

// In the order of their names. A folder that lacks a file is left out, and the progress says so. Throws
// std::runtime_error for a file that cannot be used, or when no joint is left.
std::vector<RealJoint> read_real_joints(const std::filesystem::path& folder, Progress& progress);

}  // namespace impinge
