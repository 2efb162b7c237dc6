// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/arc_steps.hpp"

#include "sphere/haversine.hpp"
#include "sphere/spiral_radii.hpp"
#include "sphere/turn_angle.hpp"

namespace impinge {

ArcSteps::ArcSteps(std::size_t size, std::size_t turns)
    : last_(static_cast<double>(size - 1)),
      turns_(static_cast<double>(turns)),
      spacing_(kPi / turns_),
      northern_(1.0 + 4.0 * turns_ * turns_, 0.5 * kPi),
      step_(2.0 * northern_.length() / last_) {}

double ArcSteps::place(double phi) const {
  const bool south = phi > 0.5 * kPi;
  const double from_pole = northern_.length(south ? kPi - phi : phi) / step_;
  return south ? last_ - from_pole : from_pole;
}

double ArcSteps::polar_angle(double t) const {
  const bool south = t > 0.5 * last_;
  const double from_pole = northern_.angle((south ? last_ - t : t) * step_);
  return south ? kPi - from_pole : from_pole;
}

// As the number of turns is whole, the southern half is the northern one turned over.
Vec3 ArcSteps::direction(std::size_t entry) const {
  const auto i = static_cast<double>(entry);
  const bool south = i > 0.5 * last_;
  const double from_pole = northern_.angle((south ? last_ - i : i) * step_);
  const double turns = turn(from_pole);
  return spiral_point(haversine(from_pole), south, south ? -turns : turns);
}

template double spiral_covering_radius(const ArcSteps&);
template double spiral_stencil_radius(const ArcSteps&);

}  // namespace impinge
