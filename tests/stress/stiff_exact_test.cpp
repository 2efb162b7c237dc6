// SPDX-License-Identifier: GPL-3.0-or-later
// Exact cells over the surfaces of the stiff and extreme families. Contract, at points that are floats: an
// answer exactly where the mesh has one, and
//   |gap - gap of the mesh| <= u (18 r + 8 |gap|)
// and what the plane of a face costs in double, 60 2^-53 (1 + tan psi) r
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "gap/simd/exact_cells.hpp"
#include "reference/exact_radius.hpp"
#include "stress/conditions.hpp"
#include "stress/measure.hpp"
#include "stress/stiff_surfaces.hpp"

namespace impinge::lab {
namespace {

using test::StiffSurface;

constexpr double kStiffUnit = 0x1p-24;
// Of what is allowed 0.19 was seen at most: no more than twice as much may be.
constexpr double kExactShare = 0.38;

std::vector<float> gaps_in(const ExactCells& cells, const std::vector<Vec3>& points, Surface scanned) {
  std::vector<float> gap(points.size());
  scan_gaps(cells, packed_vertices<float>(points), {}, scanned, gap);
  return gap;
}

class StiffExactCells : public testing::TestWithParam<test::StiffFamily> {};
INSTANTIATE_TEST_SUITE_P(Families, StiffExactCells, testing::ValuesIn(test::stiff_families()), test::name_of);

TEST_P(StiffExactCells, AnswerAsTheMesh) {
  const StiffSurface surface = GetParam().make();
  const auto points = test::stiff_points(surface);
  const auto truth = exact_radii(surface.mesh, {points, surface.layer, {}});
  for (const double cells_a_face : {4.0, 0.2}) {
    const ExactCells cells = exact_cells(surface.mesh, surface.layer, cells_a_face);
    const auto ball = gaps_in(cells, points, Surface::ball);
    const auto socket = gaps_in(cells, points, Surface::socket);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(std::isnan(ball[i]), std::isnan(truth[i])) << points[i].transpose();
      EXPECT_EQ(std::isnan(socket[i]), std::isnan(truth[i])) << points[i].transpose();
      if (std::isnan(truth[i]) || std::isnan(ball[i])) continue;
      const double gap = truth[i] - points[i].norm();
      const double off = std::fmax(std::abs(ball[i] - gap), std::abs(socket[i] + gap));
      const double rounding = kStiffUnit * (18.0 * truth[i] + 8.0 * std::abs(gap));
      if (off <= kExactShare * rounding) continue;
      const double steep = conditions_along(surface.mesh, {&points[i], 1})[0].condition();
      EXPECT_LE(off, kExactShare * (rounding + kRadiusThreshold * 0x1p-53 * steep * truth[i]))
          << points[i].transpose();
    }
  }
}

}  // namespace
}  // namespace impinge::lab
