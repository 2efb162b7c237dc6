// SPDX-License-Identifier: GPL-3.0-or-later
// A turn that brings the tip of a spike of the ball to a wall of the socket, as near to the clearance that is
// asked for as could be, or past it by as little: has the spike to be cut, and by how much
// (motion/resection.hpp)?
//
// From the angle a between the tip and the normal of the wall, at the distance d, the turn leads straight
// towards the normal, by A < a. The wall is nearest along the tip's ray at the end, E = d / cos(a - A). The
// tip is the farthest of the spike beyond what may stay, since along the spike the radius falls off much
// faster than E: the depth of the cut is |p| - (E - c), c the clearance, and none where that is below 0.
#include <cmath>

#include "motion/resection.hpp"
#include "stress/spike_in_walls.hpp"

namespace impinge::lab {
namespace {

constexpr double kCutTurn = 0.05;       // radians, A
constexpr double kCutClearance = 0.5;   // mm
constexpr double kCutLeast = 1e-6;      // mm3, how near the ends of the volume are to come
constexpr double kCutRounding = 1e-13;  // mm, of the expected depth itself

double may_stay() { return kWallDistance / std::cos(kTipTilt - kCutTurn) - kCutClearance; }

Resection cut_of(double length, const Eigen::Matrix3d& rotation) {
  const BallSocketPair joint = spike_in_walls(length, rotation);
  return least_radial_cut(joint.ball, SweptRadius(joint.socket, {turn_to_wall(kCutTurn, rotation)}),
                          {.clearance_mm = kCutClearance, .least_mm3 = kCutLeast});
}

// Is a spike that may stay said to need a cut, or one that must be cut, said to need none or another one?
void judge_cut(const Eigen::Matrix3d& rotation, StabilityCase& row) {
  const double depth = row.magnitude * may_stay();
  const Resection none = cut_of(may_stay() - depth, rotation);
  const Resection some = cut_of(may_stay() + depth, rotation);
  row.questions += 2;
  if (!none.empty()) ++row.withheld;
  if (none.volume_mm3.low > 0.0 || none.depth_mm.low > 0.0) ++row.wrong;
  if (some.empty() || some.depth_mm.low > depth + kCutRounding || some.depth_mm.high < depth - kCutRounding)
    ++row.wrong;
}

}  // namespace

StabilityFamily radial_cut_family() {
  StabilityFamily family;
  family.name = "radial_cut";
  family.parameter =
      "depth of the least cut, or of what is left to spare, as a share of the radius at the end of a "
      "required motion";
  family.unit = "1";
  family.expected =
      "what may stay is never said to have to go, what must go is, and its depth lies between the ends; very "
      "near "
      "to none a cut may stay possible";
  family.threshold = 0.0;
  family.derivation = "what is proven allows for all roundings: nothing is wrong by any";
  family.run = [](const StabilityRun& run) { return cases_near_contact(run, "least_radial_cut", judge_cut); };
  return family;
}

}  // namespace impinge::lab
