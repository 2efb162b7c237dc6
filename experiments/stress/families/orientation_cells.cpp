// SPDX-License-Identifier: GPL-3.0-or-later
// A square of the map of orientations (motion/orientation.hpp) about the socket at rest, and a required turn
// whose end brings the tip of a spike of the ball as near to a wall as could be, or past it by as little.
//
// At rest the tip ends at |p| cos(a - A) along the normal of the wall, a its angle to the normal at first and
// A < a that of the turn, which leads straight towards the normal. So the square is not free where that is
// more than the distance d of the wall, and not blocked where it is less. The square is so small that it adds
// nothing to what closeness leaves.
#include <cmath>

#include "motion/orientation.hpp"
#include "stress/spike_in_walls.hpp"

namespace impinge::lab {
namespace {

constexpr double kMapTurn = 0.05;            // radians, A
constexpr double kMapHalf = 0x1p-40;         // degrees, of the square
constexpr CupAngles kMapAtRest{40.0, 15.0};  // degrees

CellState state_of(double length, const Eigen::Matrix3d& rotation) {
  OrientationQuestion question;
  question.legs = {turn_to_wall(kMapTurn, rotation)};
  question.at_rest = kMapAtRest;
  question.least = {kMapAtRest.inclination_deg - kMapHalf, kMapAtRest.anteversion_deg - kMapHalf};
  question.width_deg = question.resolution_deg = 2.0 * kMapHalf;
  return orientation_map(CellTest(spike_in_walls(length, rotation)), question).front().state;
}

// Is a square said to be blocked that is free where the socket rests, or free where it is not?
void judge_square(const Eigen::Matrix3d& rotation, StabilityCase& row) {
  const double touches = kWallDistance / std::cos(kTipTilt - kMapTurn);
  const CellState within = state_of(touches * (1.0 - row.magnitude), rotation);
  const CellState past = state_of(touches * (1.0 + row.magnitude), rotation);
  row.questions += 2;
  for (const CellState state : {within, past}) row.withheld += state == CellState::open ? 1 : 0;
  if (within == CellState::blocked) ++row.wrong;
  if (past == CellState::free) ++row.wrong;
}

}  // namespace

StabilityFamily orientation_cells_family() {
  StabilityFamily family;
  family.name = "orientation_cells";
  family.parameter =
      "distance from contact, as a share of the radius, at the end of a motion that is required";
  family.unit = "1";
  family.expected =
      "no square is free with an orientation in which one touches, none blocked with one in which none does; "
      "very "
      "near to contact some stay open";
  family.threshold = 0.0;
  family.derivation = "what is proven allows for all roundings: nothing is wrong by any";
  family.run = [](const StabilityRun& run) {
    return cases_near_contact(run, "orientation_map", judge_square);
  };
  return family;
}

}  // namespace impinge::lab
