// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/conchoid_rays.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "curves/gsl.hpp"
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

void require_inside(const ConchoidShape& shape, double height) {
  require_shape(shape);
  if (!(height >= 0.0 && height < shape.a + shape.b)) {
    throw std::invalid_argument(
        "rays at a conchoid start on its axis between the rim's plane and the apex: 0 <= height < a + b");
  }
}

constexpr int kResidualSteps = 9000;  // steps over the cap when its extreme residuals are sought

double distance(const ConchoidShape& shape, double height, double phi) {
  return std::hypot(conchoid_width(shape, phi), conchoid_height(shape, phi) - height);
}

// Means of f over the curve and over the surface, from the apex to `end`.
double curve_mean(const ConchoidShape& shape, double end, const std::function<double(double)>& f) {
  return integrate([&](double phi) { return f(phi) * conchoid_speed(shape, phi); }, 0.0, end) /
         meridian_length(shape, end);
}
double surface_mean(const ConchoidShape& shape, double end, const std::function<double(double)>& f) {
  const auto strip = [&](double phi) {
    return 2.0 * kPi * f(phi) * conchoid_width(shape, phi) * conchoid_speed(shape, phi);
  };
  return integrate(strip, 0.0, end) / cap_area(shape, end);
}

double curve_centroid(const ConchoidShape& shape, double end) {
  return curve_mean(shape, end, [&](double phi) { return conchoid_height(shape, phi); });
}
double surface_centroid(const ConchoidShape& shape, double end) {
  return surface_mean(shape, end, [&](double phi) { return conchoid_height(shape, phi); });
}

// Mean distance of the cap's surface from a point of the axis.
double mean_distance(const ConchoidShape& shape, double height) {
  return surface_mean(shape, kConchoidRim, [&](double phi) { return distance(shape, height, phi); });
}

// Height of the lowest point of the whole curve: where a + 2 b cos(phi) = 0, or at phi = pi.
double lowest_point(const ConchoidShape& shape) {
  return shape.a < 2.0 * shape.b ? -shape.a * shape.a / (4.0 * shape.b) : shape.b - shape.a;
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

std::vector<SamplingOrigin> sampling_origins(const ConchoidShape& shape) {
  require_shape(shape);
  const double apex = shape.a + shape.b;
  std::vector<SamplingOrigin> origins{{"conchoid_origin", 0.0},
                                      {"cap_extent_middle", 0.5 * apex},
                                      {"cap_curve_centroid", curve_centroid(shape, kConchoidRim)},
                                      {"cap_surface_centroid", surface_centroid(shape, kConchoidRim)},
                                      {"cap_best_sphere", fit_axial_sphere(shape).height},
                                      {"whole_axis_middle", shape.b},
                                      {"whole_extent_middle", 0.5 * (apex + lowest_point(shape))},
                                      {"whole_curve_centroid", curve_centroid(shape, kPi)},
                                      {"whole_surface_centroid", surface_centroid(shape, kPi)}};
  const double rounding = 1e-12 * apex;  // the centre of a circle is in the plane of the rim
  std::erase_if(origins,
                [&](const SamplingOrigin& at) { return at.height < -rounding || at.height >= apex; });
  for (SamplingOrigin& at : origins) at.height = std::max(at.height, 0.0);
  return origins;
}

// About a given centre the best radius is the mean distance d. The mean of (d - mean d)^2 is stationary in
// the height where mean(d d') = mean(d) mean(d'); d d' is height - z.
AxialSphere fit_axial_sphere(const ConchoidShape& shape) {
  const double centroid = surface_centroid(shape, kConchoidRim);
  const auto slope = [&](double height) {
    const double pull = surface_mean(shape, kConchoidRim, [&](double phi) {
      return (height - conchoid_height(shape, phi)) / distance(shape, height, phi);
    });
    return height - centroid - mean_distance(shape, height) * pull;
  };
  const double apex = shape.a + shape.b;
  AxialSphere sphere;
  sphere.height = find_root(slope, -0.5 * apex, 0.9 * apex);
  sphere.radius = mean_distance(shape, sphere.height);
  for (int i = 0; i <= kResidualSteps; ++i) {
    const double residual = distance(shape, sphere.height, kConchoidRim * i / kResidualSteps) - sphere.radius;
    sphere.lowest_residual = std::min(sphere.lowest_residual, residual);
    sphere.highest_residual = std::max(sphere.highest_residual, residual);
  }
  return sphere;
}

}  // namespace impinge
