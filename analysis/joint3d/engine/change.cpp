// SPDX-License-Identifier: GPL-3.0-or-later
#include "change.hpp"

namespace impinge {

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
