// SPDX-License-Identifier: GPL-3.0-or-later
#include "change/required_motion.hpp"

#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "files/formatted.hpp"
#include "table/face_cap.hpp"

namespace impinge {
namespace {

// The name of the motion in which the angle goes from 0 to this value, such as extension for a negative
// flexion.
const MotionName& growing_name(double Motion::*angle, double value) {
  for (const MotionName& name : motion_names()) {
    if (name.angle == angle && (name.sign > 0.0) == (value > 0.0)) return name;
  }
  return motion_names().front();
}

}  // namespace

std::vector<RequiredLeg> required_legs(const Motion& motion, std::optional<Side> side) {
  std::vector<RequiredLeg> legs;
  Motion reached;
  for (double Motion::*angle : {&Motion::flexion, &Motion::abduction, &Motion::internal_rotation}) {
    if (motion.*angle == 0.0) continue;
    const MotionName& name = growing_name(angle, motion.*angle);
    legs.push_back({joint_turn(reached, name, side), reached, name.name, std::abs(motion.*angle)});
    reached.*angle = motion.*angle;
  }
  return legs;
}

std::vector<RequiredLeg> required_legs(std::span<const Motion> motions, std::optional<Side> side) {
  std::vector<RequiredLeg> legs;
  for (const Motion& motion : motions) {
    for (RequiredLeg& leg : required_legs(motion, side)) legs.push_back(std::move(leg));
  }
  return legs;
}

std::string describe(const RequiredLeg& leg) {
  std::string text = formatted("%s from 0 to %g degrees", std::string(leg.growing).c_str(), leg.largest_deg);
  for (double Motion::*angle : {&Motion::flexion, &Motion::abduction, &Motion::internal_rotation}) {
    const double value = leg.start.*angle;
    if (value == 0.0) continue;
    text += formatted(" at %s %g", std::string(growing_name(angle, value).name).c_str(), std::abs(value));
  }
  return text;
}

RotationBall poses_of(const RequiredLeg& leg, const LegPart& part) {
  const double middle = 0.5 * (part.from_deg + part.to_deg) * kDegree;
  return {leg.turn.outer * Eigen::AngleAxisd(middle, leg.turn.axis).toRotationMatrix() * leg.turn.inner,
          0.5 * (part.to_deg - part.from_deg) * kDegree + kCapSlack};
}

}  // namespace impinge
