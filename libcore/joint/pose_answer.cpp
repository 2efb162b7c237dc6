// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/pose_answer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "files/stopwatch.hpp"
#include "hip/close_zones.hpp"
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

Impinged impinged_up_to(const SessionJoint& joint, double level, const PosedGaps& posed) {
  const GapSummary summary = summarise(posed.gap, posed.area, level);
  Impinged found{summary.impinged, summary.impinged_area, {}};
  if (!joint.dial) return found;
  found.clock_zones.emplace();
  if (found.vertices > 0) found.clock_zones = close_zones(*joint.dial, posed, level);
  return found;
}

SurfaceAnswer surface_answer(const SessionJoint& joint, const GapsAnswer& found, Surface surface,
                             std::vector<double> gap) {
  SurfaceAnswer answer;
  answer.gap = std::move(gap);
  std::vector<Vec3> places = posed_places(joint, found.pose, surface);
  const auto& map = joint.joint.cartilage;
  answer.against_cartilage = map ? shares_of_cartilage(answer.gap, places, *map) : answer.gap;
  const std::vector<double>& area = joint.part(surface).area;
  if (!answer.gap.empty()) {
    answer.all = summarise(answer.gap, area, 0.0);
    answer.histogram = gap_histogram(answer.gap, area);
  }
  if (joint.dial) places = mapped(joint.axes, places);
  const PosedGaps posed{places, answer.against_cartilage, area};
  answer.bone = impinged_up_to(joint, 0.0, posed);
  answer.cartilage = impinged_up_to(joint, found.touching, posed);
  return answer;
}

// The smallest gap; of two equal ones the ball's.
std::optional<SmallestOfPose> smallest_of(const SessionJoint& joint, const GapsAnswer& found) {
  const GapSummary& ball = found.ball.all;
  const GapSummary& socket = found.socket.all;
  if (!ball.smallest && !socket.smallest) return std::nullopt;
  const bool on_ball = ball.smallest && (!socket.smallest || ball.smallest_gap <= socket.smallest_gap);
  const GapSummary& of = on_ball ? ball : socket;
  return smallest_at(joint, found.pose, on_ball ? Surface::ball : Surface::socket, *of.smallest,
                     of.smallest_gap);
}

double median(std::vector<double>& bounds) {
  if (bounds.empty()) return 0.0;
  const auto middle = bounds.begin() + static_cast<std::ptrdiff_t>(bounds.size() / 2);
  std::nth_element(bounds.begin(), middle, bounds.end());
  return *middle;
}

}  // namespace

std::vector<Vec3> posed_places(const SessionJoint& joint, const Pose& pose, Surface of) {
  std::vector<Vec3> places = joint.bone(of).mesh.vertices;
  if (of == Surface::ball)
    for (Vec3& x : places) x = to_socket(pose, x);
  return places;
}

std::vector<Vec3> places_in_other(const SessionJoint& joint, const Pose& pose, Surface of) {
  const Pose turn{pose.rotation, Vec3::Zero()};
  std::vector<Vec3> places = joint.mesh(of).vertices;
  for (Vec3& x : places) x = to_other(of, turn, x);
  return places;
}

GapsAnswer answer_of_gaps(const SessionJoint& joint, const Pose& pose, std::vector<double> ball_gap,
                          std::vector<double> socket_gap, double cartilage_mm) {
  GapsAnswer found;
  found.pose = pose;
  found.by_map = joint.joint.cartilage.has_value();
  found.touching = found.by_map ? 1.0 : cartilage_mm;
  found.dial = joint.dial;
  found.ball = surface_answer(joint, found, Surface::ball, std::move(ball_gap));
  found.socket = surface_answer(joint, found, Surface::socket, std::move(socket_gap));
  found.smallest_gap = smallest_of(joint, found);
  return found;
}

GapsAnswer answer_pose(Session& session, const PoseRequest& request) {
  shift_ball(session, request.translation);
  const SessionJoint& joint = *session.joint;
  const Pose pose = pose_of(joint, request.motion, request.translation);
  const Pose turn{pose.rotation, Vec3::Zero()};
  Stopwatch watch;
  std::vector<double> ball = gaps_of(*session.tables.socket, joint.ball, turn, Surface::ball);
  std::vector<double> socket = gaps_of(*session.tables.ball, joint.socket, turn, Surface::socket);
  const double scan_ms = watch.lap_ms();
  GapsAnswer found = answer_of_gaps(joint, pose, std::move(ball), std::move(socket), request.cartilage_mm);
  found.scan_ms = scan_ms;
  return found;
}

void bound_gaps(Session& session, GapsAnswer& answer) {
  bound_tables(session);
  for (const Surface of : kSurfaces) {
    const auto& bounds = of == Surface::ball ? session.tables.socket_bounds : session.tables.ball_bounds;
    const std::vector<Vec3> places = places_in_other(*session.joint, answer.pose, of);
    SurfaceAnswer& scan = answer.of(of);
    for (std::size_t i = 0; i < places.size(); ++i)
      scan.bound.push_back(std::isnan(scan.gap[i]) ? scan.gap[i] : bounds->at(places[i]));
  }
}

PoseVerdicts verdicts_of(SessionJoint& joint, const GapsAnswer& answer) {
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
  GapsAnswer answer = answer_pose(session, request);
  bound_gaps(session, answer);
  return verdicts_of(*session.joint, answer);
}

}  // namespace impinge
