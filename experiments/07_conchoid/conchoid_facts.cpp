// SPDX-License-Identifier: GPL-3.0-or-later
#include "07_conchoid/conchoid_facts.hpp"

#include <cmath>

#include "curves/conchoid_origins.hpp"
#include "curves/conchoid_rays.hpp"
#include "sphere/direction.hpp"

namespace impinge::lab {
namespace {

constexpr int kSteps = 360;
}  // namespace

Result conchoid_curve(const ConchoidShape& shape) {
  Result result{"conchoid_curve", "What does the conchoid look like?", {}, {}, {}};
  result.table.columns = {{"phi_deg", "deg", "polar angle at the conchoid's origin, from the apex"},
                          {"radius_mm", "mm", "r = a + b cos(phi)"},
                          {"x_mm", "mm", "distance from the axis"},
                          {"z_mm", "mm", "along the axis"},
                          {"length_mm", "mm", "of the meridian from the apex, exact"},
                          {"closed_form_length_mm", "mm", "4 sqrt(a b) sin(phi / 2), the thesis' way"},
                          {"area_mm2", "mm^2", "of the surface from the apex"},
                          {"incidence_deg", "deg", "angle between ray and normal"}};
  for (int step = 0; step <= kSteps; ++step) {
    const double phi = kPi * step / kSteps;
    const double radius = conchoid_radius(shape, phi);
    result.table.add_row({phi / kDegree, radius, radius * std::sin(phi), radius * std::cos(phi),
                          meridian_length(shape, phi), closed_form_length(shape, phi), cap_area(shape, phi),
                          conchoid_incidence(shape, phi) / kDegree});
  }
  return result;
}

Result conchoid_cap(const ConchoidShape& shape) {
  Result result{"conchoid_shape",
                "How long, how large and how oblique is the cap, and how near to a sphere?",
                {},
                {},
                {}};
  result.table.columns = {
      {"a_mm", "mm", "of r = a + b cos(phi)"},
      {"b_mm", "mm", ""},
      {"a_over_b", "1", ""},
      {"quarter_over_b", "1", "length of the arc to 90 degrees in units of b, exact"},
      {"closed_form_quarter_over_b", "1", "the same by the closed form, unrounded"},
      {"area_mm2", "mm^2", "of the cap"},
      {"rim_incidence_deg", "deg", "angle between ray and normal at 90 degrees"},
      {"apex_mm2_per_sr", "mm^2/sr", "area per solid angle seen from the conchoid's origin"},
      {"rim_mm2_per_sr", "mm^2/sr", "the same at 90 degrees"},
      {"sphere_height_mm", "mm", "centre of the sphere that fits the cap best, on the axis"},
      {"sphere_radius_mm", "mm", "its radius"},
      {"sphere_lowest_mm", "mm", "distance of the cap from it: lowest"},
      {"sphere_highest_mm", "mm", "and highest"}};
  const AxialSphere sphere = fit_axial_sphere(shape);
  result.table.add_row({shape.a, shape.b, shape.a / shape.b, meridian_length(shape, kConchoidRim) / shape.b,
                        closed_form(shape).quarter, cap_area(shape, kConchoidRim),
                        conchoid_incidence(shape, kConchoidRim) / kDegree, area_per_solid_angle(shape, 0.0),
                        area_per_solid_angle(shape, kConchoidRim), sphere.height, sphere.radius,
                        sphere.lowest_residual, sphere.highest_residual});
  return result;
}

}  // namespace impinge::lab
