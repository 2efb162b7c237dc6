// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.hpp"

#include <Eigen/Geometry>

#include "hip/motion.hpp"

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

void add_arrays(const SessionJoint& joint, const VolumeAnswer& found, val& reply) {
  reply.set("flexion", axis_value(kFlexion));
  reply.set("abduction", axis_value(kAbduction));
  reply.set("internal_rotation", axis_value(kRotation));
  reply.set("states", typed_array(states_of(found.volume, joint.side)));
}

void add_arrays(const SessionJoint& joint, const ResectAnswer& found, val& reply) {
  std::vector<Vec3> places;
  places.reserve(found.mesh.vertices.size());
  for (const Vec3& x : found.mesh.vertices) places.emplace_back(x - joint.joint.centre);
  std::vector<std::uint32_t> corners;
  for (const Face& face : found.mesh.faces) corners.insert(corners.end(), face.begin(), face.end());
  reply.set("positions", float_array(places));
  reply.set("faces", typed_array(corners));
  reply.set("depth", float_array(found.depth));
}

void add_arrays(const SessionJoint& /*joint*/, const OrientAnswer& found, val& reply) {
  std::vector<double> squares;
  for (const OrientationCell& cell : found.cells)
    squares.insert(squares.end(),
                   {cell.middle.inclination_deg, cell.middle.anteversion_deg, cell.half_deg,
                    static_cast<double>(cell.state), cell.leg ? static_cast<double>(*cell.leg) : -1.0});
  reply.set("squares", float_array(squares));
}

}  // namespace impinge
