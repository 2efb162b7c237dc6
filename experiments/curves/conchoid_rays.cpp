// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/conchoid_rays.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "curves/rounding.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

constexpr double kQuarter = 0.5 * kPi;
// angle(i / (rays - 1)) of each ray.
template <class Angle>
std::vector<double> fan(std::size_t rays, Angle&& angle) {
  if (rays < 2) {
    throw std::invalid_argument("sampling rays cut a conchoid into parts: there must be at least two");
  }
  std::vector<double> angles(rays);
  for (std::size_t i = 0; i < rays; ++i) {
    angles[i] = angle(static_cast<double>(i) / static_cast<double>(rays - 1));
  }
  return angles;
}

}  // namespace

ConchoidClosedForm thesis_closed_form() { return {}; }

ConchoidClosedForm closed_form(const ConchoidShape& shape) {
  require_shape(shape);
  if (shape.b == 0.0) {
    throw std::invalid_argument("the closed form of a conchoid's length counts in b, which must not be 0");
  }
  const double factor = 4.0 * std::sqrt(shape.a / shape.b);
  return {factor, factor * std::sqrt(0.5)};
}

double closed_form_length(const ConchoidShape& shape, double phi) {
  require_on_conchoid(shape, phi);
  return 4.0 * std::sqrt(shape.a * shape.b) * std::sin(0.5 * phi);
}

std::vector<double> original_angles(std::size_t rays) {
  return fan(rays, [](double share) { return share * kQuarter; });
}

std::vector<double> adjusted_angles(const ConchoidClosedForm& form, std::size_t rays) {
  const double ratio = form.quarter / form.factor;
  if (!(form.factor > 0.0 && form.quarter > 0.0 && ratio <= 1.0 + kCurveRounding)) {
    throw std::invalid_argument(
        "a closed form of a conchoid's length is positive, its quarter at most its factor");
  }
  return fan(rays, [ratio](double share) { return 2.0 * std::asin(std::min(share * ratio, 1.0)); });
}

std::vector<double> equal_arc_angles(const ConchoidShape& shape, std::size_t rays) {
  const double quarter = meridian_length(shape, kQuarter);
  std::vector<double> angles =
      fan(rays, [&](double share) { return polar_angle_at_meridian_length(shape, share * quarter); });
  angles.back() = kQuarter;
  return angles;
}

}  // namespace impinge
