// SPDX-License-Identifier: GPL-3.0-or-later
// A sliver answers as any face in its plane does, in every way of asking: |r - truth| <= 60 u (1 + tan psi)
// truth, and no more than twice the 3.2 u that were seen.
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "reference/exact_radius.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/stored_table.hpp"
#include "stress/aimed_faces.hpp"
#include "stress/conditions.hpp"
#include "stress/measure.hpp"
#include "stress/shapes.hpp"
#include "table/exact_raster.hpp"
#include "table/near_faces.hpp"
#include "table/pairwise.hpp"
#include "table/partial_table.hpp"
#include "table/surface_index.hpp"

namespace impinge::lab {
namespace {

constexpr double kMost = 6.4;
static_assert(kMost < kRadiusThreshold);

// A sliver at every 20th entry of a small table.
struct Slivers {
  explicit Slivers(double aspect) : scheme(CubeGnomonic::with_precision(10.0)) {
    mesh = backdrop();
    for (std::size_t i = 7; i < scheme.size(); i += 20) {
      entries.push_back(i);
      aims.push_back(scheme.direction(i));
      append(mesh, aimed_sliver(aims.back(), aspect));
    }
    truth = exact_radii(mesh, {aims, Layer::nearest, {}});
    condition = conditions_along(mesh, aims);
  }

  // Largest error over condition and unit roundoff.
  template <class Radius>
  double largest_error(Radius&& radius_of) const {
    double largest = 0.0;
    for (std::size_t k = 0; k < aims.size(); ++k) {
      const double off = std::abs(radius_of(k) - truth[k]) / truth[k];
      largest = std::fmax(largest, std::isnan(off) ? 1e300 : off / condition[k].condition() / 0x1p-53);
    }
    return largest;
  }

  CubeGnomonic scheme;
  TriangleMesh mesh;
  std::vector<std::size_t> entries;
  std::vector<Vec3> aims;
  std::vector<double> truth;
  std::vector<RayCondition> condition;
};

class SliverAspects : public testing::TestWithParam<double> {};

TEST_P(SliverAspects, AnswerAsAnyFaceInItsPlane) {
  const Slivers slivers(GetParam());
  const TriangleMesh& mesh = slivers.mesh;
  ASSERT_GT(slivers.aims.size(), 20U);
  const auto expect_right = [&](const char* way, auto&& radius_of) {
    EXPECT_LT(slivers.largest_error(radius_of), kMost) << way;
  };
  const RayCaster caster(mesh);
  expect_right("pairwise", [&](std::size_t k) { return caster.cast(slivers.aims[k], Layer::nearest); });
  const RadialTable<CubeGnomonic> table = fill_exact(mesh, slivers.scheme, Layer::nearest);
  expect_right("table", [&](std::size_t k) { return table.radius_of(slivers.entries[k]); });
  const InverseDepthTable<CubeGnomonic> inverse(table);
  expect_right("inverse depths", [&](std::size_t k) {
    const double depth = slivers.scheme.depth(slivers.aims[k]);
    return 1.0 / (inverse.values()[slivers.entries[k]] * depth);
  });
  const SurfaceIndex index(mesh, Layer::nearest, 0.1);
  expect_right("surface index", [&](std::size_t k) { return index.radius(slivers.aims[k]); });
  const NearFaces near(mesh, 0.1);
  expect_right("near faces", [&](std::size_t k) { return near.radius(slivers.aims[k], Layer::nearest); });
  EntrySet set(slivers.scheme.size());
  for (const std::size_t entry : slivers.entries) set.insert(entry);
  set.number();
  const PartialTable partial =
      fill_partial(near, AnyScheme("cube_gnomonic", 10.0), std::move(set), Layer::nearest);
  expect_right("partial table", [&](std::size_t k) { return partial.radius_of(slivers.entries[k]); });
}

INSTANTIATE_TEST_SUITE_P(Sliver, SliverAspects, testing::Values(1.0, 1e-1, 1e-4, 1e-8, 1e-11, 1e-14));

}  // namespace
}  // namespace impinge::lab
