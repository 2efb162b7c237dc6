// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/swept_radius.hpp"

#include <algorithm>
#include <queue>
#include <utility>

#include "sphere/infinity.hpp"

namespace impinge {
namespace {

// A part of a leg and the least radius that it may have.
struct Open {
  double least = 0.0;
  LegPart part;
  RotationBall poses;
  bool operator<(const Open& other) const { return least > other.least; }  // the least is on top
};

}  // namespace

SweptRadius::SweptRadius(const TriangleMesh& socket, std::vector<RequiredLeg> legs)
    : socket_(socket), legs_(std::move(legs)) {}

Ends SweptRadius::over(const DirectionCap& cap, double enough) const {
  std::priority_queue<Open> open;
  const auto add = [&](const LegPart& part) {
    const RotationBall poses = poses_of(legs_[part.leg], part);
    open.push({socket_.least({poses.rotation * cap.axis, cap.radius + poses.radius}), part, poses});
  };
  for (std::size_t leg = 0; leg < legs_.size(); ++leg) add({leg, 0.0, legs_[leg].largest_deg});
  Ends ends{kInfinity, kInfinity};
  while (!open.empty()) {
    const Open top = open.top();
    open.pop();
    ends.low = top.least;
    if (ends.low >= enough) break;
    ends.high = std::min(ends.high, socket_.largest({top.poses.rotation * cap.axis, cap.radius + kCapSlack}));
    if (ends.low >= ends.high - kCertainEnough ||
        top.poses.radius <= std::max(kNarrowPart * cap.radius, kLeastPart))
      break;
    const double middle = 0.5 * (top.part.from_deg + top.part.to_deg);
    add({top.part.leg, top.part.from_deg, middle});
    add({top.part.leg, middle, top.part.to_deg});
  }
  return ends;
}

}  // namespace impinge
