// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.hpp"

#include "joint/touch.hpp"
#include "joint/volume_map.hpp"

namespace impinge {

void add_arrays(const SessionJoint& joint, const VolumeAnswer& found, val& reply) {
  std::vector<double> ranges;
  for (int flexion = kMapExtension; flexion < kMapFlexion; flexion += kMapStep) {
    for (int abduction = -kMapAbduction; abduction < kMapAbduction; abduction += kMapStep) {
      const MapSquare square =
          map_square(found.volume, {flexion + 0.5 * kMapStep, abduction + 0.5 * kMapStep, 0.0}, joint.side);
      ranges.push_back(square.state == CellState::free      ? square.range_deg
                       : square.state == CellState::blocked ? -1.0
                                                            : -2.0);
    }
  }
  reply.set("map",
            object(std::pair("range_deg", float_array(ranges)), std::pair("step", kMapStep),
                   std::pair("flexion", val::array(std::vector<int>{kMapExtension, kMapFlexion})),
                   std::pair("abduction", val::array(std::vector<int>{-kMapAbduction, kMapAbduction}))));
}

void add_arrays(const SessionJoint& joint, const ResectAnswer& found, val& reply) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // the ball is drawn as landmarks have turned it
  if (found.surface == Surface::ball) turn = scanned_pose(joint).rotation.transpose();
  std::vector<Vec3> places;
  places.reserve(found.mesh.vertices.size());
  for (const Vec3& x : found.mesh.vertices) places.emplace_back(turn * (x - joint.joint.centre));
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
