// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/orient.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "hip/hip_measures.hpp"
#include "hip/sphere_fit.hpp"
#include "joint/volume.hpp"

namespace impinge {
namespace {

// In the order of CellState.
constexpr std::array kAreas{&MapAreas::free, &MapAreas::blocked, &MapAreas::unknown, &MapAreas::open};

bool holds(const OrientationCell& cell, const CupAngles& angles) {
  return std::abs(angles.inclination_deg - cell.middle.inclination_deg) <= cell.half_deg &&
         std::abs(angles.anteversion_deg - cell.middle.anteversion_deg) <= cell.half_deg;
}

}  // namespace

OrientAnswer answer(Session& session, const OrientRequest& request) {
  request.check();
  const SessionJoint& joint = *session.joint;
  if (!joint.side) throw std::invalid_argument("side: an orientation needs to know it; give left or right");
  OrientationQuestion question{.legs = required_legs(request.require, joint.side),
                               .side = *joint.side,
                               .at_rest = {},
                               .tilt_deg = request.tilt_deg,
                               .resolution_deg = request.resolution_deg};
  question.at_rest =
      cup_angles(measure_acetabulum(in_joint_frame(joint, joint.main(Surface::socket)),
                                    fit_ball(in_joint_frame(joint, joint.main(Surface::ball))), question.side)
                     .opening,
                 question.side);
  OrientAnswer found{
      .as_scanned = {question.at_rest.inclination_deg, question.at_rest.anteversion_deg},
      .map = {question.least.inclination_deg, question.least.anteversion_deg, question.width_deg},
      .area_deg2 = {},
      .legs = {},
      .cells = orientation_map(cell_test(joint, joint.mesh(Surface::socket)), question)};
  found.map.squares = found.cells.size();
  for (const RequiredLeg& leg : question.legs) found.legs.push_back(describe(leg));
  for (const OrientationCell& cell : found.cells) {
    found.area_deg2.*kAreas[static_cast<std::size_t>(cell.state)] += 4.0 * cell.half_deg * cell.half_deg;
    if (holds(cell, question.at_rest)) found.as_scanned.state = cell.state;
  }
  return found;
}

}  // namespace impinge
