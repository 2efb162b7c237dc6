// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How do rays sample the conchoid of the hip evenly? (Section 5.1, Table 10, Figures 52-59)
// @writes    conchoid_angles conchoid_spacing conchoid_origins conchoid_surface conchoid_curve conchoid_shape
// @timing    no
// @seconds   1 3
// @links     harness curves
//
// Menschik's conchoid of the acetabulum, from its apex to its rim at 90 degrees.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "curves/conchoid.hpp"
#include "curves/conchoid_rays.hpp"
#include "curves/conchoid_surface.hpp"
#include "harness/driver.hpp"
#include "harness/provenance.hpp"
#include "sphere/direction.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr int kSteps = 360;

// conchoid_curve.csv: the meridian from apex to phi = 180 degrees, one row per half degree.
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

// conchoid_shape.csv: one row of lengths, areas and angles of the cap from the apex to the rim at 90 degrees.
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

constexpr std::size_t kPlaces = 901;  // places on the arc at which the extreme rates are sought

// conchoid_spacing.csv: every segment, for each origin and number of rays.
Result conchoid_segments(const ConchoidShape& shape, std::span<const std::size_t> ray_counts) {
  Result result{"conchoid_spacing", "How long are the segments between rays at equal angles?", {}, {}, {}};
  result.table.columns = {{"origin", "", "of the rays"},
                          {"height_mm", "mm", "of the origin on the axis"},
                          {"rays", "1", "from the apex to the rim"},
                          {"segment", "1", "from the apex on"},
                          {"phi_from_deg", "deg", "at the conchoid's origin"},
                          {"phi_to_deg", "deg", ""},
                          {"length_mm", "mm", "along the arc"}};
  for (const SamplingOrigin& at : sampling_origins(shape)) {
    for (const std::size_t rays : ray_counts) {
      const auto cuts = ray_cuts(shape, at.height, rays);
      const auto lengths = segment_lengths(shape, at.height, rays);
      for (std::size_t i = 0; i < lengths.size(); ++i) {
        result.table.add_row(
            {at.name, at.height, rays, i, cuts[i] / kDegree, cuts[i + 1] / kDegree, lengths[i]});
      }
    }
  }
  return result;
}

// conchoid_origins.csv: the limit of the segments for many rays, arc per angle, for each origin.
Result conchoid_origins(const ConchoidShape& shape) {
  Result result{"conchoid_origins", "How uneven are the segments of many rays from each origin?", {}, {}, {}};
  result.table.columns = {{"origin", "", "of the rays"},
                          {"height_mm", "mm", "of the origin on the axis"},
                          {"last_ray_deg", "deg", "angle of the ray through the rim"},
                          {"apex_mm_per_deg", "mm/deg", "arc per angle of ray at the apex"},
                          {"middle_mm_per_deg", "mm/deg", "at the ray halfway to the rim"},
                          {"rim_mm_per_deg", "mm/deg", "at the rim"},
                          {"smallest_mm_per_deg", "mm/deg", "of many places"},
                          {"largest_mm_per_deg", "mm/deg", "of many places"}};
  for (const SamplingOrigin& at : sampling_origins(shape)) {
    const auto rate = [&](double phi) { return spacing_rate(shape, at.height, phi) * kDegree; };
    std::vector<double> rates;
    for (const double phi : original_angles(kPlaces)) rates.push_back(rate(phi));
    const auto [smallest, largest] = std::ranges::minmax(rates);
    result.table.add_row({at.name, at.height, ray_angle(shape, at.height, kConchoidRim) / kDegree,
                          rates.front(), rate(ray_cuts(shape, at.height, 3)[1]), rates.back(), smallest,
                          largest});
  }
  return result;
}

const ConchoidShape kShape;                                 // mm, Menschik 1997
constexpr std::array<std::size_t, 3> kRays{4, 91, 901};     // Table 10, Section 5.1.2, Figures 58-59
constexpr std::array<std::size_t, 2> kSegmentRays{11, 91};  // drawn in Figure 53, and at 1 degree
constexpr std::size_t kRings = 31;                          // 3 degrees apart, apex and rim included
constexpr std::size_t kPerRing = 120;
constexpr std::size_t kPieces = 400;  // pieces of surface per point
constexpr std::size_t kBands = 9;     // bands of 10 degrees

Result angles() {
  Result result{"conchoid_angles", "By how much is each sampling ray turned?", {}, {}, {}};
  result.table.columns = {{"rays", "1", "from 0 to 90 degrees"},
                          {"i", "1", "index of the ray"},
                          {"original_deg", "deg", "equal angles"},
                          {"thesis_deg", "deg", "Eq. 16 with 3.03 and 4.29"},
                          {"closed_form_deg", "deg", "Eq. 16 unrounded"},
                          {"exact_deg", "deg", "equal lengths of the arc, by the elliptic integral"}};
  for (const std::size_t rays : kRays) {
    const auto original = original_angles(rays);
    const auto thesis = adjusted_angles(thesis_closed_form(), rays);
    const auto closed = adjusted_angles(closed_form(kShape), rays);
    const auto exact = equal_arc_angles(kShape, rays);
    for (std::size_t i = 0; i < rays; ++i) {
      result.table.add_row(
          {rays, i, original[i] / kDegree, thesis[i] / kDegree, closed[i] / kDegree, exact[i] / kDegree});
    }
  }
  return result;
}

void add_bands(Table& table, const char* name, const std::vector<Vec3>& points) {
  for (const AreaBand& band : area_bands(kShape, points, {kPieces, kBands})) {
    table.add_row({name, points.size(), band.from_deg, band.to_deg, band.points, band.smallest, band.mean,
                   band.largest});
  }
}

Result surface() {
  Result result{
      "conchoid_surface", "How much of the rotated conchoid does each sample point stand for?", {}, {}, {}};
  result.table.columns = {{"sampling", "", "rings at equal theta, or the equal-area spiral"},
                          {"points", "1", "on the cap"},
                          {"phi_from_deg", "deg", "of the band"},
                          {"phi_to_deg", "deg", ""},
                          {"points_in_band", "1", "whose area the rim does not cut"},
                          {"smallest_mm2", "mm^2", "area nearer to a point than to others"},
                          {"mean_mm2", "mm^2", ""},
                          {"largest_mm2", "mm^2", ""}};
  const auto rings = [](const std::vector<double>& phi) { return conchoid_rings(kShape, phi, kPerRing); };
  add_bands(result.table, "equal_angle_rings", rings(original_angles(kRings)));
  add_bands(result.table, "thesis_rings", rings(adjusted_angles(thesis_closed_form(), kRings)));
  add_bands(result.table, "equal_arc_rings", rings(equal_arc_angles(kShape, kRings)));
  add_bands(result.table, "equal_area_spiral", conchoid_spiral(kShape, kRings * kPerRing));
  return result;
}

void body(DriverRun& run) {
  for (Result result : {angles(), conchoid_segments(kShape, kSegmentRays), conchoid_origins(kShape),
                        surface(), conchoid_curve(kShape), conchoid_cap(kShape)}) {
    result.parameters = {{"a_mm", kShape.a}, {"b_mm", kShape.b}, {"pieces_a_point", kPieces}};
    run.write(result);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"07_conchoid", "Weighted sampling of the conchoid (Table 10, Figures 52-59)."}, body);
}
