// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/pose_answer.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "files/stopwatch.hpp"
#include "hip/close_zones.hpp"
#include "joint/certificate.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {
namespace {

std::vector<double> gaps_of(SurfaceTable& table, const SessionPart& part, const Pose& turn, Surface scanned) {
  std::vector<double> gap(part.vertices.points.size());
  table.scan(part.vertices, turn, scanned, gap);
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!part.used[i]) gap[i] = kNoSurface;
  }
  return gap;
}

SurfaceAnswer surface_answer(const SessionJoint& joint, const Pose& pose, Surface surface,
                             std::vector<double> gap, double cartilage_mm) {
  SurfaceAnswer answer;
  answer.gap = std::move(gap);
  std::vector<Vec3> places = posed_places(joint, pose, surface);
  const auto& map = joint.joint.cartilage;
  answer.touching = map ? 1.0 : cartilage_mm;
  answer.against_cartilage = map ? shares_of_cartilage(answer.gap, places, *map) : answer.gap;
  if (answer.gap.empty()) return answer;
  const std::vector<double>& area = joint.part(surface).area;
  answer.all = summarise(answer.gap, area, 0.0);
  answer.bone = summarise(answer.against_cartilage, area, 0.0);
  answer.cartilage = summarise(answer.against_cartilage, area, answer.touching);
  answer.histogram = gap_histogram(answer.gap, area);
  if (!joint.dial || answer.bone.impinged + answer.cartilage.impinged == 0) return answer;
  places = mapped(joint.axes, places);
  const PosedGaps posed{places, answer.against_cartilage, area};
  answer.bone_zones = close_zones(*joint.dial, posed, 0.0);
  answer.cartilage_zones = close_zones(*joint.dial, posed, answer.touching);
  return answer;
}

// Of two gaps of one size that of the ball.
std::optional<SmallestOfPose> smallest_of(const SessionJoint& joint, const PoseAnswer& found) {
  const GapSummary& ball = found.ball.all;
  const GapSummary& socket = found.socket.all;
  if (!ball.smallest && !socket.smallest) return std::nullopt;
  SmallestOfPose smallest;
  const bool on_ball = ball.smallest && (!socket.smallest || ball.smallest_gap <= socket.smallest_gap);
  smallest.surface = on_ball ? Surface::ball : Surface::socket;
  smallest.vertex = on_ball ? *ball.smallest : *socket.smallest;
  smallest.gap_mm = on_ball ? ball.smallest_gap : socket.smallest_gap;
  smallest.place = on_ball ? to_socket(found.pose, joint.joint.ball.mesh.vertices[smallest.vertex])
                           : joint.joint.socket.mesh.vertices[smallest.vertex];
  if (joint.dial) smallest.hours = joint.dial->hours(joint.axes * smallest.place);
  return smallest;
}

double median(std::vector<double>& bounds) {
  if (bounds.empty()) return 0.0;
  const auto middle = bounds.begin() + static_cast<std::ptrdiff_t>(bounds.size() / 2);
  std::nth_element(bounds.begin(), middle, bounds.end());
  return *middle;
}

}  // namespace

Pose pose_of(const SessionJoint& joint, const Motion& motion, const Vec3& translation) {
  return {joint.axes.transpose() * joint_rotation(motion, joint.side) * joint.axes, translation};
}

std::vector<Vec3> posed_places(const SessionJoint& joint, const Pose& pose, Surface of) {
  if (of == Surface::socket) return joint.joint.socket.mesh.vertices;
  std::vector<Vec3> places = joint.joint.ball.mesh.vertices;
  for (Vec3& x : places) x = to_socket(pose, x);
  return places;
}

std::vector<Vec3> places_in_other(const SessionJoint& joint, const Pose& pose, Surface of) {
  const Pose turn{pose.rotation, Vec3::Zero()};
  std::vector<Vec3> places = joint.mesh(of).vertices;
  for (Vec3& x : places) x = to_other(of, turn, x);
  return places;
}

PoseAnswer answer_of_gaps(const SessionJoint& joint, const Pose& pose, std::vector<double> ball_gap,
                          std::vector<double> socket_gap, double cartilage_mm) {
  PoseAnswer found;
  found.pose = pose;
  found.ball = surface_answer(joint, pose, Surface::ball, std::move(ball_gap), cartilage_mm);
  found.socket = surface_answer(joint, pose, Surface::socket, std::move(socket_gap), cartilage_mm);
  found.smallest = smallest_of(joint, found);
  return found;
}

PoseAnswer answer_pose(Session& session, const PoseRequest& request) {
  shift_ball(session, request.translation);
  const SessionJoint& joint = *session.joint;
  const Pose pose = pose_of(joint, request.motion, request.translation);
  const Pose turn{pose.rotation, Vec3::Zero()};
  Stopwatch watch;
  std::vector<double> ball = gaps_of(*session.tables.socket, joint.ball, turn, Surface::ball);
  std::vector<double> socket = gaps_of(*session.tables.ball, joint.socket, turn, Surface::socket);
  const double scan_ms = watch.lap_ms();
  PoseAnswer found = answer_of_gaps(joint, pose, std::move(ball), std::move(socket), request.cartilage_mm);
  found.scan_ms = scan_ms;
  return found;
}

void bound_gaps(Session& session, PoseAnswer& answer) {
  bound_tables(session);
  for (const Surface of : kSurfaces) {
    const auto& bounds = of == Surface::ball ? session.tables.socket_bounds : session.tables.ball_bounds;
    const std::vector<Vec3> places = places_in_other(*session.joint, answer.pose, of);
    SurfaceAnswer& scan = answer.of(of);
    for (std::size_t i = 0; i < places.size(); ++i)
      scan.bound.push_back(std::isnan(scan.gap[i]) ? scan.gap[i] : bounds->at(places[i]));
  }
}

PoseVerdicts verdicts_of(SessionJoint& joint, const PoseAnswer& answer) {
  PoseVerdicts found;
  std::vector<double> bounds;
  for (const Surface of : kSurfaces) {
    const SurfaceAnswer& scan = answer.of(of);
    found.vertices += count_verdicts(scan.gap, scan.bound);
    for (std::size_t i = 0; i < scan.gap.size(); ++i) {
      if (std::isnan(scan.gap[i])) continue;
      if (std::isfinite(scan.bound[i])) {
        bounds.push_back(scan.bound[i]);
      } else {
        ++found.unbounded;
      }
    }
  }
  for (const double bound : bounds) found.largest_mm = std::max(found.largest_mm, bound);
  found.median_mm = median(bounds);
  const std::vector<Vec3> ball = places_in_other(joint, answer.pose, Surface::ball);
  const std::vector<Vec3> socket = places_in_other(joint, answer.pose, Surface::socket);
  found.smallest = smallest_between(
      {Surface::ball, joint.faces(Surface::socket), ball, answer.ball.gap, answer.ball.bound},
      {Surface::socket, joint.faces(Surface::ball), socket, answer.socket.gap, answer.socket.bound});
  return found;
}

PoseVerdicts answer_verdicts(Session& session, const PoseRequest& request) {
  PoseAnswer answer = answer_pose(session, request);
  bound_gaps(session, answer);
  return verdicts_of(*session.joint, answer);
}

}  // namespace impinge
