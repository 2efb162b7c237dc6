// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels that read tables, over the surfaces of the stiff and extreme families. Contract, at points that
// are floats:
//   |gap of the kernel - gap of the scalar look-up| <= what the kernel's header derives
//   |gap of the kernel - gap of the mesh|           <= that, storage and the proven bound of the table
// with an answer where the scalar look-up has one, and nowhere where the mesh has none, but within rounding
// of a grid line
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "reference/exact_radius.hpp"
#include "stress/stiff_surfaces.hpp"
#include "stress/table_kernels.hpp"
#include "table/packed_fixture.hpp"

namespace impinge::lab {
namespace {

using test::StiffSurface;
using test::TableKernel;

// What was met on the way, so that no test is empty.
struct Met {
  std::size_t answered = 0;
  std::size_t none = 0;
  std::size_t otherwise = 0;  // on a grid line
};

// Within rounding of x, is there an answer of the scalar look-up, or none, as the kernel says?
bool said_close_by(const TableKernel& kernel, const Vec3& x, bool none) {
  return std::ranges::any_of(test::close_to(x, 64.0 * kernel.unit()),
                             [&](const Vec3& near) { return std::isnan(kernel.radius_at(near)) == none; });
}

bool met_close_by(const StiffSurface& surface, const Vec3& x, double unit) {
  const auto near = test::close_to(x, 64.0 * unit);
  const auto radii = exact_radii(surface.mesh, {near, surface.layer, {}});
  return std::ranges::any_of(radii, [](double r) { return !std::isnan(r); });
}

struct Held {
  const StiffSurface& surface;
  const TableKernel& kernel;
  const std::vector<Vec3>& points;
  const std::vector<double>& truth;  // radius of the mesh
};

void expect_held(const Held& held, Surface scanned, Met& met) {
  const TableKernel& kernel = held.kernel;
  const double bound = kernel.bound();
  const double sign = scanned == Surface::ball ? 1.0 : -1.0;
  const auto gap = kernel.gaps(held.points, {}, scanned);
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const Vec3& x = held.points[i];
    const double radius = kernel.radius_at(x);
    ++(std::isnan(gap[i]) ? met.none : met.answered);
    if (std::isnan(gap[i]) != std::isnan(radius)) {
      ++met.otherwise;
      EXPECT_TRUE(said_close_by(kernel, x, std::isnan(gap[i]))) << x.transpose();
    }
    if (std::isnan(gap[i]) || std::isnan(radius)) continue;
    const double off = std::abs(gap[i] - sign * (radius - x.norm()));
    const bool close = off <= 20.0 * kernel.unit() * (radius + x.norm());  // whatever the steps of the table
    const double rounding = close ? off : kernel.rounding(x, radius);
    EXPECT_LE(off, rounding) << x.transpose();
    if (std::isnan(held.truth[i])) {
      EXPECT_TRUE(met_close_by(held.surface, x, kernel.unit())) << x.transpose();
      continue;
    }
    EXPECT_LE(std::abs(gap[i] - sign * (held.truth[i] - x.norm())), bound + rounding) << x.transpose();
  }
}

class StiffTables : public testing::TestWithParam<test::StiffFamily> {};
INSTANTIATE_TEST_SUITE_P(Families, StiffTables, testing::ValuesIn(test::stiff_families()), test::name_of);

TEST_P(StiffTables, AnswerAsTheScalarLookUpAndWithinTheProvenBound) {
  const StiffSurface surface = GetParam().make();
  const auto points = test::stiff_points(surface);
  const auto truth = exact_radii(surface.mesh, {points, surface.layer, {}});
  Met met;
  Surface scanned = Surface::ball;
  for (const auto& kernel : test::table_kernels(surface.mesh, surface.layer, test::kStiffPrecision, true)) {
    SCOPED_TRACE(kernel->name());
    expect_held({surface, *kernel, points, truth}, scanned, met);
    scanned = other(scanned);
  }
  EXPECT_GT(met.answered, 0U);
  EXPECT_LT(met.otherwise, (met.answered + met.none) / 20);
}

}  // namespace
}  // namespace impinge::lab
