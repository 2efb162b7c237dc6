// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "pose_answer.hpp"

namespace impinge {
namespace {

TriangleMesh in_joint_frame(const SessionJoint& joint, TriangleMesh mesh) {
  for (Vec3& x : mesh.vertices) x = joint.axes * x;
  return mesh;
}

const TurnLimits& limits_of(Session& session) {
  if (!session.limits) {
    const SessionJoint& joint = *session.joint;
    session.limits = std::make_unique<TurnLimits>(BallSocketPair{
        in_joint_frame(joint, joint.joint.ball.mesh), in_joint_frame(joint, joint.joint.socket.mesh)});
  }
  return *session.limits;
}

double smallest_gap(const Session& session, const Motion& motion) {
  const PoseAnswer found = answer_pose(session, {motion, Vec3::Zero(), 0.0});
  return found.smallest ? found.smallest->gap_mm : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

SweepAnswer answer_sweep(Session& session, const SweepRequest& request) {
  const MotionName& growing = motion_name(request.growing);
  const double largest = std::min(request.largest_deg, largest_growth(request.start, growing));
  const JointTurn turn = joint_turn(request.start, growing, session.joint->side);
  SweepAnswer answer;
  Motion end = request.start;
  end.*growing.angle += growing.sign * largest;
  for (const Motion& motion : motion_path(request.start, end, request.step_deg)) {
    answer.angles.push_back(growing.sign * (motion.*growing.angle - request.start.*growing.angle));
    answer.smallest.push_back(smallest_gap(session, motion));
  }
  answer.limit = limits_of(session).first_contact(turn, largest);
  if (answer.limit.contact && session.joint->dial)
    answer.hours = session.joint->dial->hours(answer.limit.contact->place);
  return answer;
}

}  // namespace impinge
