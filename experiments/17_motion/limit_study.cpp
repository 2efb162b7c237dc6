// SPDX-License-Identifier: GPL-3.0-or-later
#include "17_motion/limit_study.hpp"

#include "hip/sphere_fit.hpp"

namespace impinge::lab {
namespace {

// A joint that turns about one centre.
struct CentredJoint {
  CentredJoint(const StudiedJoint& joint, CentreStrategy strategy)
      : shift(strategy == CentreStrategy::socket ? fit_ball(joint.meshes.socket).centre : Vec3::Zero()),
        dial(clock_face(joint.meshes.socket)),
        limits({joint.meshes.ball, relative_to(joint.meshes.socket, shift)}) {}

  std::string clock(const Vec3& place) const { return dial ? clock_text(dial->hours(place)) : ""; }

  Vec3 shift;
  std::optional<ClockFace> dial;
  TurnLimits limits;
};

// True if the motion needs no side, or the side is known.
bool is_known(const NamedMotion& motion, const std::optional<Side>& side) {
  return side || motion_name(motion.growing).angle == &Motion::flexion;
}

LimitCase limit_of(const StudiedJoint& joint, const CentredJoint& centred, const NamedMotion& motion,
                   double gap_mm) {
  const MotionName& growing = motion_name(motion.growing);
  const JointTurn turn = joint_turn(motion.start, growing, joint.side);
  const double largest = largest_growth(motion.start, growing);
  LimitCase found;
  found.joint = joint.name;
  found.motion = &motion;
  found.shift_mm = centred.shift.norm();
  // The effect of another centre is worked out for contact only, to save time.
  if (gap_mm == 0.0)
    found.told = told_limit(centred.limits, turn, 0.0, largest);
  else
    found.told = {gap_mm, centred.limits.gap_of(turn, gap_mm, largest), {}, {}, {}};
  const TurnLimit& limit = found.told.limit;
  if (limit.contact) found.clock = centred.clock(limit.contact->place);
  const auto smallest = centred.limits.smallest_gap(turn, limit.low_deg);
  if (smallest) found.smallest_gap = smallest->gap_mm;
  return found;
}

}  // namespace

std::vector<LimitCase> limits_of(const StudiedJoint& joint, const std::vector<double>& gaps_mm) {
  std::vector<LimitCase> cases;
  for (const CentreStrategy strategy : {CentreStrategy::head, CentreStrategy::socket}) {
    const CentredJoint centred(joint, strategy);
    const auto add = [&](const NamedMotion& motion, double gap) {
      if (!is_known(motion, joint.side)) return;
      cases.push_back(limit_of(joint, centred, motion, gap));
      cases.back().centre = strategy;
    };
    for (const NamedMotion& motion : named_motions()) add(motion, 0.0);
    if (strategy == CentreStrategy::socket) continue;
    for (const double gap : gaps_mm) {
      for (const NamedMotion& motion : named_motions()) add(motion, gap);
    }
  }
  return cases;
}

}  // namespace impinge::lab
