// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/conchoid_origins.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "curves/quadrature.hpp"
#include "curves/root.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

constexpr int kResidualSteps = 9000;  // over the cap, to find its extreme residuals

double distance(const ConchoidShape& shape, double height, double phi) {
  return std::hypot(conchoid_width(shape, phi), conchoid_height(shape, phi) - height);
}

// Means over the curve and over the surface from the apex to end.
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

// Height at which the whole curve is lowest: where a + 2 b cos(phi) = 0, or at phi = pi.
double lowest_point(const ConchoidShape& shape) {
  return shape.a < 2.0 * shape.b ? -shape.a * shape.a / (4.0 * shape.b) : shape.b - shape.a;
}

}  // namespace

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

// The radius that fits best about a centre is the mean distance d from it. The mean of (d - mean d)^2 is then
// stationary in the height where mean(d d') = mean(d) mean(d'); d d' is height - z.
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
