// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "hip/sphere_fit.hpp"
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
    session.limits = std::make_unique<TurnLimits>(
        BallSocketPair{in_joint_frame(joint, joint.joint.ball.mesh), in_joint_frame(joint, joint.seen)});
  }
  return *session.limits;
}

// About the centre of the sphere that fits the socket, as the program `scene` has it; null where none fits.
const TurnLimits* socket_limits_of(Session& session) {
  if (!session.socket_limits) {
    const SessionJoint& joint = *session.joint;
    const TriangleMesh socket = in_joint_frame(joint, joint.joint.socket.mesh);
    try {
      session.socket_limits = std::make_unique<TurnLimits>(BallSocketPair{
          in_joint_frame(joint, joint.joint.ball.mesh), relative_to(socket, fit_ball(socket).centre)});
    } catch (const std::invalid_argument&) {
      return nullptr;
    }
  }
  return session.socket_limits.get();
}

double smallest_gap(Session& session, const PoseRequest& request) {
  const PoseAnswer found = answer_pose(session, request);
  return found.smallest ? found.smallest->gap_mm : std::numeric_limits<double>::quiet_NaN();
}

// The dial is about the socket's centre, the contact about the ball's.
SweepLimit limit_told(const SessionJoint& joint, const char* about, ToldLimit told) {
  SweepLimit limit{about, std::move(told), std::nullopt};
  if (limit.told.limit.contact && joint.dial)
    limit.hours = joint.dial->hours(limit.told.limit.contact->place + joint.axes * joint.shift);
  return limit;
}

}  // namespace

SweepAnswer answer_sweep(Session& session, const SweepRequest& request) {
  const MotionName& growing = motion_name(request.growing);
  const double largest = std::min(request.largest_deg, largest_growth(request.start, growing));
  const JointTurn turn = joint_turn(request.start, growing, session.joint->side);
  shift_ball(session, request.translation);
  SweepAnswer answer;
  Motion end = request.start;
  end.*growing.angle += growing.sign * largest;
  for (const Motion& motion : motion_path(request.start, end, request.step_deg)) {
    answer.angles.push_back(growing.sign * (motion.*growing.angle - request.start.*growing.angle));
    answer.smallest.push_back(smallest_gap(session, {motion, request.translation, 0.0}));
  }
  const SessionJoint& joint = *session.joint;
  const TurnLimits& limits = limits_of(session);
  answer.limits.push_back(limit_told(joint, "ball", told_limit(limits, turn, 0.0, largest)));
  if (const TurnLimits* socket = request.translation.isZero(0.0) ? socket_limits_of(session) : nullptr)
    answer.limits.push_back(limit_told(joint, "socket", told_limit(*socket, turn, 0.0, largest)));
  if (request.cartilage_mm > 0.0)
    answer.limits.push_back(
        limit_told(joint, "ball", told_limit(limits, turn, request.cartilage_mm, largest)));
  return answer;
}

}  // namespace impinge
