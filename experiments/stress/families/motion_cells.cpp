// SPDX-License-Identifier: GPL-3.0-or-later
// All rotations near one, of which the farthest brings the tip of a spike of the ball as near to a wall of
// the socket as could be, or past it by as little: is the joint free in all of them, or blocked? The volume,
// the map of orientations and required motions rest on that test (motion/cell_test.hpp).
//
// With a the angle from the tip p to the normal of the wall, at the distance d, turns by up to rho bring it
// to |p| cos(a - rho) along the normal at most and to |p| cos(a + rho) at least: all are free if that most is
// below d, all blocked if that least is not.
#include <cmath>

#include "motion/cell_test.hpp"
#include "stress/spike_in_walls.hpp"

namespace impinge::lab {
namespace {

constexpr double kCellReach = 0.05;  // radians, about rho

// A joint whose rotations are free, or blocked, up to a reach that is known.
class EdgeOfContact {
 public:
  EdgeOfContact(CellState state, const Eigen::Matrix3d& rotation) : state_(state), rotation_(rotation) {}

  // Are all rotations that come that share less far than contact said to be otherwise, or those
  // that go as much farther said to be so?
  void judge(StabilityCase& row) {
    const CellState within = decide(row.magnitude);
    const CellState past = decide(-row.magnitude);
    row.questions += 2;
    if (within == CellState::open) ++row.withheld;
    if (within != CellState::open && within != state_) ++row.wrong;
    if (past == state_) ++row.wrong;
  }

 private:
  bool blocked() const { return state_ == CellState::blocked; }
  double end() const { return blocked() ? kTipTilt + kCellReach : kTipTilt - kCellReach; }
  double length() const { return kWallDistance / std::cos(end()); }

  CellState decide(double closeness) {
    const double height = kWallDistance * (blocked() ? 1.0 + closeness : 1.0 - closeness);
    const double angle = std::acos(height / length());
    return search_.decide({rotation_, blocked() ? angle - kTipTilt : kTipTilt - angle}).state;
  }

  CellState state_;
  Eigen::Matrix3d rotation_;
  CellTest test_{spike_in_walls(length(), rotation_)};
  CellSearch search_{test_};
};

void judge_cells(const Eigen::Matrix3d& rotation, StabilityCase& row) {
  for (const CellState state : {CellState::free, CellState::blocked})
    EdgeOfContact(state, rotation).judge(row);
}

}  // namespace

StabilityFamily motion_cells_family() {
  StabilityFamily family;
  family.name = "motion_cells";
  family.parameter =
      "distance from contact, as a share of the radius, at the end of all rotations that are decided at once";
  family.unit = "1";
  family.expected =
      "no rotations are free of which one touches, none blocked of which one is free; very near to contact "
      "some stay open";
  family.threshold = 0.0;
  family.derivation = "what is proven allows for all roundings: nothing is wrong by any";
  family.run = [](const StabilityRun& run) { return cases_near_contact(run, "motion_cells", judge_cells); };
  return family;
}

}  // namespace impinge::lab
