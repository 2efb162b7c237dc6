// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume.hpp"

#include <Eigen/Geometry>

#include "hip/motion.hpp"
#include "joint/volume.hpp"

namespace impinge {
namespace {

// Angles of the poses that are looked up, degrees.
struct Axis {
  double least;
  double step;
  int count;
  double at(int k) const { return least + k * step; }
};
constexpr Axis kFlexion{-40.0, 4.0, 46};
constexpr Axis kAbduction{-60.0, 4.0, 36};
constexpr Axis kRotation{-90.0, 3.0, 61};

val axis_value(const Axis& axis) {
  return object(std::pair("least", axis.least), std::pair("step", axis.step), std::pair("count", axis.count));
}

std::uint8_t state_at(const MotionVolume& volume, const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  const VolumeCell cell = volume.at({q.w(), q.x(), q.y(), q.z()});
  if (cell.reachable) return 2;
  return cell.within_reach ? 1 : 0;
}

std::vector<std::uint8_t> states_of(const MotionVolume& volume, std::optional<Side> side) {
  std::vector<std::uint8_t> states;
  for (int f = 0; f < kFlexion.count; ++f) {
    for (int a = 0; a < kAbduction.count; ++a) {
      for (int r = 0; r < kRotation.count; ++r) {
        const Motion motion{kFlexion.at(f), kAbduction.at(a), kRotation.at(r)};
        states.push_back(state_at(volume, joint_rotation(motion, side)));
      }
    }
  }
  return states;
}

}  // namespace

val volume_reply(const SessionJoint& joint, double width) {
  const MotionVolume volume(cell_test(joint, joint.joint.socket.mesh), {.width = width, .threads = 1});
  const VolumeShares& found = volume.shares();
  return object(
      std::pair("low", found.low()), std::pair("high", found.high()),
      std::pair("reachable_low", found.reachable_low), std::pair("reachable_high", found.reachable_high),
      std::pair("cells", static_cast<double>(found.cells)), std::pair("flexion", axis_value(kFlexion)),
      std::pair("abduction", axis_value(kAbduction)), std::pair("internal_rotation", axis_value(kRotation)),
      std::pair("states", typed_array(states_of(volume, joint.side))));
}

}  // namespace impinge
