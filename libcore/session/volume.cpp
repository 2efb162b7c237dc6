// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/volume.hpp"

#include <algorithm>
#include <utility>

namespace impinge {
namespace {

std::vector<TriangleMesh> parts_of(const SessionJoint& joint, const TriangleMesh& mesh,
                                   const std::vector<MeshPart>& parts) {
  std::vector<TriangleMesh> surfaces = part_surfaces(mesh, parts);
  for (TriangleMesh& surface : surfaces) surface = in_joint_frame(joint, std::move(surface));
  return surfaces;
}

VolumeStop stop_of(const SessionJoint& joint, const CellTest& test, const MotionVolume& volume,
                   const NamedMotion& motion) {
  const MotionName& growing = motion_name(motion.growing);
  const JointTurn turn = joint_turn(motion.start, growing, joint.side);
  VolumeStop stop{&motion, volume.limit(turn, std::min(largest_growth(motion.start, growing), 180.0))};
  if (!stop.limit.stops) return stop;
  const CellHint& hint = stop.limit.stops->hint;
  if (hint.socket_face == CellHint::kNone) {
    if (const auto pair = test.beside().may_meet(test.poses_near(ball_about(stop.limit.stops->cell)))) {
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
  const JointPart& ball = joint.joint.ball;
  const std::vector<MeshPart>& of_socket = joint.joint.socket.parts;
  return {{in_joint_frame(joint, main_surface(ball.mesh, ball.parts)),
           in_joint_frame(joint, main_surface(socket, of_socket))},
          question,
          {parts_of(joint, ball.mesh, ball.parts), parts_of(joint, socket, of_socket)}};
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
