// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/conchoid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "curves/gsl.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

double clamped(double value, double total, const char* what) {
  if (!(value >= -kCurveRounding * total && value <= (1.0 + kCurveRounding) * total)) {
    throw std::invalid_argument(std::string(what) + " of a conchoid is between 0 and that of the whole");
  }
  return std::clamp(value, 0.0, total);
}

double square(double x) { return x * x; }

}  // namespace

void require_shape(const ConchoidShape& shape) {
  if (!(std::isfinite(shape.a) && std::isfinite(shape.b) && shape.a > 0.0 && shape.b >= 0.0)) {
    throw std::invalid_argument(
        "a conchoid r = a + b cos(phi) has a finite a above 0 and a finite b not below 0");
  }
  if (shape.a < shape.b) {
    throw std::invalid_argument(
        "the conchoid r = a + b cos(phi) with a < b has a loop, where a direction meets it twice: "
        "choose a >= b");
  }
}

void require_on_conchoid(const ConchoidShape& shape, double phi) {
  require_shape(shape);
  if (!(phi >= 0.0 && phi <= kPi)) {
    throw std::invalid_argument("a polar angle of a conchoid is in [0, pi] radians");
  }
}

double conchoid_radius(const ConchoidShape& shape, double phi) {
  require_on_conchoid(shape, phi);
  // a + b cos phi, without cancellation where both terms are nearly the same
  return (shape.a - shape.b) + 2.0 * shape.b * square(std::cos(0.5 * phi));
}

double conchoid_height(const ConchoidShape& shape, double phi) {
  return conchoid_radius(shape, phi) * std::cos(phi);
}

double conchoid_width(const ConchoidShape& shape, double phi) {
  return conchoid_radius(shape, phi) * std::sin(phi);
}

double conchoid_speed(const ConchoidShape& shape, double phi) {
  require_on_conchoid(shape, phi);
  return std::hypot(shape.a - shape.b, 2.0 * std::sqrt(shape.a * shape.b) * std::cos(0.5 * phi));
}

double meridian_length(const ConchoidShape& shape, double phi) {
  require_on_conchoid(shape, phi);
  if (shape.a == shape.b) return 4.0 * shape.a * std::sin(0.5 * phi);
  const double sum = shape.a + shape.b;
  return 2.0 * sum * arc_of_falling_speed(0.5 * phi, square((shape.a - shape.b) / sum));
}

double polar_angle_at_meridian_length(const ConchoidShape& shape, double length) {
  const double total = meridian_length(shape, kPi);
  const double wanted = clamped(length, total, "a length along the meridian");
  return find_root([&](double phi) { return meridian_length(shape, phi) - wanted; }, 0.0, kPi);
}

double cap_area(const ConchoidShape& shape, double phi) {
  const double v = conchoid_speed(shape, phi);
  const double v0 = shape.a + shape.b;
  const double fifth = square(v0) * (square(v0) + v0 * v + v * v) + square(v) * (v0 * v + v * v);
  const double third = v0 * v0 + v0 * v + v * v;
  const double loop_free = (shape.a - shape.b) * v0;  // a^2 - b^2
  return 2.0 * kPi / shape.a * square(std::sin(0.5 * phi)) / (v0 + v) *
         (0.4 * fifth + 2.0 / 3.0 * loop_free * third);
}

double polar_angle_at_cap_area(const ConchoidShape& shape, double area) {
  const double total = cap_area(shape, kPi);
  const double wanted = clamped(area, total, "a cap's area");
  return find_root([&](double phi) { return cap_area(shape, phi) - wanted; }, 0.0, kPi);
}

double conchoid_incidence(const ConchoidShape& shape, double phi) {
  const double radius = conchoid_radius(shape, phi);
  if (shape.a == shape.b) return 0.5 * phi;  // tan(psi) = sin(phi) / (1 + cos(phi)); its limit at the cusp
  return std::atan2(shape.b * std::sin(phi), radius);
}

double area_per_solid_angle(const ConchoidShape& shape, double phi) {
  return conchoid_radius(shape, phi) * conchoid_speed(shape, phi);
}

}  // namespace impinge
