// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest gap of a pose, found without looking at most vertices and faces.
#pragma once

#include <optional>

#include "contact/culled_joint.hpp"
#include "gap/pose.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge {

/// The smallest radial gap of a pose and its vertex.
struct PosedGap {
  LeastGap least;
  double bound_mm = 0.0;      // proven bound on the error of that vertex's gap; infinite if nothing is proven
  Vec3 place = Vec3::Zero();  // of the vertex, posed, centre frame of the socket, mm
};

/// None where the surfaces do not face each other. `joint` is of these meshes.
std::optional<PosedGap> posed_gap(const CulledJoint& joint, const BallSocketPair& meshes, const Pose& pose);

}  // namespace impinge
