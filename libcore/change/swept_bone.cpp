// SPDX-License-Identifier: GPL-3.0-or-later
#include "change/swept_bone.hpp"

#include <algorithm>
#include <deque>
#include <utility>

namespace impinge {
namespace {

constexpr double kNoBetter = 1.5;  // times the doubt of one pose: a part with no more is not halved

}  // namespace

SweptBone::SweptBone(const TriangleMesh& socket, std::vector<RequiredLeg> legs, double clearance_mm)
    : bone_(socket), legs_(std::move(legs)), clearance_(clearance_mm) {}

SpansOverCap SweptBone::over(const DirectionCap& cap, double farthest) const {
  SpansOverCap found;
  const auto add = [&](const RaySpans& bone, RaySpans& to) {
    for (const RadiusRange& span : bone.spans())
      to.add(std::max(0.0, span.low - clearance_), std::min(farthest, span.high + clearance_));
  };
  // The length of these spans, mm, that is not certain.
  const auto doubt = [&](const RaySpans& spans) {
    double all = 0.0;
    for (const RadiusRange& s : spans.spans()) all += s.high - s.low - found.certain.length(s.low, s.high);
    return all;
  };
  std::deque<LegPart> open;
  for (std::size_t leg = 0; leg < legs_.size(); ++leg) open.push_back({leg, 0.0, legs_[leg].largest_deg});
  for (; !open.empty(); open.pop_front()) {
    const LegPart part = open.front();
    const RotationBall poses = poses_of(legs_[part.leg], part);
    const Vec3 axis = poses.rotation * cap.axis;
    RaySpans here;
    add(bone_.over({axis, cap.radius + poses.radius}).possible, here);
    if (here.spans().empty()) continue;
    bool done =
        doubt(here) <= kCertainEnough || poses.radius <= std::max(kNarrowPart * cap.radius, kLeastPart);
    if (doubt(here) > kCertainEnough) {
      const SpansOverCap middle = bone_.over({axis, cap.radius + kCapSlack});
      RaySpans alone;
      add(middle.certain, found.certain);
      add(middle.possible, alone);
      done = done || doubt(here) <= kCertainEnough + kNoBetter * doubt(alone);
    }
    if (done) {
      for (const RadiusRange& s : here.spans()) found.possible.add(s.low, s.high);
      continue;
    }
    const double middle = 0.5 * (part.from_deg + part.to_deg);
    open.push_back({part.leg, part.from_deg, middle});
    open.push_back({part.leg, middle, part.to_deg});
  }
  return found;
}

}  // namespace impinge
