// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "hip/sphere_fit.hpp"
#include "joint/volume.hpp"
#include "mesh/mesh_parts.hpp"
#include "mesh/triangle_distance.hpp"

namespace impinge {
namespace {

double largest_of(const LimitRequest& request) {
  return std::min(request.largest_deg, largest_growth(request.start, motion_name(request.growing)));
}

// The main surface of a bone that goes on is named nothing, the rest of the bone by its part.
std::string name_at(const TriangleMesh& mesh, const std::vector<MeshPart>& parts, std::size_t body,
                    const Vec3& place) {
  if (body > 0 || parts.empty() || !parts.front().of_main) return body_name(parts, body);
  const auto nearest = [&](std::size_t from, std::size_t to) {
    double least = HUGE_VAL;
    for (std::size_t f = from; f < to; ++f) {
      const auto [a, b, c] = corners_of(mesh, mesh.faces[f]);
      least = std::min(least, squared_distance_to_triangle(place, a, b, c));
    }
    return least;
  };
  const std::size_t rest = parts.front().first_face;
  const std::size_t end = parts.size() > 1 ? parts[1].first_face : mesh.faces.size();
  return nearest(0, rest) <= nearest(rest, end) ? "" : parts.front().name;
}

// The dial is about the joint's centre, the contact about the centre of the turn.
LimitAnswer answered(const SessionJoint& joint, const char* about, const CentredLimits& centred,
                     const JointTurn& turn, double threshold, double largest) {
  LimitAnswer limit{about,
                    joint.joint.centre + joint.axes.transpose() * centred.centre,
                    told_limit(centred.limits, turn, threshold, largest),
                    std::nullopt,
                    "",
                    ""};
  const auto& contact = limit.told.limit.contact;
  if (!contact) return limit;
  if (joint.dial) limit.hours = joint.dial->hours(contact->place + centred.centre);
  const Eigen::Matrix3d rotation =
      turn.outer * Eigen::AngleAxisd(contact->angle, turn.axis).toRotationMatrix() * turn.inner;
  limit.ball_part = name_at(centred.meshes.ball, joint.joint.ball.parts, contact->body[0],
                            rotation.transpose() * contact->place);
  limit.socket_part =
      name_at(centred.meshes.socket, joint.joint.socket.parts, contact->body[1], contact->place);
  return limit;
}

// The centre of the socket, in the joint frame; none where no sphere fits it.
std::optional<Vec3> socket_centre(const Joint& joint, const BallSocketPair& meshes) {
  try {
    return fit_socket(main_surface(meshes.socket, joint.socket.parts),
                      fit_ball(main_surface(meshes.ball, joint.ball.parts)))
        .centre;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// Of the joint's own meshes about the centre of the ball, and about that of the socket where it has one.
void make_limits(Session& session, bool about_socket) {
  const SessionJoint& joint = *session.joint;
  if (!session.limits) {
    session.limits =
        std::make_unique<CentredLimits>(joint.joint,
                                        BallSocketPair{in_joint_frame(joint, joint.mesh(Surface::ball)),
                                                       in_joint_frame(joint, joint.mesh(Surface::socket))},
                                        joint.axes * joint.shift);
  }
  if (!about_socket || session.socket_limits || session.no_socket_centre) return;
  const BallSocketPair& meshes = session.limits->meshes;
  const std::optional<Vec3> centre = socket_centre(joint.joint, meshes);
  session.no_socket_centre = !centre;
  if (!centre) return;
  session.socket_limits = std::make_unique<CentredLimits>(
      joint.joint, BallSocketPair{relative_to(meshes.ball, *centre), relative_to(meshes.socket, *centre)},
      *centre);
}

}  // namespace

CentredLimits::CentredLimits(const Joint& joint, BallSocketPair about, const Vec3& from_centre)
    : meshes(std::move(about)),
      centre(from_centre),
      limits({main_surface(meshes.ball, joint.ball.parts), main_surface(meshes.socket, joint.socket.parts)},
             bone_parts({meshes.ball, joint.ball.parts}, {meshes.socket, joint.socket.parts})) {}

LimitAnswers answer_limits(Session& session, const LimitRequest& request) {
  const double largest = largest_of(request);
  shift_ball(session, request.translation);
  const bool shifted = !request.translation.isZero(0.0);
  make_limits(session, !shifted);
  const SessionJoint& joint = *session.joint;
  const JointTurn turn = joint_turn(request.start, motion_name(request.growing), joint.side);
  const LimitAnswer contact = answered(joint, "ball", *session.limits, turn, 0.0, largest);
  const double threshold = request.cartilage_mm;
  LimitAnswers answer{
      largest, contact, std::nullopt,
      threshold > 0.0 ? answered(joint, "ball", *session.limits, turn, threshold, largest) : contact};
  if (!shifted && session.socket_limits)
    answer.socket = answered(joint, "socket", *session.socket_limits, turn, 0.0, largest);
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
