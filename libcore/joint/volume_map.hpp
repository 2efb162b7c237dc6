// SPDX-License-Identifier: GPL-3.0-or-later
// The motion volume as a map over flexion and abduction: how far the femur may be rotated about its axis. The
// program (report/volume_picture.hpp) and the page draw it.
#pragma once

#include <optional>

#include "hip/anatomy.hpp"
#include "rotations/volume.hpp"

namespace impinge {

/// The extent of the map and of each of its squares, degrees.
inline constexpr int kMapStep = 5;
inline constexpr int kMapExtension = -45;  // flexion at the left
inline constexpr int kMapFlexion = 150;
inline constexpr int kMapAbduction = 75;  // at the top; adduction is below

struct MapSquare {
  CellState state = CellState::open;  // of the pose without rotation
  double range_deg = 0.0;  // certainly free range from external to internal rotation, where the pose is free
};

/// The square of the map at a flexion and abduction, degrees. Throws as joint_rotation() does.
MapSquare map_square(const MotionVolume& volume, const Motion& pose, std::optional<Side> side);

}  // namespace impinge
