// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "hip/sphere_fit.hpp"
#include "mesh/mesh_parts.hpp"
#include "session/volume.hpp"

namespace impinge {
namespace {

double largest_of(const LimitRequest& request) {
  return std::min(request.largest_deg, largest_growth(request.start, motion_name(request.growing)));
}

// The dial is about the socket's centre, the contact about the centre of the turn.
LimitAnswer answered(const SessionJoint& joint, const char* about, const Vec3& centre, ToldLimit told) {
  LimitAnswer limit{about, joint.joint.centre + centre, std::move(told), std::nullopt, "", ""};
  if (limit.told.limit.contact && joint.dial)
    limit.hours = joint.dial->hours(limit.told.limit.contact->place + joint.axes * joint.shift);
  return limit;
}

void name_parts(const Joint& joint, LimitAnswer& limit) {
  if (!limit.told.limit.contact) return;
  limit.ball_part = body_name(joint.ball.parts, limit.told.limit.contact->body[0]);
  limit.socket_part = body_name(joint.socket.parts, limit.told.limit.contact->body[1]);
}

TurnLimits limits_of(const Joint& joint, const TriangleMesh& ball, const TriangleMesh& socket) {
  return TurnLimits({main_surface(ball, joint.ball.parts), main_surface(socket, joint.socket.parts)},
                    bone_parts({ball, joint.ball.parts}, {socket, joint.socket.parts}));
}

// The centre of the socket, in the joint frame; none where no sphere fits it.
std::optional<Vec3> centre_of(const TriangleMesh& socket) {
  try {
    return fit_ball(socket).centre;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace

LimitAnswers answer_limits(Session& session, const LimitRequest& request) {
  const MotionName& growing = motion_name(request.growing);
  const double largest = largest_of(request);
  shift_ball(session, request.translation);
  const SessionJoint& joint = *session.joint;
  const JointTurn turn = joint_turn(request.start, growing, joint.side);
  const TriangleMesh ball = in_joint_frame(joint, joint.mesh(Surface::ball));
  const TriangleMesh seen = in_joint_frame(joint, joint.mesh(Surface::socket));
  if (!session.limits) session.limits = std::make_unique<TurnLimits>(limits_of(joint.joint, ball, seen));
  const auto about_ball = [&](double threshold) {
    LimitAnswer limit =
        answered(joint, "ball", joint.shift, told_limit(*session.limits, turn, threshold, largest));
    name_parts(joint.joint, limit);
    return limit;
  };
  const LimitAnswer contact = about_ball(0.0);
  LimitAnswers answer{largest, contact, std::nullopt,
                      request.cartilage_mm > 0.0 ? about_ball(request.cartilage_mm) : contact};
  if (!request.translation.isZero(0.0)) return answer;
  const TriangleMesh socket = in_joint_frame(joint, joint.joint.socket.mesh);
  const std::optional<Vec3> centre = centre_of(main_surface(socket, joint.joint.socket.parts));
  if (!centre) return answer;
  const TriangleMesh about_socket = relative_to(socket, *centre);
  if (!session.socket_limits)
    session.socket_limits = std::make_unique<TurnLimits>(limits_of(joint.joint, ball, about_socket));
  answer.socket = answered(joint, "socket", joint.axes.transpose() * *centre,
                           told_limit(*session.socket_limits, turn, 0.0, largest));
  name_parts(joint.joint, *answer.socket);
  return answer;
}

Sweep sweep(Session& session, const LimitRequest& request, double step_deg) {
  const MotionName& growing = motion_name(request.growing);
  Motion end = request.start;
  end.*growing.angle += growing.sign * largest_of(request);
  Sweep found;
  for (const Motion& motion : motion_path(request.start, end, step_deg)) {
    const auto smallest = answer_pose(session, {motion, request.translation, 0.0}).smallest;
    found.angles.push_back(growing.sign * (motion.*growing.angle - request.start.*growing.angle));
    found.smallest.push_back(smallest ? smallest->gap_mm : std::numeric_limits<double>::quiet_NaN());
  }
  return found;
}

}  // namespace impinge
