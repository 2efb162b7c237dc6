// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/conchoid_spacing.hpp"

#include <cmath>
#include <stdexcept>

#include "curves/conchoid_rays.hpp"
#include "curves/root.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

void require_inside(const ConchoidShape& shape, double height) {
  require_shape(shape);
  if (!(height >= 0.0 && height < shape.a + shape.b)) {
    throw std::invalid_argument(
        "rays at a conchoid start on its axis between the rim's plane and the apex: 0 <= height < a + b");
  }
}

}  // namespace

double ray_angle(const ConchoidShape& shape, double height, double phi) {
  require_inside(shape, height);
  return std::atan2(conchoid_width(shape, phi), conchoid_height(shape, phi) - height);
}

double spacing_rate(const ConchoidShape& shape, double height, double phi) {
  require_inside(shape, height);
  const double radius = conchoid_radius(shape, phi);
  const double slope = -shape.b * std::sin(phi);
  const double dx = slope * std::sin(phi) + radius * std::cos(phi);
  const double dz = slope * std::cos(phi) - radius * std::sin(phi);
  const double x = conchoid_width(shape, phi);
  const double z = conchoid_height(shape, phi) - height;
  return conchoid_speed(shape, phi) * (x * x + z * z) / (dx * z - dz * x);
}

std::vector<double> ray_cuts(const ConchoidShape& shape, double height, std::size_t rays) {
  const double end = ray_angle(shape, height, kConchoidRim);
  std::vector<double> cuts = original_angles(rays);
  for (std::size_t i = 1; i + 1 < rays; ++i) {
    const double wanted = end * cuts[i] / kConchoidRim;
    cuts[i] =
        find_root([&](double phi) { return ray_angle(shape, height, phi) - wanted; }, 0.0, kConchoidRim);
  }
  return cuts;
}

std::vector<double> segment_lengths(const ConchoidShape& shape, double height, std::size_t rays) {
  const std::vector<double> cuts = ray_cuts(shape, height, rays);
  std::vector<double> lengths;
  lengths.reserve(rays - 1);
  for (std::size_t i = 0; i + 1 < rays; ++i) {
    lengths.push_back(meridian_length(shape, cuts[i + 1]) - meridian_length(shape, cuts[i]));
  }
  return lengths;
}

}  // namespace impinge
