// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace impinge {
namespace {

// One scan, made ready to be judged: of each vertex the gap, the bound of the cell that it reads, and where
// it is in the frame of the table.
struct JudgedScan {
  std::vector<Vec3> places;
  std::vector<double> gap;
  std::vector<double> bound;
};

template <class Place>
JudgedScan judged(std::span<const Vec3> vertices, std::vector<double> gap, const SurfaceBounds& bounds,
                  const Place& place) {
  JudgedScan scan;
  scan.gap = std::move(gap);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    scan.places.push_back(place(vertices[i]));
    scan.bound.push_back(std::isnan(scan.gap[i]) ? scan.gap[i] : bounds.at(scan.places[i]));
  }
  return scan;
}

void add(const JudgedScan& scan, PoseVerdicts& found, std::vector<double>& bounds) {
  for (std::size_t i = 0; i < scan.gap.size(); ++i) {
    if (std::isnan(scan.gap[i])) continue;
    const double bound = scan.bound[i];
    const Verdict verdict = verdict_of(scan.gap[i] - bound, scan.gap[i] + bound, Cover::whole);
    found.vertices.clear += verdict == Verdict::clear ? 1U : 0U;
    found.vertices.impinged += verdict == Verdict::impinged ? 1U : 0U;
    found.vertices.undecided += verdict == Verdict::undecided ? 1U : 0U;
    if (std::isfinite(bound)) {
      bounds.push_back(bound);
    } else {
      ++found.unbounded;
    }
  }
}

double median(std::vector<double>& bounds) {
  if (bounds.empty()) return 0.0;
  const auto middle = bounds.begin() + static_cast<std::ptrdiff_t>(bounds.size() / 2);
  std::nth_element(bounds.begin(), middle, bounds.end());
  return *middle;
}

}  // namespace

PoseVerdicts answer_verdicts(Session& session, const PoseRequest& request) {
  PoseAnswer answer = answer_pose(session, request);
  bound_tables(session);
  SessionJoint& joint = *session.joint;
  near_faces(joint);
  const Pose turn{answer.pose.rotation, Vec3::Zero()};
  const JudgedScan ball =
      judged(joint.ball.vertices.points, std::move(answer.ball.gap), *session.tables.socket_bounds,
             [&](const Vec3& x) { return to_socket(turn, x); });
  const JudgedScan socket =
      judged(joint.socket.vertices.points, std::move(answer.socket.gap), *session.tables.ball_bounds,
             [&](const Vec3& x) { return to_ball(turn, x); });
  PoseVerdicts found;
  std::vector<double> bounds;
  add(ball, found, bounds);
  add(socket, found, bounds);
  for (const double bound : bounds) found.largest_mm = std::max(found.largest_mm, bound);
  found.median_mm = median(bounds);
  found.smallest =
      smallest_between({Surface::ball, *joint.seen_faces, ball.places, ball.gap, ball.bound},
                       {Surface::socket, *joint.ball_faces, socket.places, socket.gap, socket.bound});
  return found;
}

}  // namespace impinge
