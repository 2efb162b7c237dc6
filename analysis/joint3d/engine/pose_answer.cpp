// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_answer.hpp"

#include <chrono>

#include "hip/close_zones.hpp"

namespace impinge {
namespace {

std::vector<double> gaps_of(SurfaceTable& table, const SessionPart& part, const Pose& pose, Surface scanned) {
  std::vector<double> gap(part.vertices.points.size());
  table.scan(part.vertices, pose, scanned, gap);
  for (const std::size_t i : part.stray) gap[i] = kNoSurface;
  return gap;
}

SurfaceAnswer surface_answer(const SessionPart& part, std::vector<double> gap, double cartilage_mm) {
  SurfaceAnswer answer;
  answer.bone = summarise(gap, part.area, 0.0);
  answer.cartilage = summarise(gap, part.area, cartilage_mm);
  answer.histogram = gap_histogram(gap, part.area);
  answer.gap = std::move(gap);
  return answer;
}

// Where the vertices are in the pose: in the joint frame, for the dial.
std::vector<Vec3> places_of(const SessionJoint& joint, const Pose& pose, Surface surface) {
  std::vector<Vec3> places =
      surface == Surface::ball ? joint.ball.vertices.points : joint.joint.socket.mesh.vertices;
  for (Vec3& x : places) x = joint.axes * (surface == Surface::ball ? to_socket(pose, x) : x);
  return places;
}

void add_zones(const SessionJoint& joint, const PoseAnswer& found, Surface surface, double cartilage_mm,
               SurfaceAnswer& answer) {
  if (!joint.dial || answer.cartilage.impinged + answer.bone.impinged == 0) return;
  const std::vector<Vec3> places = places_of(joint, found.pose, surface);
  const SessionPart& part = surface == Surface::ball ? joint.ball : joint.socket;
  const PosedGaps posed{places, answer.gap, part.area};
  answer.bone_zones = close_zones(*joint.dial, posed, 0.0);
  answer.cartilage_zones = close_zones(*joint.dial, posed, cartilage_mm);
}

std::optional<SmallestOfPose> smallest_of(const SessionJoint& joint, const PoseAnswer& found) {
  const GapSummary& ball = found.ball.bone;
  const GapSummary& socket = found.socket.bone;
  if (!ball.smallest && !socket.smallest) return std::nullopt;
  SmallestOfPose smallest;
  const bool on_ball = ball.smallest && (!socket.smallest || ball.smallest_gap <= socket.smallest_gap);
  smallest.surface = on_ball ? Surface::ball : Surface::socket;
  smallest.vertex = on_ball ? *ball.smallest : *socket.smallest;
  smallest.gap_mm = on_ball ? ball.smallest_gap : socket.smallest_gap;
  smallest.place = on_ball ? to_socket(found.pose, joint.ball.vertices.points[smallest.vertex])
                           : joint.joint.socket.mesh.vertices[smallest.vertex];
  if (joint.dial) smallest.hours = joint.dial->hours(joint.axes * smallest.place);
  return smallest;
}

}  // namespace

Pose pose_of(const SessionJoint& joint, const PoseRequest& request) {
  const Eigen::Matrix3d rotation = joint_rotation(request.motion, joint.side);
  return {joint.axes.transpose() * rotation * joint.axes, request.translation};
}

PoseAnswer answer_pose(Session& session, const PoseRequest& request) {
  using Clock = std::chrono::steady_clock;
  shift_ball(session, request.translation);
  const SessionJoint& joint = *session.joint;
  PoseAnswer found;
  found.pose = pose_of(joint, request);
  const Pose turn{found.pose.rotation, Vec3::Zero()};
  const auto start = Clock::now();
  std::vector<double> ball = gaps_of(*session.tables.socket, joint.ball, turn, Surface::ball);
  std::vector<double> socket = gaps_of(*session.tables.ball, joint.socket, turn, Surface::socket);
  found.scan_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  found.ball = surface_answer(joint.ball, std::move(ball), request.cartilage_mm);
  found.socket = surface_answer(joint.socket, std::move(socket), request.cartilage_mm);
  add_zones(joint, found, Surface::ball, request.cartilage_mm, found.ball);
  add_zones(joint, found, Surface::socket, request.cartilage_mm, found.socket);
  found.smallest = smallest_of(joint, found);
  return found;
}

}  // namespace impinge
