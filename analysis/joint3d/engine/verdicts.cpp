// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdicts.hpp"

#include <algorithm>
#include <cmath>

namespace impinge {
namespace {

// One vertex that has a gap.
void add(double gap, double bound, PoseVerdicts& found) {
  const Verdict verdict = verdict_of(gap - bound, gap + bound, Cover::whole);
  found.vertices.clear += verdict == Verdict::clear ? 1U : 0U;
  found.vertices.impinged += verdict == Verdict::impinged ? 1U : 0U;
  found.vertices.undecided += verdict == Verdict::undecided ? 1U : 0U;
  if (!std::isfinite(bound)) {
    ++found.unbounded;
    return;
  }
  found.largest_mm = std::max(found.largest_mm, bound);
  found.low_mm = std::min(found.low_mm, gap - bound);
  found.high_mm = std::min(found.high_mm, gap + bound);
}

}  // namespace

PoseVerdicts answer_verdicts(Session& session, const PoseRequest& request) {
  bound_tables(session);
  const PoseAnswer answer = answer_pose(session, request);
  const SessionJoint& joint = *session.joint;
  PoseVerdicts found;
  found.low_mm = found.high_mm = HUGE_VAL;
  for (std::size_t i = 0; i < answer.ball.gap.size(); ++i) {
    if (std::isnan(answer.ball.gap[i])) continue;
    const Vec3 x = to_socket(answer.pose, joint.ball.vertices.points[i]);
    add(answer.ball.gap[i], session.tables.socket_bounds->at(x), found);
  }
  for (std::size_t i = 0; i < answer.socket.gap.size(); ++i) {
    if (std::isnan(answer.socket.gap[i])) continue;
    const Vec3 x = to_ball(answer.pose, joint.socket.vertices.points[i]);
    add(answer.socket.gap[i], session.tables.ball_bounds->at(x), found);
  }
  return found;
}

}  // namespace impinge
