// SPDX-License-Identifier: GPL-3.0-or-later
#include "change/swept_radius.hpp"

#include <algorithm>
#include <queue>
#include <utility>

#include "sphere/infinity.hpp"

namespace impinge {
namespace {

// A part of a leg, with a lower bound of what is sought in it.
struct Open {
  double least = 0.0;
  LegPart part;
  RotationBall poses;
  bool operator<(const Open& other) const { return least > other.least; }  // the least is on top
};

}  // namespace

SweptRadius::SweptRadius(const TriangleMesh& other, std::vector<RequiredLeg> legs, Surface cut)
    : cut_(cut),
      other_(other, cut == Surface::ball ? Layer::nearest : Layer::farthest),
      legs_(std::move(legs)) {}

// What is sought is the least of S, or of -B. A lower bound over the cap,
double SweptRadius::first_end(const DirectionCap& cap) const {
  return cut_ == Surface::ball ? other_.least(cap) : -other_.largest(cap);
}

// and an upper bound.
double SweptRadius::second_end(const DirectionCap& cap) const {
  return cut_ == Surface::ball ? other_.largest(cap) : -other_.least(cap);
}

// Takes a direction u of the surface that is cut to the frame of the other one.
Vec3 SweptRadius::turned(const Vec3& u, const RotationBall& poses) const {
  return cut_ == Surface::ball ? Vec3(poses.rotation * u) : Vec3(poses.rotation.transpose() * u);
}

Ends SweptRadius::over(const DirectionCap& cap, double enough) const {
  const double stop = cut_ == Surface::ball ? enough : -enough;
  std::priority_queue<Open> open;
  const auto add = [&](const LegPart& part) {
    const RotationBall poses = poses_of(legs_[part.leg], part);
    open.push({first_end({turned(cap.axis, poses), cap.radius + poses.radius}), part, poses});
  };
  for (std::size_t leg = 0; leg < legs_.size(); ++leg) add({leg, 0.0, legs_[leg].largest_deg});
  Ends ends{kInfinity, kInfinity};
  while (!open.empty()) {
    const Open top = open.top();
    open.pop();
    ends.low = top.least;
    if (ends.low >= stop) break;
    ends.high = std::min(ends.high, second_end({turned(cap.axis, top.poses), cap.radius + kCapSlack}));
    if (ends.low >= ends.high - kCertainEnough ||
        top.poses.radius <= std::max(kNarrowPart * cap.radius, kLeastPart))
      break;
    const double middle = 0.5 * (top.part.from_deg + top.part.to_deg);
    add({top.part.leg, top.part.from_deg, middle});
    add({top.part.leg, middle, top.part.to_deg});
  }
  return cut_ == Surface::ball ? ends : Ends{-ends.high, -ends.low};
}

}  // namespace impinge
