// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of the files written for a pose. Positions are those of the pose, in the input frame, mm.
#pragma once

#include <string>

#include "joint/pose_answer.hpp"

namespace impinge {

std::string gaps_csv(const SessionJoint& joint, const PoseAnswer& found);  // as hip/gap_files.hpp has it

/// CSV surface,vertex,gap_mm,distance_lower_mm,distance_upper_mm; `found` must have distances.
std::string distances_csv(const PoseAnswer& found);

/// One surface with its gaps and their colours (mesh/ply_writer.hpp).
std::string surface_ply(const SessionJoint& joint, const PoseAnswer& found, Surface surface);

}  // namespace impinge
