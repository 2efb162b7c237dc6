// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/volume.hpp"

#include <algorithm>

namespace impinge {
namespace {

VolumeStop stop_of(const SessionJoint& joint, const CellTest& test, const MotionVolume& volume,
                   const NamedMotion& motion) {
  const MotionName& growing = motion_name(motion.growing);
  const JointTurn turn = joint_turn(motion.start, growing, joint.side);
  VolumeStop stop{
      &motion, volume.limit(turn, std::min(largest_growth(motion.start, growing), 180.0)), {}, {}};
  if (!stop.limit.stops || stop.limit.stops->hint.socket_face == CellHint::kNone) return stop;
  const CellHint& hint = stop.limit.stops->hint;
  const DirectionFace& socket = test.surface(Surface::socket).faces()[hint.socket_face];
  if (joint.dial)
    stop.hours = joint.dial->hours(socket.range.low * socket.cap.axis + joint.axes * joint.shift);
  stop.on_ball = test.ball_axis(hint);
  return stop;
}

}  // namespace

VolumeAnswer answer_volume(const SessionJoint& joint, const VolumeRequest& request) {
  require_no_parts(joint.joint, "motion volume");
  const CellTest test(
      {in_joint_frame(joint, joint.mesh(Surface::ball)), in_joint_frame(joint, joint.mesh(Surface::socket))},
      request.question);
  VolumeAnswer answer{MotionVolume(test, request.settings), {}};
  if (!joint.side) return answer;
  for (const NamedMotion& motion : named_motions())
    answer.stops.push_back(stop_of(joint, test, answer.volume, motion));
  return answer;
}

}  // namespace impinge
