// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How do rays sample the conchoid of the hip evenly? (Section 5.1, Table 10, Figures 52-59)
// @writes    conchoid_angles conchoid_spacing conchoid_origins conchoid_surface conchoid_curve conchoid_shape
// @timing    no
// @seconds   1 3
// @links     harness curves
//
// Menschik's conchoid of the acetabulum, from its apex to its rim at 90 degrees.

#include <array>
#include <vector>

#include "07_conchoid/conchoid_facts.hpp"
#include "07_conchoid/conchoid_segments.hpp"
#include "curves/conchoid_rays.hpp"
#include "curves/conchoid_surface.hpp"
#include "harness/driver.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

const ConchoidShape kShape;                                 // mm, Menschik 1997
constexpr std::array<std::size_t, 3> kRays{4, 91, 901};     // Table 10, Section 5.1.2, Figures 58-59
constexpr std::array<std::size_t, 2> kSegmentRays{11, 91};  // drawn in Figure 53, and at 1 degree
constexpr std::size_t kRings = 31;                          // 3 degrees apart, apex and rim included
constexpr std::size_t kPerRing = 120;
constexpr std::size_t kPieces = 400;  // of surface a point
constexpr std::size_t kBands = 9;     // of 10 degrees

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
