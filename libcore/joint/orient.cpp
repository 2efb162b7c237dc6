// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/orient.hpp"

#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "hip/measure_list.hpp"
#include "joint/measures.hpp"

namespace impinge {
namespace {

// In the order of CellState.
constexpr std::array kAreas{&MapAreas::free, &MapAreas::blocked, &MapAreas::unknown, &MapAreas::open};

bool holds(const OrientationCell& cell, const CupAngles& angles) {
  return std::abs(angles.inclination_deg - cell.middle.inclination_deg) <= cell.half_deg &&
         std::abs(angles.anteversion_deg - cell.middle.anteversion_deg) <= cell.half_deg;
}

// The present angles of the socket: as given, else from measure_hip() if the rim can be trusted.
CupAsScanned as_scanned(const SessionJoint& joint, const OrientRequest& request) {
  if (request.inclination_deg) return {{*request.inclination_deg, *request.anteversion_deg}};
  try {
    const TrustedOpening found = trusted_opening(measured_meshes(joint), *joint.side);
    return {found.angles, found.state};
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string("the socket's ") + error.what() +
                             "; give inclination and anteversion of the socket");
  }
}

std::optional<NearestFree> nearest_free(const SessionJoint& joint, const OrientationQuestion& question,
                                        const std::vector<OrientationCell>& cells) {
  const auto free = nearest_orientation(cells, question.at_rest, {CellState::free});
  if (!free) return std::nullopt;
  NearestFree found{*free, std::nullopt, 0.0};
  found.at_least_deg =
      nearest_orientation(cells, question.at_rest, {CellState::free, CellState::unknown, CellState::open})
          ->turn_deg;
  if (free->turn_deg > 0.0)
    found.axis =
        joint.axes.transpose() * Eigen::AngleAxisd(cup_rotation(free->angles, question.side) *
                                                   cup_rotation(question.at_rest, question.side).transpose())
                                     .axis();
  return found;
}

}  // namespace

OrientAnswer answer(Session& session, const OrientRequest& request) {
  request.check();
  shift_ball(session, Vec3::Zero());
  const SessionJoint& joint = *session.joint;
  if (!joint.side) throw std::invalid_argument("side: an orientation needs to know it; give left or right");
  const CupAsScanned now = as_scanned(joint, request);
  const OrientationQuestion question{.legs = required_legs(request.require, joint.side),
                                     .side = *joint.side,
                                     .at_rest = now,
                                     .tilt_deg = request.tilt_deg,
                                     .resolution_deg = request.resolution_deg};
  const CellTest test = cell_test(joint, joint.mesh(Surface::socket));
  OrientAnswer found{
      .as_scanned = now,
      .nearest_free = {},
      .map = {question.least.inclination_deg, question.least.anteversion_deg, question.width_deg},
      .area_deg2 = {},
      .by_radii = test.bodies().has_radial(),
      .legs = {},
      .cells = orientation_map(test, question)};
  found.map.squares = found.cells.size();
  found.nearest_free = nearest_free(joint, question, found.cells);
  for (const RequiredLeg& leg : question.legs) found.legs.push_back(describe(leg));
  for (const OrientationCell& cell : found.cells) {
    found.area_deg2.*kAreas[static_cast<std::size_t>(cell.state)] += 4.0 * cell.half_deg * cell.half_deg;
    if (holds(cell, question.at_rest)) found.as_scanned.state = cell.state;
  }
  return found;
}

}  // namespace impinge
