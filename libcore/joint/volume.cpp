// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/volume.hpp"

#include <algorithm>
#include <utility>

namespace impinge {
namespace {

VolumeStop stop_of(const SessionJoint& joint, const CellTest& test, const MotionVolume& volume,
                   const NamedMotion& motion) {
  const MotionName& growing = motion_name(motion.growing);
  const JointTurn turn = joint_turn(motion.start, growing, joint.side);
  VolumeStop stop{&motion, volume.limit(turn, std::min(largest_growth(motion.start, growing), 180.0))};
  if (!stop.limit.stops) return stop;
  const CellHint& hint = stop.limit.stops->hint;
  if (hint.socket_face == CellHint::kNone) {
    if (const auto pair = test.bodies().may_meet(test.poses_near(ball_about(stop.limit.stops->cell)), true)) {
      stop.ball_part = body_name(joint.joint.ball.parts, pair->ball);
      stop.socket_part = body_name(joint.joint.socket.parts, pair->socket);
    }
    return stop;
  }
  const DirectionFace& socket = test.surface(Surface::socket).faces()[hint.socket_face];
  if (joint.dial)
    stop.hours = joint.dial->hours(socket.range.low * socket.cap.axis + joint.axes * joint.shift);
  stop.on_ball = test.ball_axis(hint);
  return stop;
}

}  // namespace

CellTest cell_test(const SessionJoint& joint, const TriangleMesh& socket, const CellQuestion& question) {
  const JointPart& of_ball = joint.joint.ball;
  const TriangleMesh ball = in_joint_frame(joint, of_ball.mesh);
  const TriangleMesh facing = in_joint_frame(joint, socket);
  const std::vector<MeshPart>& of_socket = joint.joint.socket.parts;
  return {{main_surface(ball, of_ball.parts), main_surface(facing, of_socket)},
          question,
          bone_parts({ball, of_ball.parts}, {facing, of_socket})};
}

VolumeAnswer answer_volume(const SessionJoint& joint, const VolumeRequest& request) {
  const CellTest test = cell_test(joint, joint.mesh(Surface::socket), request.question);
  VolumeAnswer answer{MotionVolume(test, request.settings), {}};
  if (!joint.side) return answer;
  for (const NamedMotion& motion : named_motions())
    answer.stops.push_back(stop_of(joint, test, answer.volume, motion));
  return answer;
}

}  // namespace impinge
