// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/volume.hpp"

#include <algorithm>

#include "hip/named_motion.hpp"
#include "joint/touch.hpp"

namespace impinge {
namespace {

VolumeMotion motion_in(const MotionVolume& volume, const SessionJoint& joint, const CellTest& test,
                       const NamedMotion& motion) {
  const JointTurn turn = joint_turn(motion.start, motion_name(motion.growing), joint.side);
  const VolumeLimit limit =
      volume.limit(turn, std::min(largest_growth(motion.start, motion_name(motion.growing)), 180.0));
  VolumeMotion found;
  found.motion = motion.name;
  found.low_deg = limit.low_deg;
  found.high_deg = limit.high_deg;
  if (!limit.stops) return found;
  const CellHint& hint = limit.stops->hint;
  if (hint.socket_face == CellHint::kNone) {
    const Vec3 shift = shift_of(hint, test.question().play_mm);
    const NearPoses poses = test.poses_near(ball_about(limit.stops->cell), shift);
    if (const auto pair = test.bodies().may_meet(poses, true)) {
      found.ball_part = body_name(joint.joint.ball.parts, pair->ball);
      found.socket_part = body_name(joint.joint.socket.parts, pair->socket);
    }
    return found;
  }
  const DirectionFace& socket = test.surface(Surface::socket).faces()[hint.socket_face];
  if (joint.dial) found.clock = clock_text(joint.dial->hours(socket.range.low * socket.cap.axis));
  found.ball_direction = test.ball_axis(hint);
  return found;
}

}  // namespace

VolumeRow volume_row(const VolumeCell& at) {
  const Quaternion4 q = centre(at.cell);
  VolumeRow row{.level = at.cell.level,
                .cell = at.cell.number,
                .w = q[0],
                .x = q[1],
                .y = q[2],
                .z = q[3],
                .radius_deg = angular_radius(at.cell) / kDegree,
                .share = share(at.cell),
                .state = name(at.state),
                .reachable = at.reachable};
  if (!at.reachable && at.within_reach) row.reachable.reset();
  row.free = at.state == CellState::free ? row.share : at.part != nullptr ? at.part->free_share : 0.0;
  row.blocked = at.state == CellState::blocked ? row.share
                : at.part != nullptr           ? at.part->blocked_share
                                               : 0.0;
  return row;
}

ShiftRow shift_row(const VolumeCell& at) {
  if (!at.shift) return {};
  return {at.shift->x(), at.shift->y(), at.shift->z()};
}

CellTest cell_test(const SessionJoint& joint, const TriangleMesh& socket, const CellQuestion& question) {
  const JointPart& of_ball = joint.joint.ball;
  const TriangleMesh ball = in_joint_frame(joint, of_ball.mesh);
  const TriangleMesh facing = in_joint_frame(joint, socket);
  const std::vector<MeshPart>& of_socket = joint.joint.socket.parts;
  return {{main_surface(ball, of_ball.parts), main_surface(facing, of_socket)},
          question,
          bone_parts({ball, of_ball.parts}, {facing, of_socket})};
}

VolumeAnswer answer(Session& session, const VolumeRequest& request, VolumeSettings how) {
  const SessionJoint& joint = *session.joint;
  const CellTest test =
      cell_test(joint, joint.joint.socket.mesh,
                {request.gap_mm, request.centre_within_mm, request.play_mm, turn_from_scan(joint)});
  how.width = request.width;
  if (request.play_mm > 0.0) how.most_cells = std::min(how.most_cells, kMostPlayCells);
  VolumeAnswer found{
      .motions = {}, .by_radii = test.bodies().has_radial(), .volume = MotionVolume(test, how)};
  if (!joint.side) return found;
  for (const NamedMotion& motion : named_motions())
    found.motions.push_back(motion_in(found.volume, joint, test, motion));
  return found;
}

}  // namespace impinge
