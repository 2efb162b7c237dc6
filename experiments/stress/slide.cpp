// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/slide.hpp"

#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

namespace impinge::lab {

Vec3 Slide::vertex(double angle) const {
  return along + std::cos(angle) * aside + std::sin(angle) * axis.cross(aside);
}

Slide slide_touching_at(double contact, double octahedron_radius) {
  const Vec3 normal = Vec3(1.0, 1.0, 1.0).normalized();
  const Vec3 across = Vec3(0.3, -0.7, 0.4).normalized();  // perpendicular to the normal
  Slide slide;
  slide.axis = std::cos(60.0 * kDegree) * normal + std::sin(60.0 * kDegree) * across;
  const Vec3 towards = (normal - normal.dot(slide.axis) * slide.axis).normalized();
  slide.along = std::cos(40.0 * kDegree) * slide.axis;
  slide.aside = std::sin(40.0 * kDegree) * towards;
  const double length = octahedron_radius / slide.vertex(contact).lpNorm<1>();
  slide.along *= length;
  slide.aside *= length;
  return slide;
}

PreciseSlide::PreciseSlide(const Slide& slide, double octahedron_radius) : radius_(octahedron_radius) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto j = static_cast<Eigen::Index>((i + 1) % 3);
    const auto k = static_cast<Eigen::Index>((i + 2) % 3);
    along_[i] = slide.along[static_cast<Eigen::Index>(i)];
    aside_[i] = slide.aside[static_cast<Eigen::Index>(i)];
    ahead_[i] = Precise(slide.axis[j]) * slide.aside[k] - Precise(slide.axis[k]) * slide.aside[j];
  }
}

// In the octant of the face its plane is |x|_1 = R, so the gap is R |x| / |x|_1 - |x|.
Precise PreciseSlide::gap(const Precise& angle) const {
  Precise sum = 0;
  Precise square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Precise x = along_[i] + cos(angle) * aside_[i] + sin(angle) * ahead_[i];
    sum += x;
    square += x * x;
  }
  return sqrt(square) * (radius_ / sum - 1);
}

// A + B cos(angle) + C sin(angle) = R
Precise PreciseSlide::contact() const {
  const Precise a = along_[0] + along_[1] + along_[2];
  const Precise b = aside_[0] + aside_[1] + aside_[2];
  const Precise c = ahead_[0] + ahead_[1] + ahead_[2];
  return atan2(c, b) - acos((radius_ - a) / sqrt(b * b + c * c));
}

std::optional<double> touching_angle(const PointQuery& query, const Slide& slide, double start) {
  const auto touches = [&](double angle) {
    const std::array point{slide.vertex(angle)};
    std::array<double, 1> radius{};
    query.answer(point, radius);
    return radius[0] - point[0].norm() <= 0.0;
  };
  double free = start;
  double touching = 0.0;
  if (touches(free) || !touches(touching)) return std::nullopt;
  while (true) {
    const double middle = 0.5 * (free + touching);
    if (middle == free || middle == touching) return touching;
    (touches(middle) ? touching : free) = middle;
  }
}

}  // namespace impinge::lab
