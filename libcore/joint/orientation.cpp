// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/orientation.hpp"

#include <cmath>
#include <stdexcept>

#include "hip/hip_measures.hpp"
#include "hip/sphere_fit.hpp"
#include "joint/volume.hpp"

namespace impinge {
namespace {

double& area_of(OrientationAnswer& answer, CellState state) {
  switch (state) {
    case CellState::free:
      return answer.free;
    case CellState::blocked:
      return answer.blocked;
    case CellState::unknown:
      return answer.unknown;
    case CellState::open:
      break;
  }
  return answer.open;
}

bool holds(const OrientationCell& cell, const CupAngles& angles) {
  return std::abs(angles.inclination_deg - cell.middle.inclination_deg) <= cell.half_deg &&
         std::abs(angles.anteversion_deg - cell.middle.anteversion_deg) <= cell.half_deg;
}

}  // namespace

OrientationAnswer answer_orientation(Session& session, const OrientationRequest& request) {
  const SessionJoint& joint = *session.joint;
  if (!joint.side) throw std::invalid_argument("an orientation needs to know the side; give left or right");
  OrientationAnswer answer;
  OrientationQuestion& question = answer.question;
  question.legs = required_legs(request.required, joint.side);
  question.side = joint.side.value();
  question.at_rest =
      cup_angles(measure_acetabulum(in_joint_frame(joint, joint.main(Surface::socket)),
                                    fit_ball(in_joint_frame(joint, joint.main(Surface::ball))), question.side)
                     .opening,
                 question.side);
  question.tilt_deg = request.tilt_deg;
  question.resolution_deg = request.resolution_deg;
  answer.cells = orientation_map(cell_test(joint, joint.mesh(Surface::socket)), question);
  for (const OrientationCell& cell : answer.cells) {
    area_of(answer, cell.state) += 4.0 * cell.half_deg * cell.half_deg;
    if (holds(cell, question.at_rest)) answer.as_scanned = cell.state;
  }
  return answer;
}

}  // namespace impinge
