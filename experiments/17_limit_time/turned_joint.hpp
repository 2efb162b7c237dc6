// SPDX-License-Identifier: GPL-3.0-or-later
// Joints whose limits are timed: a generated hip, whole bones and a replaced hip.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/progress.hpp"
#include "hip/anatomy.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/mesh_parts.hpp"

namespace impinge::lab {

// Meshes in the joint frame about the centre, mm.
struct TurnedJoint {
  std::string name;
  BallSocketPair bones;   // whole, as others' libraries take them
  BallSocketPair main{};  // of whole bones their surfaces of the joint, else the same (hip/whole_bone.hpp)
  BoneParts beside{};
  std::optional<Side> side;

  // What is done once for a joint, by ours.
  TurnLimits limits() const { return TurnLimits(main, beside); }
  std::size_t faces() const { return bones.ball.faces.size() + bones.socket.faces.size(); }
};

// hip_presets.hpp's normal hip, and that of phantoms/implant.hpp, of about so many faces each.
TurnedJoint generated_hip(std::size_t faces);
TurnedJoint replaced_hip(std::size_t faces);

// The joints of a folder (harness/real_joints.hpp) that have a whole femur.ply and pelvis.ply beside their
// cut surfaces, about the centre of the sphere that fits the head.
std::vector<TurnedJoint> whole_joints(const std::filesystem::path& folder, Progress& progress);

}  // namespace impinge::lab
