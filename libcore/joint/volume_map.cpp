// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/volume_map.hpp"

#include <Eigen/Geometry>

#include "hip/motion.hpp"

namespace impinge {

MapSquare map_square(const MotionVolume& volume, const Motion& pose, std::optional<Side> side) {
  const Eigen::Quaterniond q(joint_rotation(pose, side));
  MapSquare square{volume.at({q.w(), q.x(), q.y(), q.z()}).state};
  if (square.state != CellState::free) return square;
  for (const char* way : {"internal_rotation", "external_rotation"})
    square.range_deg += volume.limit(joint_turn(pose, motion_name(way), side), 90.0).low_deg;
  return square;
}

}  // namespace impinge
