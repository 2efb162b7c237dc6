// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/conchoid_steps.hpp"

#include <algorithm>
#include <cmath>

#include "sphere/haversine.hpp"
#include "sphere/spiral_radii.hpp"
#include "sphere/turn_angle.hpp"

namespace impinge {

ConchoidSteps::ConchoidSteps(const ConchoidShape& shape, std::size_t size)
    : last_(static_cast<double>(size - 1)),
      b_(shape.b / shape.a),
      north_(Pole::north, b_),
      south_(Pole::south, b_),
      step_((north_.whole_area() + south_.whole_area()) / last_),
      spacing_(std::sqrt((north_.whole_area() + south_.whole_area()) / (last_ + 1.0))),
      north_places_(north_.whole_area() / step_),
      north_turns_(north_.whole_length() / spacing_),
      south_turns_(south_.whole_length() / spacing_) {}

double ConchoidSteps::turn(double phi) const {
  if (phi <= 0.5 * kPi) return north_.length(phi) / spacing_;
  return turns() - south_.length(kPi - phi) / spacing_;
}

double ConchoidSteps::polar_of_turn(double turn) const {
  if (turn <= north_turns_) return north_.angle(turn * spacing_);
  return kPi - south_.angle((turns() - turn) * spacing_);
}

double ConchoidSteps::place(double phi) const {
  if (phi <= 0.5 * kPi) return north_.area(haversine(phi)) / step_;
  return last_ - south_.area(haversine(kPi - phi)) / step_;
}

ConchoidSteps::Seen ConchoidSteps::seen(double t) const {
  if (t <= north_places_) return {false, north_.y_at_area(t * step_)};
  return {true, south_.y_at_area((last_ - t) * step_)};
}

double ConchoidSteps::polar_angle(double t) const {
  const auto [south, y] = seen(t);
  const double from_pole = 2.0 * std::asin(std::sqrt(y));
  return south ? kPi - from_pole : from_pole;
}

Vec3 ConchoidSteps::direction(std::size_t entry) const {
  const auto [south, y] = seen(static_cast<double>(entry));
  const double from_pole = 2.0 * std::asin(std::sqrt(y));
  const double turned = (south ? south_ : north_).length(from_pole) / spacing_;
  const double end = turns() - std::floor(turns());
  return spiral_point(y, south, south ? end - turned : turned);
}

template double spiral_covering_radius(const ConchoidSteps&);
template double spiral_stencil_radius(const ConchoidSteps&);

}  // namespace impinge
