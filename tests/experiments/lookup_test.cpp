// SPDX-License-Identifier: GPL-3.0-or-later
// A look-up without a table answers, bit for bit, what the table would.
#include "04_sampling_error/lookup.hpp"

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/stored_table.hpp"
#include "support/every_scheme.hpp"
#include "table/probe_directions.hpp"

namespace impinge::lab {
namespace {

TEST(Lookup, SmoothIsThatOfTheTable) {
  const auto radius = [](const Vec3& u) { return ball_radius(u); };
  test::every_scheme([&]<class S>() {
    const S scheme = S::with_precision(3.0);
    RadialTable<S> table(scheme);
    for (std::size_t i = 0; i < scheme.size(); ++i) table.radii()[i] = radius(scheme.direction(i));
    for (const Vec3& u : uniform_directions(2000, 31)) {
      ASSERT_EQ(smooth_radius(scheme, u, [&](std::size_t i) { return radius(scheme.direction(i)); }),
                table.radius_at(u))
          << S::name;
    }
  });
}

TEST(Lookup, PlaneExactIsThatOfTheInverseDepthTable) {
  const auto radius = [](const Vec3& u) { return ball_radius(u); };
  std::size_t checked = 0;
  for_each_scheme([&]<class S>() {  // of which some are plane exact
    if constexpr (PlaneExactScheme<S>) {
      ++checked;
      const S scheme = S::with_precision(3.0);
      RadialTable<S> table(scheme);
      for (std::size_t i = 0; i < scheme.size(); ++i) table.radii()[i] = radius(scheme.direction(i));
      const InverseDepthTable<S> inverse(table);
      for (const Vec3& u : uniform_directions(2000, 32)) {
        const double found =
            plane_exact_radius(scheme, u, [&](std::size_t i) { return radius(scheme.direction(i)); });
        ASSERT_NEAR(found, inverse.radius_at(u), 1e-13) << S::name;
      }
    }
  });
  EXPECT_GT(checked, 0U);
}

}  // namespace
}  // namespace impinge::lab
