// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace impinge {
namespace {

struct BoundedGap {
  double gap;    // mm, as are the others here
  double bound;  // infinite where nothing is proven
};

// Of all vertices that have a gap.
std::vector<BoundedGap> bounded_gaps(const Session& session, const PoseAnswer& answer) {
  const SessionJoint& joint = *session.joint;
  std::vector<BoundedGap> found;
  for (std::size_t i = 0; i < answer.ball.gap.size(); ++i) {
    if (std::isnan(answer.ball.gap[i])) continue;
    const Vec3 x = to_socket(answer.pose, joint.ball.vertices.points[i]);
    found.push_back({answer.ball.gap[i], session.tables.socket_bounds->at(x)});
  }
  for (std::size_t i = 0; i < answer.socket.gap.size(); ++i) {
    if (std::isnan(answer.socket.gap[i])) continue;
    const Vec3 x = to_ball(answer.pose, joint.socket.vertices.points[i]);
    found.push_back({answer.socket.gap[i], session.tables.ball_bounds->at(x)});
  }
  return found;
}

void add(const BoundedGap& of, PoseVerdicts& found) {
  const Verdict verdict = verdict_of(of.gap - of.bound, of.gap + of.bound, Cover::whole);
  found.vertices.clear += verdict == Verdict::clear ? 1U : 0U;
  found.vertices.impinged += verdict == Verdict::impinged ? 1U : 0U;
  found.vertices.undecided += verdict == Verdict::undecided ? 1U : 0U;
  if (!std::isfinite(of.bound)) {
    ++found.unbounded;
    return;
  }
  found.largest_mm = std::max(found.largest_mm, of.bound);
  found.low_mm = std::min(found.low_mm, of.gap - of.bound);
  found.high_mm = std::min(found.high_mm, of.gap + of.bound);
}

double median_bound(std::vector<BoundedGap> gaps) {
  std::erase_if(gaps, [](const BoundedGap& of) { return !std::isfinite(of.bound); });
  if (gaps.empty()) return 0.0;
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end(),
                   [](const BoundedGap& a, const BoundedGap& b) { return a.bound < b.bound; });
  return middle->bound;
}

}  // namespace

PoseVerdicts answer_verdicts(Session& session, const PoseRequest& request) {
  bound_tables(session);
  const std::vector<BoundedGap> gaps = bounded_gaps(session, answer_pose(session, request));
  PoseVerdicts found;
  found.low_mm = found.high_mm = HUGE_VAL;
  for (const BoundedGap& of : gaps) add(of, found);
  found.median_mm = median_bound(gaps);
  return found;
}

}  // namespace impinge
